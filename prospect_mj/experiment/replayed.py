"""The episodes of a run that are to be replayed, each with what the learner thought."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

from prospect_mj.episodes import episode_file
from prospect_mj.episodes.episode import Episode
from prospect_mj.errors import InvalidValue
from prospect_mj.experiment.kept_episodes import kept_trials, path_of
from prospect_mj.experiment.resimulate import resimulate
from prospect_mj.experiment.run_view import RunView
from prospect_mj.replay.rerun_export import Decision, Story

Say = Callable[[str], None]


@dataclass(frozen=True, eq=False)
class Replayed:
    """One trial."""

    trial: int
    episode: Episode
    story: Story


def chosen(run: RunView, trial: int | None, worst: bool, failures: bool) -> list[int]:
    """Numbers of the trials that are to be replayed.

    Args:
        run: the run.
        trial: one of its trials; None: see the others.
        worst: the one with most actions, and of several the last.
        failures: all that were kept and not solved. Without any of the three: the last
            trial that was kept, or the last one.

    Raises:
        InvalidValue: if there is no such trial.
    """
    if trial is not None:
        if not 0 <= trial < run.n_trials:
            expected = f"0 to {run.n_trials - 1}, as the run has come so far"
            raise InvalidValue("--trial", trial, expected)
        return [trial]
    kept = [number for number in kept_trials(run.path) if number < run.n_trials]
    if worst:
        n_actions = run.trials["n_actions"].to_numpy()
        return [int(np.flatnonzero(n_actions == n_actions.max())[-1])]
    if failures:
        solved = run.trials["solved"].to_pylist()
        unsolved = [number for number in kept if not solved[number]]
        if not unsolved:
            raise InvalidValue("--failures", 0, "a run that kept unsolved trials")
        return unsolved
    return [kept[-1] if kept else run.n_trials - 1]


def replayed(run: RunView, trials: list[int], say: Say) -> Iterator[Replayed]:
    """Read the episodes, or simulate again those that were not kept.

    Args:
        run: the run.
        trials: their numbers.
        say: told what takes some seconds.

    Raises:
        EpisodeError: if one is damaged or of another run.
        RunFolderError: if one can't be simulated again.
    """
    for number in trials:
        rows = run.actions_of(number).to_pylist()
        path = path_of(run.path, number)
        if path.exists():
            episode = episode_file.read(path, run.origin)
        else:
            say(f"trial {number} was not kept: it is simulated again")
            trial = run.trials.slice(number, 1).to_pylist()[0]
            episode = resimulate(run.path, run.config, trial, rows)
        decisions = [Decision(np.array(r["q_values"]), r["explored"]) for r in rows]
        title = f"{run.path.name}, trial {number}"
        yield Replayed(number, episode, Story(title, decisions))
