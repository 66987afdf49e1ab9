"""The folder of a training run, which survives being killed at any moment.

    config.yaml         settings, versions and digests of what decides the numbers
    episodes            the trials that were kept for replay (`episode_keeper`)
    actions.parquet     one row per action (`records.ActionRecord`)
    trials.parquet      one row per trial (`records.TrialRecord`)
    weights.npz         the learner (`agent.checkpoint`)
    learning_curve.png  drawn at the end

Every file is replaced as a whole. After each trial the tables come first and the
weights last: they count the actions learned from, so rows beyond that count belong to a
trial that was not finished and is run again, with the same outcome. The configuration
comes before all others, so that a kill at any moment leaves nothing or a run that can
be resumed. All of them but the picture carry the digest of the run.
"""

from pathlib import Path
from typing import NoReturn, Self

from prospect_mj import tables
from prospect_mj.agent import checkpoint
from prospect_mj.errors import RunFolderError, is_machines_fault
from prospect_mj.experiment.run import config_file, fingerprint, folder_guard, run_files
from prospect_mj.experiment.run.config import TrainConfig
from prospect_mj.experiment.run.records import (
    ACTION_SCHEMA,
    TRIAL_SCHEMA,
    action_table,
    trial_table,
)
from prospect_mj.experiment.run.run_files import ACTIONS, CONFIG, CURVE, TRIALS, WEIGHTS
from prospect_mj.experiment.run.training import new_learner
from prospect_mj.experiment.run.trial_loop import FinishedTrial
from prospect_mj.locking import LockedFolder
from prospect_mj.storage import replace_file


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
        self.learner = new_learner(config)
        self.actions = ACTION_SCHEMA.empty_table()
        self.trials = TRIAL_SCHEMA.empty_table()

    @classmethod
    def create(cls, path: Path | None, config: TrainConfig) -> Self:
        """Start a run in an empty or new folder; None takes the first free default.

        Raises:
            RunFolderError: if the folder is occupied or can't be written.
            OSError: if the machine is at fault, as on a full disk.
        """
        try:
            path = folder_guard.new_default() if path is None else path
            path.mkdir(parents=True, exist_ok=True)
            folder = cls(path, config)
        except OSError as error:
            _refuse(path, error)
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
            _refuse(self.path, error)

    def _write_state(self) -> None:
        for name, table in ((ACTIONS, self.actions), (TRIALS, self.trials)):
            replace_file(self.path / name, tables.parquet(table, self.origin))
        checkpoint.write(self.path / WEIGHTS, self.learner, self.origin)

    def _read_state(self) -> None:
        state = run_files.read_state(self.path, self.origin, self.config.learner.name)
        if state is None:
            return
        self.learner, self.actions, self.trials = state
        if self.n_trials > self.config.trials:
            raise RunFolderError(
                f"{self.path} is damaged: {self.n_trials} trials and a configuration "
                f"of {self.config.trials} don't fit together"
            )


def read_config(path: Path) -> TrainConfig:
    """Read the configuration of a run without opening the run.

    Raises:
        RunFolderError: if `path` is no run folder or its configuration is unreadable.
    """
    return config_file.read(run_files.checked_config(path))


def _refuse(path: Path | None, error: OSError) -> NoReturn:
    if is_machines_fault(error):
        raise error
    where = folder_guard.DEFAULT_PARENT if path is None else path
    raise RunFolderError(f"{where} can't be written: {error.strerror}") from error
