"""A run as it is at one moment, for who only reads: no lock, and nothing is written.

Unlike `RunFolder`, which goes on with a run, it asks for no particular version of the
software, and shows the finished trials of a run that is under way. An evaluation of a
run can be viewed like a run.
"""

from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Self

import pyarrow as pa
import pyarrow.compute as pc

from prospect_mj.agent import Learner
from prospect_mj.errors import ProspectError, RunFolderError
from prospect_mj.experiment.run import config_file, fingerprint, run_files
from prospect_mj.experiment.run.config import TrainConfig
from prospect_mj.experiment.run.config_file import StoredConfig
from prospect_mj.experiment.run.kept_episodes import kept_trials
from prospect_mj.experiment.run.training import presentation_seed
from prospect_mj.experiment.view import evaluation_file
from prospect_mj.experiment.view.evaluation_file import StoredEvaluation
from prospect_mj.experiment.view.evaluation_state import read_state
from prospect_mj.recording.recording import Recording


@dataclass(frozen=True, eq=False)
class RunView:
    """The finished trials of a run, or of an evaluation."""

    path: Path
    """Its folder."""
    config: TrainConfig
    """Settings of its trials."""
    stored: StoredConfig
    """What its folder says that it was made with."""
    learner: Learner
    """After the last finished trial."""
    actions: pa.Table
    """Under `records.ACTION_SCHEMA`."""
    trials: pa.Table
    """Under `records.TRIAL_SCHEMA`."""
    evaluation: StoredEvaluation | None = None
    """None: it is a run."""

    @classmethod
    def read(cls, path: Path) -> Self:
        """Read a run or an evaluation, which another process may be adding to.

        Raises:
            RunFolderError: if it is neither or is damaged.
        """
        if evaluation_file.is_in(path):
            evaluation = evaluation_file.read(path)
            stored, reader = evaluation.stored, read_state
        else:
            evaluation, reader = None, run_files.read_state
            stored = config_file.read_stored(run_files.checked_config(path))
        config = _config(path, stored)
        origin = fingerprint.origin_of(stored.sha256)
        state = reader(path, origin, config.learner.name)
        if state is None or state.trials.num_rows == 0:
            raise RunFolderError(f"{path} has no finished trial yet")
        return cls(path, config, stored, *state, evaluation)

    @property
    def origin(self) -> str:
        """Digest that marks its files."""
        return fingerprint.origin_of(self.stored.sha256)

    @property
    def n_trials(self) -> int:
        """Finished trials."""
        return self.trials.num_rows

    @property
    def kept_trials(self) -> list[int]:
        """The finished trials whose episodes were kept, ascending."""
        # The episode of a trial is there before the trial is finished.
        return [n for n in kept_trials(self.path) if n < self.n_trials]

    @cached_property
    def recording(self) -> Recording:
        """The recorded physics that its trials were of; read once.

        Raises:
            RecordingError: if it is gone or damaged.
        """
        return Recording.load(self.config.recording_folder)

    def check_is_run(self) -> None:
        """Refuse an evaluation, in which nothing was learned.

        Raises:
            RunFolderError: if it is one.
        """
        if self.evaluation is not None:
            raise RunFolderError(f"{self.path} is an evaluation, not a run")

    def actions_of(self, trial: int) -> pa.Table:
        """The actions of one trial, in order."""
        return self.actions.filter(pc.equal(self.actions["trial"], trial))

    def presentation_seed(self, trial: int) -> int:
        """What the environment drew a trial's presentation by."""
        if self.evaluation is not None:
            return self.evaluation.settings.presentation_seed(trial)
        return presentation_seed(self.config.seed, trial)

    def outdated(self) -> list[str]:
        """What decides its numbers and is another one by now, such as a model file.

        Raises:
            ProspectError: if something of it is missing.
        """
        found = config_file.differences(self.stored, self.config)
        return [difference.name for difference in found]


def _config(path: Path, stored: StoredConfig) -> TrainConfig:
    try:
        return TrainConfig.from_dict(stored.settings)
    except (ProspectError, KeyError, TypeError, ValueError) as error:
        what = f"{path} has settings that this version doesn't know"
        raise RunFolderError(f"{what}: {error}") from error
