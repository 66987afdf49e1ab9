"""The study of the supervisor: is what physics does what the model foresees?

Episodes of a random policy that draws from the choice set of a mode. The task itself
holds every event against the automaton; the study looks besides for forbidden states,
and counts what happened, so that one can see how much of the model was put to the test.
"""

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass, replace
from functools import partial
from typing import NamedTuple

import numpy as np

from prospect_mj.actions.action import Action
from prospect_mj.errors import UnforeseenEvent
from prospect_mj.experiment.studies.shares import in_parallel
from prospect_mj.supervisor.constraints import violated
from prospect_mj.supervisor.plant import End, Start
from prospect_mj.supervisor.predicates import PredicateState
from prospect_mj.supervisor.supervisor import Mode
from prospect_mj.task.pick_place import PickPlaceTask, TaskSettings
from prospect_mj.task.presentation import ORIENTATIONS


class Step(NamedTuple):
    """One action of an episode, run or refused."""

    before: PredicateState
    action: str
    result: str
    after: PredicateState

    def __str__(self) -> str:
        """Such as `left holds ...: insert-left: jammed -> left holds ...`."""
        after = "the same" if self.after == self.before else self.after
        return f"{self.before}: {self.action}: {self.result} -> {after}"


@dataclass(frozen=True)
class WatchedEpisode:
    """One episode, as the monitor followed it."""

    seed: int
    mode: Mode
    steps: tuple[Step, ...]
    """Up to the end, or to an event that was not foreseen."""
    word: tuple[Start | End, ...]
    """The same as the automaton's events, from the first look on."""
    forbidden: tuple[PredicateState, ...]
    """Forbidden states seen between its actions; there should be none."""
    unforeseen: str | None
    """What the model did not foresee; None = it accepted every event."""
    inserted: bool


def run_watched(
    settings: TaskSettings, seeds: Iterable[int], max_actions: int = 10
) -> list[WatchedEpisode]:
    """Episodes of actions drawn uniformly from the choice set."""
    episodes = []
    with PickPlaceTask(settings) as task:
        for seed in seeds:
            rng = np.random.default_rng(seed)
            task.reset(ORIENTATIONS[int(rng.integers(2))], rng)
            episodes.append(_episode(task, seed, rng, max_actions))
    return episodes


def _episode(
    task: PickPlaceTask, seed: int, rng: np.random.Generator, max_actions: int
) -> WatchedEpisode:
    steps: list[Step] = []
    unforeseen = None
    while len(steps) < max_actions and not task.inserted:
        before = task.predicates
        offered = np.flatnonzero(task.supervisor.choice_set(before))
        action = Action(int(rng.choice(offered)))
        try:
            outcome = task.execute(action)
        except UnforeseenEvent as error:
            unforeseen = str(error)
            break
        steps.append(Step(before, action.label, outcome.result, task.predicates))
    return WatchedEpisode(
        seed,
        task.supervisor.mode,
        tuple(steps),
        tuple(task.monitor.word),
        tuple(step.after for step in steps if violated(step.after)),
        unforeseen,
        task.inserted,
    )


def watched_in_parallel(
    settings: TaskSettings, mode: Mode, n: int, jobs: int = 2, first_seed: int = 0
) -> list[WatchedEpisode]:
    """`run_watched` in a mode, over `n` seeds on several processes."""
    study = partial(run_watched, replace(settings, supervisor=mode))
    return in_parallel(study, range(first_seed, first_seed + n), jobs)


def table(episodes: Iterable[WatchedEpisode]) -> str:
    """How often each outcome of each action was seen in each state."""
    counts = Counter(str(step) for episode in episodes for step in episode.steps)
    return "\n".join(f"{count:6d}  {step}" for step, count in counts.most_common())
