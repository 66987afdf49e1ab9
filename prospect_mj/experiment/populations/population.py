"""Many runs of a learner on recorded physics, by its compiled twin."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import NamedTuple, Self, TypeVar

import numpy as np
from joblib import Parallel, delayed
from numpy.typing import NDArray

from prospect_mj.agent import Learner
from prospect_mj.checks import check_integer
from prospect_mj.experiment.populations.compiled_learner import Walked, run_trials
from prospect_mj.experiment.populations.kernels.graph import Graph, Outcomes, Trials
from prospect_mj.experiment.populations.programme import Programme, Run
from prospect_mj.experiment.populations.recorded_world import RecordedWorld
from prospect_mj.experiment.populations.scenario import (
    PopulationSettings,
    Scenario,
)
from prospect_mj.experiment.populations.strategies import classify, first_hand
from prospect_mj.experiment.run.records import ACTION_NAMES
from prospect_mj.recording.recording import Recording

MOST_JOBS = 1024
"""Threads that may be asked for."""

Looked = TypeVar("Looked")


@dataclass(frozen=True)
class Population:
    """What all learners did in all trials."""

    scenario: Scenario
    """What was presented."""
    lid: NDArray[np.int8]
    """(runs, trials): side of the lid, LEFT or RIGHT."""
    n_actions: NDArray[np.int8]
    """(runs, trials) [actions], all that a trial may have where it was not solved."""
    solved: NDArray[np.bool_]
    """(runs, trials): whether the jar was inserted."""
    strategy: NDArray[np.int8]
    """(runs, trials): numbers of `Strategy`."""
    first_hand: NDArray[np.int8]
    """(runs, trials): hand of the first executed grasp, LEFT or RIGHT; NONE where there
    was no grasp."""
    splits: NDArray[np.int32]
    """(runs, h, 6): the trial in which each context, a haptic state and an action, was
    first split by a feature; -1 where it never was, as with all other learners."""

    @classmethod
    def of(cls, scenario: Scenario, rows: Sequence[tuple[NDArray, ...]]) -> Self:
        """Put all runs together, each as `Learned.row` has it."""
        return cls(scenario, *map(np.stack, zip(*rows, strict=True)))


class Learned(NamedTuple):
    """One run of the learner, when it has ended; false or -1 after a trial's end."""

    lid: NDArray[np.int8]
    """(n_trials,), side of the lid, LEFT or RIGHT."""
    inserts: NDArray[np.int8]
    """(n_trials,), the hand that can insert the jar (see `Run`)."""
    n_actions: NDArray[np.int8]
    """(n_trials,) [actions], all that a trial may have where it was not solved."""
    solved: NDArray[np.bool_]
    """(n_trials,): whether the jar was inserted."""
    action: NDArray[np.int8]
    """(n_trials, max_actions): the action taken."""
    executed: NDArray[np.bool_]
    """(n_trials, max_actions): whether it was run."""
    inserted: NDArray[np.bool_]
    """(n_trials, max_actions): whether it left the jar in the receptacle."""
    splits: NDArray[np.int32]
    """(h, 6): the trial in which each context was first split, or -1."""
    learner: Learner
    """As it is in the end."""

    @classmethod
    def of(cls, graph: Graph, run: Run, walked: Walked) -> Self:
        """What a run came to."""
        done = walked.outcomes
        ran = _what_ran(graph, run.trials, done)
        splits = walked.splits.astype(np.int32)
        results = done.n_actions, done.solved, done.action
        return cls(run.lid, run.inserts, *results, *ran, splits, run.learner)

    @classmethod
    def nothing(cls, run: Run, max_actions: int, n_haptic: int) -> Self:
        """A run before its first trial."""
        shape = len(run.lid), max_actions
        n_actions = np.full(len(run.lid), max_actions, np.int8)
        solved, action = np.zeros(len(run.lid), np.bool_), np.full(shape, -1, np.int8)
        executed, inserted = np.zeros((2, *shape), np.bool_)
        splits = np.full((n_haptic, len(ACTION_NAMES)), -1, np.int32)
        results = n_actions, solved, action, executed, inserted
        return cls(run.lid, run.inserts, *results, splits, run.learner)

    @property
    def row(self) -> tuple[NDArray, ...]:
        """What a `Population` keeps of it, in the same order."""
        strategy = classify(self.inserts, self.action, self.executed, self.inserted)
        hand = first_hand(self.action, self.executed)
        return self.lid, self.n_actions, self.solved, strategy, hand, self.splits


def run_population(
    recording: Recording | RecordedWorld,
    scenario: Scenario,
    settings: PopulationSettings | None = None,
    jobs: int = 1,
    then: Recording | RecordedWorld | None = None,
    tick: Callable[[], object] = lambda: None,
) -> Population:
    """Let a population learn.

    Args:
        recording: where outcomes and histograms come from, and categories of grasps.
        scenario: what the trials present.
        settings: of the population.
        jobs: threads; the result doesn't depend on their number.
        then: the world of the scenario's last trials, if it has such.
        tick: called when a learner has ended.

    Raises:
        RecordingError: if the recording has too few complete presentations.
        InvalidValue: if a learner diverges, or worlds, categories and scenario don't
            fit together.
    """
    check_integer("jobs", jobs, 1, MOST_JOBS)
    settings = PopulationSettings() if settings is None else settings
    programme = Programme(recording, scenario, settings, then)
    ended = Parallel(n_jobs=jobs, prefer="threads", return_as="generator")(
        delayed(_row)(programme, number) for number in range(settings.runs)
    )
    rows = []
    for row in ended:
        rows.append(row)
        tick()
    return Population.of(scenario, rows)


def look_into(
    recording: Recording | RecordedWorld,
    scenario: Scenario,
    settings: PopulationSettings,
    look: Callable[[Learner], Looked],
    jobs: int = 1,
) -> list[Looked]:
    """What is seen in the learners themselves when they have ended, run by run.

    Args:
        recording: as in `run_population`.
        scenario: what the trials present.
        settings: of the population.
        look: sees it; the learner is forgotten afterwards.
        jobs: threads.
    """
    programme = Programme(recording, scenario, settings)
    return Parallel(n_jobs=jobs, prefer="threads")(
        delayed(_seen)(programme, number, look) for number in range(settings.runs)
    )


def learn(programme: Programme, number: int, take_over: bool = True) -> Learned:
    """Let one learner of a population learn.

    Args:
        programme: of the population.
        number: of the run.
        take_over: whether the learner itself is wanted in the end, and not only what
            it did.
    """
    run = programme.run(number)
    walked = run_trials(
        run.learner,
        programme.graph,
        run.trials,
        programme.rule(run.learner),
        run.rng,
        take_over,
    )
    return Learned.of(programme.graph, run, walked)


def _row(programme: Programme, number: int) -> tuple[NDArray, ...]:
    return learn(programme, number, take_over=False).row


def _seen(
    programme: Programme, number: int, look: Callable[[Learner], Looked]
) -> Looked:
    return look(learn(programme, number).learner)


def _what_ran(
    graph: Graph, trials: Trials, outcomes: Outcomes
) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
    """(n_trials, max_actions) twice: was an action run, did it insert the jar."""
    led_to = outcomes.node
    before = np.column_stack([trials.root, graph.situation[led_to[:, :-1]]])
    # In the node of an action that found nothing to do the trial does not stay.
    executed = (led_to >= 0) & (led_to != before) & (graph.situation[led_to] == led_to)
    return executed, executed & graph.inserted[led_to]
