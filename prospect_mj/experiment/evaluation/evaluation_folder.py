"""The folder of an evaluation, which survives being killed at any moment.

    evaluation.yaml  what is evaluated, settings, versions and digests
    weights.npz      the learner, as the run had it then
    episodes         the trials that were kept for replay
    actions.parquet  one row per action (`records.ActionRecord`)
    trials.parquet   one row per trial (`records.TrialRecord`)

They are written in this order, each as a whole. With its weights an evaluation is
begun: the run may learn on meanwhile. Its finished trials are those in the last table.
"""

from collections.abc import Callable
from pathlib import Path
from typing import Self

import pyarrow as pa

from prospect_mj.agent import Learner
from prospect_mj.errors import RunFolderError, is_machines_fault
from prospect_mj.experiment.run.folder_guard import check_vacant
from prospect_mj.experiment.run.records import action_table, trial_table
from prospect_mj.experiment.run.run_files import WEIGHTS, RunState
from prospect_mj.experiment.run.trial_loop import FinishedTrial
from prospect_mj.experiment.view import evaluation_file, evaluation_state
from prospect_mj.experiment.view.evaluation_file import StoredEvaluation
from prospect_mj.locking import LockedFolder
from prospect_mj.storage import temporary
from prospect_mj.tables import appended


class EvaluationFolder(LockedFolder):
    """An open evaluation: what it is, its learner and tables, for one process.

    Attributes:
        path: the folder.
        evaluation: what it is.
        state: the learner, and the finished trials.
    """

    def __init__(
        self, path: Path, evaluation: StoredEvaluation, state: Callable[[], RunState]
    ) -> None:
        """Use `create` or `open` instead; the state is asked for in a locked folder."""
        super().__init__(path)
        self.evaluation = evaluation
        with self.closed_if_it_fails():
            self.state = state()

    @classmethod
    def create(cls, path: Path, evaluation: StoredEvaluation, learner: Learner) -> Self:
        """Begin an evaluation in a new or empty folder.

        Args:
            path: the folder.
            evaluation: what it is.
            learner: the run's.

        Raises:
            RunFolderError: if the folder is occupied or can't be written.
            OSError: if the machine is at fault, as on a full disk.
        """
        try:
            path.mkdir(parents=True, exist_ok=True)
            return cls(path, evaluation, lambda: _begun(path, evaluation, learner))
        except OSError as error:
            if is_machines_fault(error):
                raise
            words = f"{path} can't be written: {error.strerror}"
            raise RunFolderError(words) from error

    @classmethod
    def open(cls, path: Path) -> Self:
        """Open an evaluation where its last finished trial left it.

        Raises:
            RunFolderError: if it is none or is damaged.
            FolderInUse: if another process works in it.
        """
        evaluation = evaluation_file.read(path)
        return cls(
            path,
            evaluation,
            lambda: evaluation_state.read_state(
                path, evaluation.origin, evaluation.config.learner.name
            ),
        )

    @property
    def origin(self) -> str:
        """Digest that marks its files."""
        return self.evaluation.origin

    @property
    def trials(self) -> pa.Table:
        """Table under `records.TRIAL_SCHEMA` of the finished trials."""
        return self.state.trials

    @property
    def n_trials(self) -> int:
        """Finished trials."""
        return self.trials.num_rows

    def commit(self, finished: FinishedTrial) -> None:
        """Make a finished trial permanent."""
        actions = appended(self.state.actions, action_table(finished.actions))
        trials = appended(self.trials, trial_table([finished.trial]))
        self.state = RunState(self.state.learner, actions, trials)
        evaluation_state.write_tables(self.path, self.state, self.origin)


def is_begun(path: Path) -> bool:
    """Whether there is an evaluation that can be gone on with."""
    return evaluation_file.is_in(path) and (path / WEIGHTS).exists()


def check_free(path: Path) -> None:
    """Refuse a folder that a new evaluation can't have, without touching it.

    Raises:
        RunFolderError: if `path` is a file, or a folder with something in it.
    """
    # No more than an evaluation that was killed before it was begun.
    description = path / evaluation_file.NAME
    unborn = [description, temporary(description), temporary(path / WEIGHTS)]
    own = [] if is_begun(path) else [file.name for file in unborn]
    check_vacant(path, "choose another folder", own.__contains__)


def _begun(path: Path, evaluation: StoredEvaluation, learner: Learner) -> RunState:
    """Write what there is before the first trial, if the folder can be had."""
    check_free(path)
    evaluation_file.write(path, evaluation)
    return evaluation_state.begin(path, learner, evaluation.origin)
