"""Runs in processes side by side, gone on with where they stopped.

The processes are those of this machine: each writes its run's folder itself, and those
of a cluster would write it wherever they are.
"""

import contextlib
import io
import warnings
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from threading import RLock
from typing import NamedTuple

from tqdm import tqdm

from prospect_mj.errors import ProspectError, RunFolderError, is_inputs_fault, told
from prospect_mj.experiment.run import session
from prospect_mj.experiment.run.config import TrainConfig
from prospect_mj.experiment.run.environment import MakeEnvironment, make_environment
from prospect_mj.experiment.run.kept_episodes import Kept
from prospect_mj.experiment.run.run_files import CONFIG
from prospect_mj.experiment.run.run_folder import read_config
from prospect_mj.recording.workers import Workers


@dataclass(frozen=True)
class Wanted:
    """A run that there is to be."""

    path: Path
    """Its folder."""
    config: TrainConfig
    make_env: MakeEnvironment = make_environment
    kept: Kept | None = None
    """Which of its trials are kept as episodes; None: none."""


class Warned(NamedTuple):
    """What was to be told on the way; equal to what another process tells alike."""

    words: str
    category: type[Warning]


@dataclass(frozen=True)
class Ended:
    """How the work on a run ended."""

    path: Path
    """Its folder."""
    failure: Exception | None
    """What kept the run from its end; None if it is finished."""
    warned: tuple[Warned, ...]


def folder_name(seed: int) -> str:
    """Folder of a run among those of other seeds."""
    return f"seed-{seed:04d}"


def finish(runs: Iterable[Wanted], jobs: int) -> Iterator[Ended]:
    """Bring every run to its end; a killed process loses no finished trial.

    Args:
        runs: begun, finished or not there yet; one that was made longer stays so.
        jobs: processes.

    Yields:
        Each run, as it ends. One that fails keeps no other from its end.
    """
    yield from Workers(jobs).map(_work, runs)


def check_all_finished(ended: Sequence[Ended]) -> None:
    """Refuse runs of which some failed, in one line for all of them.

    Raises:
        RunFolderError: if the input was at fault in any of them.
        ChildProcessError: if machine or physics were in all that failed.
    """
    failed = [run for run in ended if run.failure is not None]
    if not failed:
        return
    words = "; ".join(f"{run.path.name}: {told(run.failure)}" for run in failed)
    others = "" if len(failed) == len(ended) else ", the others are finished"
    counted = f"{len(failed)} of {len(ended)} runs failed{others}"
    line = f"{counted}: {words}"
    blamed = any(is_inputs_fault(run.failure) for run in failed)
    raise RunFolderError(line) if blamed else ChildProcessError(line)


def _work(run: Wanted) -> Ended:
    """Finish a run quietly, as others are told of beside it; keep what went wrong."""
    # Its usual lock is a semaphore, and Python complains where a process leaves one.
    tqdm.set_lock(RLock())
    failure = None
    with (
        contextlib.redirect_stderr(io.StringIO()),
        warnings.catch_warnings(record=True) as caught,
    ):
        try:
            _finish(run)
        except (ProspectError, OSError) as error:
            failure = error
    return Ended(run.path, failure, warned_of(caught))


def warned_of(caught: Iterable[warnings.WarningMessage]) -> tuple[Warned, ...]:
    """What can be told by another process of warnings that were caught."""
    return tuple(Warned(str(one.message), one.category) for one in caught)


def _finish(run: Wanted) -> None:
    """Start a run, or go on with it."""
    if (run.path / CONFIG).exists():
        trials = max(run.config.trials, read_config(run.path).trials)
        config = run.config.with_trials(trials)
        session.resume(run.path, config, run.make_env, _say_nothing, run.kept)
    else:
        session.start(run.config, run.path, run.make_env, _say_nothing, run.kept)


def _say_nothing(words: str) -> None:
    """Take what the training would print."""
