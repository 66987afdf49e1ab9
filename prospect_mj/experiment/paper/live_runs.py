"""Runs on live physics in processes side by side, gone on with where they stopped.

The processes are those of this machine: each writes its run's folder itself, and those
of a cluster would write it wherever they are.
"""

import contextlib
import io
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from prospect_mj.checks import check_integer
from prospect_mj.experiment import session
from prospect_mj.experiment.config import TrainConfig
from prospect_mj.experiment.environment import MakeEnvironment, make_environment
from prospect_mj.experiment.run_folder import CONFIG, read_config
from prospect_mj.recording.workers import Workers


@dataclass(frozen=True)
class LiveRuns:
    """Which runs there are to be."""

    runs: int = 20
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
) -> Iterator[Path]:
    """Bring every run to its end; a killed process loses no finished trial.

    Args:
        wanted: the runs.
        out: folder of their folders.
        jobs: processes.
        make_env: makes the environment.

    Yields:
        The folder of each run that is finished, as it is.

    Raises:
        RunFolderError: if a folder can't be used.
    """
    out.mkdir(parents=True, exist_ok=True)
    tasks = [
        _Task(out / folder_name(number), wanted.config(number), make_env)
        for number in range(wanted.runs)
    ]
    yield from Workers(jobs).map(_finish, tasks)


def _finish(task: _Task) -> Path:
    """Start a run, or go on with it; quietly, as others are told of beside it."""
    with contextlib.redirect_stderr(io.StringIO()):
        if (task.path / CONFIG).exists():
            # A run that was made longer stays so.
            trials = max(task.config.trials, read_config(task.path).trials)
            config = task.config.with_trials(trials)
            session.resume(task.path, config, task.make_env, _say_nothing)
        else:
            session.start(task.config, task.path, task.make_env, _say_nothing)
    return task.path


def _say_nothing(words: str) -> None:
    """Take what the training would print."""
