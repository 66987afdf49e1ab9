"""The files of a run, as `run_folder` describes them, and reading its state."""

import os
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import NamedTuple, TypeVar

import numpy as np
import pyarrow as pa
from pyarrow.lib import ArrowException

from prospect_mj import tables
from prospect_mj.agent import Learner, checkpoint
from prospect_mj.errors import (
    ForeignTable,
    ProspectError,
    RunFolderError,
    UnfitCheckpoint,
)
from prospect_mj.experiment.run import config_file, soundness
from prospect_mj.experiment.run.records import ACTION_SCHEMA, TRIAL_SCHEMA

CONFIG = config_file.NAME
ACTIONS = "actions.parquet"
TRIALS = "trials.parquet"
WEIGHTS = "weights.npz"
CURVE = "learning_curve.png"

_SCHEMAS = {ACTIONS: ACTION_SCHEMA, TRIALS: TRIAL_SCHEMA}
_Content = TypeVar("_Content")


class RunState(NamedTuple):
    """What a run has come to: the finished trials, and the learner after them."""

    learner: Learner
    actions: pa.Table
    """Under `ACTION_SCHEMA`."""
    trials: pa.Table
    """Under `TRIAL_SCHEMA`."""


def checked_config(path: Path) -> Path:
    """The configuration file of a run.

    Raises:
        RunFolderError: if `path` is no run folder.
    """
    if (path / CONFIG).is_file():
        return path / CONFIG
    inside = sorted(path.glob(f"*/{CONFIG}"))
    where = f"; runs are in it, such as {inside[0].parent}" if inside else ""
    raise RunFolderError(f"{path} is not a run folder: it has no {CONFIG}{where}")


def read_state(path: Path, origin: str, learner: str) -> RunState | None:
    """Read what the finished trials of a run have left; another process may write.

    The weights are read first, as they are written last: the tables are then of the
    same trial or of a later one, whose rows are left out.

    Args:
        path: its folder.
        origin: what marks its files.
        learner: name of its learner.

    Returns:
        None if the run was killed before its state was written for the first time.

    Raises:
        RunFolderError: if a file is missing, damaged or of another run.
    """
    if _was_killed_at_birth(path, origin):
        return None
    learned = read_learner(path, origin, learner)
    actions = read_table(path, ACTIONS, origin).slice(0, learned.n_updates)
    n_trials = np.unique(actions["trial"].to_numpy()).size
    trials = read_table(path, TRIALS, origin).slice(0, n_trials)
    state = RunState(learned, actions, trials)
    _check_together(path, state)
    return state


def _was_killed_at_birth(path: Path, origin: str) -> bool:
    """Whether the files of the state were not all written for the first time."""
    if (path / WEIGHTS).exists():
        return False
    there = [name for name in _SCHEMAS if (path / name).exists()]
    return not any(read_table(path, name, origin).num_rows for name in there)


def _check_together(path: Path, state: RunState) -> None:
    """The three files must tell of the same trials."""
    taken = np.bincount(state.actions["trial"].to_numpy()).tolist()
    numbers = state.trials["trial"].to_pylist()
    if (
        state.actions.num_rows != state.learner.n_updates
        or state.trials["n_actions"].to_pylist() != taken
        or numbers != list(range(len(numbers)))
    ):
        raise RunFolderError(
            f"{path} is damaged: its tables and weights don't fit together"
        )


def read_learner(path: Path, origin: str, learner: str) -> Learner:
    """Read the learner of a run.

    Args:
        path: the run's folder.
        origin: what marks its files.
        learner: name of its learner.

    Raises:
        RunFolderError: if it is missing, damaged, of another run or another one.
    """
    file = path / WEIGHTS
    stored = _read(file, partial(checkpoint.read, wanted=learner))
    if stored.origin != origin:
        raise RunFolderError(f"{file} is from another run")
    return stored.learner


def read_table(path: Path, name: str, origin: str) -> pa.Table:
    """Read one of the two tables of a run.

    Raises:
        RunFolderError: if it is missing, damaged or of another run.
    """
    schema = _SCHEMAS[name]
    reader = partial(tables.read, schema=schema, origin=origin, of="run")
    table = _read(path / name, reader)
    soundness.check(path / name, table)
    return table


def _read(path: Path, reader: Callable[[Path], _Content]) -> _Content:
    """Read one file of a run, or say which one can't be read."""
    try:
        return reader(path)
    except RunFolderError:
        raise
    except (ForeignTable, UnfitCheckpoint) as error:
        raise RunFolderError(str(error)) from error
    except (OSError, ArrowException, ProspectError) as error:
        why = "it is damaged" if os.path.exists(path) else "it is missing"
        raise RunFolderError(f"{path} can't be read: {why}") from error
