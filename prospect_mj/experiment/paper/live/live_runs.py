"""Runs on live physics in processes side by side, gone on with where they stopped.

The processes are those of this machine: each writes its run's folder itself, and those
of a cluster would write it wherever they are.
"""

import contextlib
import io
import warnings
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from prospect_mj.checks import check_integer
from prospect_mj.errors import (
    ProspectError,
    RunFolderError,
    SimulationDiverged,
    UnforeseenEvent,
)
from prospect_mj.experiment import session
from prospect_mj.experiment.config import TrainConfig
from prospect_mj.experiment.environment import MakeEnvironment, make_environment
from prospect_mj.experiment.paper.live.live_check import EXPECTED
from prospect_mj.experiment.run_files import CONFIG
from prospect_mj.experiment.run_folder import read_config
from prospect_mj.recording.workers import Workers
from prospect_mj.storage import make_folder

_NO_INPUTS_FAULT = (SimulationDiverged, UnforeseenEvent, OSError)


@dataclass(frozen=True)
class LiveRuns:
    """Which runs there are to be."""

    runs: int = EXPECTED
    """Runs; each has its number as its seed."""
    trials: int = 1000
    """Trials per run, without a dominant hand."""

    def __post_init__(self) -> None:
        """Refuse numbers that make no runs."""
        check_integer("runs", self.runs, 1, 100_000)
        TrainConfig(trials=self.trials)

    def config(self, number: int) -> TrainConfig:
        """The settings of one of the runs."""
        return TrainConfig(trials=self.trials, seed=number)


@dataclass(frozen=True)
class Ended:
    """How the work on a run ended."""

    path: Path
    """Its folder."""
    failure: Exception | None
    """What kept the run from its end; None if it is finished."""
    warned: tuple[str, ...]
    """What was to be told on the way."""


@dataclass(frozen=True)
class _Task:
    path: Path
    config: TrainConfig
    make_env: MakeEnvironment


def folder_name(number: int) -> str:
    """Folder of a run among the others."""
    return f"seed-{number:04d}"


def advance(
    wanted: LiveRuns,
    out: Path,
    jobs: int,
    make_env: MakeEnvironment = make_environment,
) -> Iterator[Ended]:
    """Bring every run to its end; a killed process loses no finished trial.

    Args:
        wanted: the runs.
        out: folder of their folders.
        jobs: processes.
        make_env: makes the environment.

    Yields:
        Each run, as it ends. One that fails keeps no other from its end.

    Raises:
        RunFolderError: if `out` is no folder and can't become one.
    """
    make_folder(out, RunFolderError)
    tasks = [
        _Task(out / folder_name(number), wanted.config(number), make_env)
        for number in range(wanted.runs)
    ]
    yield from Workers(jobs).map(_work, tasks)


def check_all_finished(ended: Sequence[Ended]) -> None:
    """Refuse runs of which some failed, in one line for all of them.

    Raises:
        RunFolderError: if the input was at fault in any of them.
        ChildProcessError: if machine or physics were in all that failed.
    """
    failed = [run for run in ended if run.failure is not None]
    if not failed:
        return
    words = "; ".join(f"{run.path.name}: {run.failure}" for run in failed)
    counted = f"{len(failed)} of {len(ended)} runs failed, the others are finished"
    told = f"{counted}: {words}"
    blameless = all(isinstance(run.failure, _NO_INPUTS_FAULT) for run in failed)
    raise ChildProcessError(told) if blameless else RunFolderError(told)


def _work(task: _Task) -> Ended:
    """Finish a run quietly, as others are told of beside it; keep what went wrong."""
    failure = None
    with (
        contextlib.redirect_stderr(io.StringIO()),
        warnings.catch_warnings(record=True) as caught,
    ):
        try:
            _finish(task)
        except (ProspectError, OSError) as error:
            failure = error
    return Ended(task.path, failure, tuple(str(one.message) for one in caught))


def _finish(task: _Task) -> None:
    """Start a run, or go on with it."""
    if (task.path / CONFIG).exists():
        # A run that was made longer stays so.
        trials = max(task.config.trials, read_config(task.path).trials)
        config = task.config.with_trials(trials)
        session.resume(task.path, config, task.make_env, _say_nothing)
    else:
        session.start(task.config, task.path, task.make_env, _say_nothing)


def _say_nothing(words: str) -> None:
    """Take what the training would print."""
