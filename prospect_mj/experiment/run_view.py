"""A run as it is at one moment, for who only reads: no lock, and nothing is written.

Unlike `RunFolder`, which goes on with a run, it asks for no particular version of the
software, and shows the finished trials of a run that is under way.
"""

from dataclasses import dataclass
from pathlib import Path
from typing import Self

import pyarrow as pa
import pyarrow.compute as pc

from prospect_mj.agent import LinearQ
from prospect_mj.errors import ProspectError, RunFolderError
from prospect_mj.experiment import config_file, fingerprint, run_files
from prospect_mj.experiment.config import TrainConfig


@dataclass(frozen=True, eq=False)
class RunView:
    """The finished trials of a run."""

    path: Path
    """Its folder."""
    config: TrainConfig
    origin: str
    """Digest that marks its files."""
    learner: LinearQ
    """After the last finished trial."""
    actions: pa.Table
    """Under `records.ACTION_SCHEMA`."""
    trials: pa.Table
    """Under `records.TRIAL_SCHEMA`."""

    @classmethod
    def read(cls, path: Path) -> Self:
        """Read a run, which another process may be adding to.

        Raises:
            RunFolderError: if it is no run folder or is damaged.
        """
        stored = config_file.read_stored(run_files.checked_config(path))
        try:
            config = TrainConfig.from_dict(stored.settings)
        except (ProspectError, KeyError, TypeError, ValueError) as error:
            what = f"{path} has settings that this version doesn't know"
            raise RunFolderError(f"{what}: {error}") from error
        origin = fingerprint.origin_of(stored.sha256)
        state = run_files.read_state(path, origin)
        if state is None or state.trials.num_rows == 0:
            raise RunFolderError(f"{path} has no finished trial yet")
        return cls(path, config, origin, *state)

    @property
    def n_trials(self) -> int:
        """Finished trials."""
        return self.trials.num_rows

    def actions_of(self, trial: int) -> pa.Table:
        """The actions of one trial, in order."""
        return self.actions.filter(pc.equal(self.actions["trial"], trial))

    def outdated(self) -> list[str]:
        """What decides its numbers and is another one by now, such as a model file.

        Raises:
            ProspectError: if something of it is missing.
        """
        stored = config_file.read_stored(run_files.checked_config(self.path))
        return config_file.differences(stored, self.config)
