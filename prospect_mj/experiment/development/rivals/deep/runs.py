"""Runs of deep learners in processes beside this one, kept as they end.

A run that was kept is not made again. Each seeds the generators of torch, NumPy and
Python for itself, so that it is the same whichever run its process made before.
"""

import os
import warnings
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from time import process_time
from typing import NamedTuple

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from prospect_mj import tables
from prospect_mj.errors import RunFolderError
from prospect_mj.experiment.development.rivals import kept
from prospect_mj.experiment.development.rivals.deep import agents
from prospect_mj.experiment.development.rivals.deep.agents import DeepRun
from prospect_mj.recording.provenance import installed_versions
from prospect_mj.recording.workers import Workers
from prospect_mj.storage import make_folder, replace_file

_SCHEMA = pa.schema(
    {"trial": pa.int32(), "n_actions": pa.int16(), "seconds": pa.float32()}
)
"""A trial of a run; the processor time of the run [s] is the same in every row."""
_PACKAGES = ("torch", "stable-baselines3", "sb3-contrib", "gymnasium", "numpy")
_CODE = (
    "agent/features.py",
    "agent/haptics.py",
    "envs/*.py",
    "recording/*.py",
    "experiment/development/rivals/deep/*.py",
)
"""What makes the environment out of a recording, and the learner."""


class DeepLearned(NamedTuple):
    """What a deep learner did."""

    n_actions: NDArray[np.int16]
    """(n_trials,) [actions]."""
    seconds: float
    """Processor time in which it learned, its libraries' loading aside [s]."""


class _File(NamedTuple):
    """Where a run is kept."""

    path: Path
    digest: str
    """Of all that decides its numbers."""


@dataclass(frozen=True)
class DeepStore:
    """A folder of runs of deep learners.

    Raises:
        RunFolderError: if there is a file, or it can't be made.
    """

    folder: Path
    """Where they are kept; made if it isn't there."""
    recording: str
    """Digest of the recording that they learn from."""

    def __post_init__(self) -> None:
        """Make the folder."""
        make_folder(self.folder, RunFolderError)

    def get(
        self, runs: Sequence[DeepRun], jobs: int, tell: Callable[[str], object]
    ) -> list[DeepLearned]:
        """Read runs, and let those that are not there learn.

        Args:
            runs: which.
            jobs: processes side by side.
            tell: takes a line as each run ends.

        Raises:
            MissingPackage: if a library is not installed and something is to learn.
            RunFolderError: if a kept run is damaged; it is left as it is.
            ChildProcessError: if a process was killed.
        """
        files = self._files(runs)
        missing = [run for run, file in files.items() if not file.path.exists()]
        if missing:
            agents.check_installed()
        for number, (run, learned) in enumerate(_learn(missing, jobs), 1):
            content = tables.parquet(_rows(learned), files[run].digest, "zstd")
            replace_file(files[run].path, content)
            tell(
                f"{run.agent}, seed {run.seed}: {run.trials} trials in "
                f"{learned.seconds:.0f} s ({number} of {len(missing)})"
            )
        return [_read(files[run]) for run in runs]

    def _files(self, runs: Sequence[DeepRun]) -> dict[DeepRun, _File]:
        """Where each run is kept, and the digest of all that decides its numbers."""
        code, versions = kept.code(_CODE), installed_versions(_PACKAGES)
        files = {}
        for run in runs:
            decides = {name: str(value) for name, value in vars(run).items()}
            # Where the recording lies decides nothing.
            decides |= {"recording": self.recording, "code": code, **versions}
            digest = kept.digest(decides)
            name = f"{run.agent}-{run.seed:010d}-{digest[:16]}.parquet"
            files[run] = _File(self.folder / name, digest)
        return files


def _learn(runs: Sequence[DeepRun], jobs: int) -> Iterator[tuple[DeepRun, DeepLearned]]:
    """Runs as they end."""
    if runs:
        # Each has one thread: more of them than processors would wait for each other.
        jobs = min(jobs, len(runs), os.cpu_count() or 1)
        yield from Workers(jobs).map(_one, runs)


def _one(run: DeepRun) -> tuple[DeepRun, DeepLearned]:
    # Loaded before the clock starts.
    import sb3_contrib  # noqa: F401

    began = process_time()
    with warnings.catch_warnings():
        # The command that asked for the runs has told of a foreign recording.
        warnings.simplefilter("ignore")
        lengths = agents.train(run)
    return run, DeepLearned(lengths, process_time() - began)


def _rows(learned: DeepLearned) -> pa.Table:
    n_trials = len(learned.n_actions)
    columns = {
        "trial": np.arange(n_trials, dtype=np.int32),
        "n_actions": learned.n_actions,
        "seconds": np.full(n_trials, learned.seconds, np.float32),
    }
    return pa.table(columns, schema=_SCHEMA)


def _read(file: _File) -> DeepLearned:
    rows = tables.read_kept(file.path, _SCHEMA, file.digest)
    return DeepLearned(rows["n_actions"].to_numpy(), rows["seconds"][0].as_py())
