"""The episodes of a run that are to be replayed, each with what the learner thought."""

import os
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from prospect_mj.episodes import episode_file
from prospect_mj.episodes.episode import Episode
from prospect_mj.errors import EpisodeError, InvalidValue, RunFolderError
from prospect_mj.experiment.populations.strategies import Strategy, classify
from prospect_mj.experiment.run.kept_episodes import path_of
from prospect_mj.experiment.view.run_view import RunView
from prospect_mj.experiment.watching.resimulate import resimulate
from prospect_mj.recording.hands import NUMBERS, inserting_hand
from prospect_mj.recording.worlds import STANDARD
from prospect_mj.replay.rerun_export import Decision, Story

Say = Callable[[str], None]

MOST_SIMULATED = 10
"""Failures that are simulated again, if none was kept."""
PRODUCT = ".rrd"
"""What names of replays end in."""
_WORDS = {
    Strategy.OPTIMAL: "optimal",
    Strategy.EARLY: "early correction",
    Strategy.LATE: "late correction",
}


@dataclass(frozen=True)
class Choice:
    """Which trials of a run; without any of the three one that was kept."""

    trial: int | None = None
    """By its number, from 0."""
    worst: bool = False
    """The one with most actions, and of several the last."""
    failures: bool = False
    """All that were kept and not solved, or, if none was kept, the last
    `MOST_SIMULATED`."""

    def __post_init__(self) -> None:
        """Refuse more than one choice of the same thing."""
        if len(self.given) > 1:
            expected = "one of --trial, --worst, --failures"
            raise InvalidValue("choice of trials", " ".join(self.given), expected)

    @property
    def given(self) -> list[str]:
        """Those of the three that are given, as a user wrote them."""
        said = {
            f"--trial {self.trial}": self.trial is not None,
            "--worst": self.worst,
            "--failures": self.failures,
        }
        return [words for words, is_given in said.items() if is_given]


@dataclass(frozen=True, eq=False)
class Replayed:
    """One trial."""

    episode: Episode
    story: Story


Fetch = Callable[[], Replayed]
"""Reads a trial, or simulates it again: each by itself, as each may fail."""


def chosen(run: RunView, choice: Choice) -> list[int]:
    """Numbers of the trials that are to be replayed.

    Args:
        run: the run.
        choice: which; without any the last trial that was kept, or the last one.

    Raises:
        InvalidValue: if there is no such trial.
        RunFolderError: if every trial was solved.
    """
    if choice.trial is not None:
        if not 0 <= choice.trial < run.n_trials:
            expected = f"0 to {run.n_trials - 1}, as far as the run has come"
            raise InvalidValue("--trial", choice.trial, expected)
        return [choice.trial]
    if choice.worst:
        n_actions = run.trials["n_actions"].to_numpy()
        return [int(np.flatnonzero(n_actions == n_actions.max())[-1])]
    kept = run.kept_trials
    if choice.failures:
        return _failures(run, kept)
    return [kept[-1] if kept else run.n_trials - 1]


def _failures(run: RunView, kept: Sequence[int]) -> list[int]:
    solved = run.trials["solved"].to_pylist()
    unsolved = [number for number, done in enumerate(solved) if not done]
    if not unsolved:
        raise RunFolderError(f"{run.path}: all of its {run.n_trials} trials are solved")
    return [n for n in unsolved if n in kept] or unsolved[-MOST_SIMULATED:]


def of(path: Path, choice: Choice, say: Say) -> dict[str, Fetch]:
    """The trials that are to be replayed: how to get each, by its name.

    Args:
        path: folder of a run or of an evaluation, or an episode by itself; of that one
            it isn't known what the learner thought.
        choice: which trials of a folder.
        say: told what takes some seconds.

    Raises:
        RunFolderError, EpisodeError, InvalidValue: what can't be replayed, and why.
    """
    if path.suffix == PRODUCT and path.is_file():
        expected = f"a run's folder or an episode; rerun {path} opens what was saved"
        raise InvalidValue("RUN", str(path), expected)
    if path.suffix == episode_file.SUFFIX and not os.path.isdir(path):
        if choice.given:
            expected = "none beside the file of one episode"
            raise InvalidValue("choice of trials", *choice.given, expected)
        alone = Replayed(episode_file.read(path), Story(path.stem))
        return {path.stem: lambda: alone}
    try:
        run = RunView.read(path)
        numbers = chosen(run, choice)
    except OSError as error:
        raise RunFolderError(f"{path} can't be read: {error.strerror}") from error
    return {f"trial-{n:06d}": partial(replayed, run, n, say) for n in numbers}


def replayed(run: RunView, number: int, say: Say) -> Replayed:
    """Read the episode of a trial, or simulate the trial again if it was not kept.

    Args:
        run: the run.
        number: the trial's.
        say: told what takes some seconds.

    Raises:
        EpisodeError: if it is damaged or of another run.
        RunFolderError: if it can't be simulated again.
        RecordingError: if the recording is gone that it was of.
    """
    actions = run.actions_of(number).to_pylist()
    (trial,) = run.trials.slice(number, 1).to_pylist()
    path = path_of(run.path, number)
    if path.exists():
        episode = _kept(path, run.origin)
    else:
        say(f"trial {number} was not kept: it is simulated again")
        episode = resimulate(run, trial, actions)
    decisions = [Decision(np.array(a["q_values"]), a["explored"]) for a in actions]
    name = run.path.resolve().name
    told = strategy(trial, actions, run.config.world)
    title = f"{name}, trial {number}: {told}"
    return Replayed(episode, Story(title, decisions))


def _kept(path: Path, origin: str) -> Episode:
    try:
        return episode_file.read(path, origin)
    except EpisodeError as error:
        advice = "remove it, and the trial is simulated again"
        raise EpisodeError(f"{error}; {advice}") from error


def strategy(
    trial: dict[str, Any], actions: list[dict[str, Any]], world: str = STANDARD
) -> str:
    """The strategy of a trial in words.

    Args:
        trial: its row of the table of trials.
        actions: its rows of the table of actions, in order.
        world: in which it was run; it decides which hand inserts.
    """
    columns = ("action", "executed", "inserted")
    action, executed, inserted = (
        np.array([row[name] for row in actions]) for name in columns
    )
    lid = np.int8(NUMBERS[trial["orientation"]])
    hand = inserting_hand(lid, world)
    kind = Strategy(int(classify(hand, action, executed, inserted)))
    if kind in _WORDS:
        return _WORDS[kind]
    return "solved in another way" if trial["solved"] else "not solved"
