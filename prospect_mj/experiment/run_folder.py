"""The folder of a training run, which survives being killed at any moment.

    config.yaml         settings, versions and digests of what decides the numbers
    actions.parquet     one row per action (`records.ActionRecord`)
    trials.parquet      one row per trial (`records.TrialRecord`)
    weights.npz         what `LinearQ.load` reads
    learning_curve.png  drawn at the end

Every file is replaced as a whole. After each trial the tables come first and the
weights last: they count the actions learned from, so rows beyond that count belong to a
trial that was not finished and is run again, with the same outcome. The configuration
comes before all others, so that a kill at any moment leaves nothing or a run that can
be resumed. All of them but the picture carry the digest of the run.
"""

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Self, TypeVar

import numpy as np
import pyarrow as pa
from pyarrow.lib import ArrowException

from prospect_mj import tables
from prospect_mj.agent import LinearQ
from prospect_mj.errors import ForeignTable, ProspectError, RunFolderError
from prospect_mj.experiment import config_file, fingerprint, folder_guard
from prospect_mj.experiment.config import TrainConfig
from prospect_mj.experiment.records import (
    ACTION_SCHEMA,
    TRIAL_SCHEMA,
    action_table,
    trial_table,
)
from prospect_mj.experiment.training import FinishedTrial, new_learner
from prospect_mj.locking import LockedFolder
from prospect_mj.storage import replace_file

CONFIG = config_file.NAME
ACTIONS = "actions.parquet"
TRIALS = "trials.parquet"
WEIGHTS = "weights.npz"
CURVE = "learning_curve.png"

_Content = TypeVar("_Content")


class RunFolder(LockedFolder):
    """An open run: its configuration, learner and tables, locked for one process.

    Attributes:
        path: the folder.
        config: what the run is.
        origin: digest of what must not change while it lasts; it marks the files.
        learner: the state after the last finished trial.
        actions: table under `ACTION_SCHEMA` of the finished trials.
        trials: table under `TRIAL_SCHEMA` of the finished trials.
    """

    def __init__(self, path: Path, config: TrainConfig) -> None:
        """Use `create` or `open` instead."""
        super().__init__(path)
        self.config = config
        self.origin = fingerprint.origin(config)
        self.learner = new_learner(config, self.origin)
        self.actions = ACTION_SCHEMA.empty_table()
        self.trials = TRIAL_SCHEMA.empty_table()

    @classmethod
    def create(cls, path: Path | None, config: TrainConfig) -> Self:
        """Start a run in an empty or new folder; None takes the first free default.

        Raises:
            RunFolderError: if the folder is occupied or can't be written.
        """
        try:
            path = folder_guard.new_default() if path is None else path
            path.mkdir(parents=True, exist_ok=True)
            folder = cls(path, config)
        except OSError as error:
            raise _not_writable(path, error) from error
        with folder.closed_if_it_fails():
            folder._begin()
        return folder

    @classmethod
    def open(cls, path: Path) -> Self:
        """Open an existing run where its last finished trial left it.

        Raises:
            RunFolderError: if it is no run folder or is damaged.
            FolderInUse: if another process works in it.
        """
        config = read_config(path)
        folder = cls(path, config)
        with folder.closed_if_it_fails():
            folder._read_state()
        return folder

    @property
    def n_trials(self) -> int:
        """Finished trials."""
        return self.trials.num_rows

    @property
    def is_finished(self) -> bool:
        """Whether nothing is left to do."""
        return self.n_trials == self.config.trials and (self.path / CURVE).is_file()

    def extend(self, config: TrainConfig) -> None:
        """Give the run more trials; the rest of `config` must be the same."""
        if config == self.config:
            return
        (self.path / CURVE).unlink(missing_ok=True)
        config_file.write(self.path / CONFIG, config)
        self.config = config

    def commit(self, finished: FinishedTrial) -> None:
        """Make a finished trial, and the learner after it, permanent."""
        self.actions = tables.appended(self.actions, action_table(finished.actions))
        self.trials = tables.appended(self.trials, trial_table([finished.trial]))
        self._write_state()

    def write_curve(self, png: bytes) -> None:
        """Store the picture of the learning curve."""
        replace_file(self.path / CURVE, png)

    def _begin(self) -> None:
        folder_guard.check_free(self.path)
        try:
            config_file.write(self.path / CONFIG, self.config)
            self._write_state()
        except OSError as error:
            raise _not_writable(self.path, error) from error

    def _write_state(self) -> None:
        for name, table in ((ACTIONS, self.actions), (TRIALS, self.trials)):
            replace_file(self.path / name, tables.parquet(table, self.origin))
        self.learner.save(self.path / WEIGHTS)

    def _read_state(self) -> None:
        if self._was_killed_at_birth():
            return
        self.learner = _read(self.path / WEIGHTS, LinearQ.load)
        if self.learner.origin != self.origin:
            raise RunFolderError(f"{self.path / WEIGHTS} is from another run")
        actions = self._read_table(ACTIONS, ACTION_SCHEMA)
        trials = self._read_table(TRIALS, TRIAL_SCHEMA)
        self.actions = actions.slice(0, self.learner.n_updates)
        n_trials = np.unique(self.actions["trial"].to_numpy()).size
        self.trials = trials.slice(0, n_trials)
        self._check_state()

    def _was_killed_at_birth(self) -> bool:
        """Whether the files of the state were not all written for the first time."""
        if (self.path / WEIGHTS).exists():
            return False
        schemas = {ACTIONS: ACTION_SCHEMA, TRIALS: TRIAL_SCHEMA}
        there = [name for name in schemas if (self.path / name).exists()]
        rows = [self._read_table(name, schemas[name]).num_rows for name in there]
        return not any(rows)

    def _read_table(self, name: str, schema: pa.Schema) -> pa.Table:
        reader = partial(tables.read, schema=schema, origin=self.origin, of="run")
        return _read(self.path / name, reader)

    def _check_state(self) -> None:
        """The three files must tell of the same trials."""
        n_actions = self.trials["n_actions"].to_numpy().sum()
        numbers = self.trials["trial"].to_pylist()
        if (
            self.actions.num_rows != self.learner.n_updates
            or n_actions != self.learner.n_updates
            or numbers != list(range(len(numbers)))
            or len(numbers) > self.config.trials
        ):
            raise RunFolderError(
                f"{self.path} is damaged: its tables and weights don't fit together"
            )


def read_config(path: Path) -> TrainConfig:
    """Read the configuration of a run without opening the run.

    Raises:
        RunFolderError: if `path` is no run folder or its configuration is unreadable.
    """
    if not (path / CONFIG).is_file():
        raise RunFolderError(f"{path} is not a run folder: it has no {CONFIG}")
    return config_file.read(path / CONFIG)


def _not_writable(path: Path | None, error: OSError) -> RunFolderError:
    where = folder_guard.DEFAULT_PARENT if path is None else path
    return RunFolderError(f"{where} can't be written: {error.strerror}")


def _read(path: Path, reader: Callable[[Path], _Content]) -> _Content:
    """Read one file of a run, or say which one can't be read."""
    try:
        return reader(path)
    except RunFolderError:
        raise
    except ForeignTable as error:
        raise RunFolderError(str(error)) from error
    except (OSError, ArrowException, ProspectError) as error:
        raise RunFolderError(f"{path} can't be read: missing or damaged") from error
