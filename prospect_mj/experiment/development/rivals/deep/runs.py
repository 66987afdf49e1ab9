"""Runs of deep learners, each in a process of its own, kept as they end.

Processes are spawned, not forked: what OpenGL, torch and their threads hold in this
process would be broken in a copy of it. A run that was kept is not made again.
"""

import json
import multiprocessing
import os
import warnings
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor, as_completed
from concurrent.futures.process import BrokenProcessPool
from dataclasses import dataclass
from pathlib import Path
from time import process_time
from typing import NamedTuple

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray
from pyarrow.lib import ArrowException

from prospect_mj import paths, tables
from prospect_mj.errors import ForeignTable, RunFolderError
from prospect_mj.experiment.development.rivals.deep import agents
from prospect_mj.experiment.development.rivals.deep.agents import DeepRun
from prospect_mj.recording.provenance import code_digest, installed_versions, sha256
from prospect_mj.recording.workers import end_with
from prospect_mj.storage import make_folder, replace_file

_SCHEMA = pa.schema(
    {"trial": pa.int32(), "n_actions": pa.int16(), "seconds": pa.float32()}
)
"""A trial of a run; the processor time of the run [s] is the same in every row."""
_PACKAGES = ("torch", "stable-baselines3", "sb3-contrib", "gymnasium", "numpy")
_CODE = (
    "agent/features.py",
    "envs/trials.py",
    "experiment/development/rivals/deep/agents.py",
)


class DeepLearned(NamedTuple):
    """What a deep learner did."""

    n_actions: NDArray[np.int16]
    """(n_trials,) [actions]."""
    seconds: float
    """Processor time in which it learned, its libraries' loading aside [s]."""


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
        self, runs: Sequence[DeepRun], jobs: int, tell: Callable[[str], None]
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
        missing = [run for run in runs if not self._path(run).exists()]
        if missing:
            agents.check_installed()
        for number, (run, learned) in enumerate(_learn(missing, jobs), 1):
            content = tables.parquet(_rows(learned), self._digest(run), "zstd")
            replace_file(self._path(run), content)
            tell(
                f"{run.agent}, seed {run.seed}: {run.trials} trials in "
                f"{learned.seconds:.0f} s ({number} of {len(missing)})"
            )
        return [_read(self._path(run), self._digest(run)) for run in runs]

    def _path(self, run: DeepRun) -> Path:
        name = f"{run.agent}-{run.seed:010d}-{self._digest(run)[:16]}.parquet"
        return self.folder / name

    def _digest(self, run: DeepRun) -> str:
        """Of all that decides a run's numbers."""
        package = Path(paths.__file__).parent
        code = code_digest((n, (package / n).read_text("utf-8")) for n in _CODE)
        decides = {name: str(value) for name, value in vars(run).items()}
        decides |= installed_versions(_PACKAGES)
        decides |= {"recording": self.recording, "code": code}
        return sha256(json.dumps(decides, sort_keys=True).encode())


def _learn(runs: Sequence[DeepRun], jobs: int) -> Iterator[tuple[DeepRun, DeepLearned]]:
    """Runs as they end, each in a fresh process."""
    if not runs:
        return
    spawned = multiprocessing.get_context("spawn")
    with ProcessPoolExecutor(
        min(jobs, len(runs)), mp_context=spawned, max_tasks_per_child=1
    ) as processes:
        parent = os.getpid()
        waiting = {processes.submit(_one, run, parent): run for run in runs}
        try:
            for done in as_completed(waiting):
                yield waiting[done], done.result()
        except BrokenProcessPool as error:
            words = "a process of a deep learner was killed, or ran out of memory"
            raise ChildProcessError(words) from error
        finally:
            processes.shutdown(wait=False, cancel_futures=True)


def _one(run: DeepRun, parent: int) -> DeepLearned:
    """Let one learn, in a process that ends with its parent."""
    end_with(parent)
    # Loaded before the clock starts.
    import sb3_contrib  # noqa: F401

    began = process_time()
    with warnings.catch_warnings():
        # The command that asked for the runs has told of a foreign recording.
        warnings.simplefilter("ignore")
        lengths = agents.train(run)
    return DeepLearned(lengths, process_time() - began)


def _rows(learned: DeepLearned) -> pa.Table:
    n_trials = len(learned.n_actions)
    columns = {
        "trial": np.arange(n_trials, dtype=np.int32),
        "n_actions": learned.n_actions,
        "seconds": np.full(n_trials, learned.seconds, np.float32),
    }
    return pa.table(columns, schema=_SCHEMA)


def _read(path: Path, digest: str) -> DeepLearned:
    try:
        rows = tables.read(path, _SCHEMA, digest, of="study")
    except ForeignTable as error:
        raise RunFolderError(str(error)) from error
    except (OSError, ValueError, ArrowException) as error:
        raise RunFolderError(
            f"{path} can't be read: it is damaged; move it away and run again"
        ) from error
    return DeepLearned(rows["n_actions"].to_numpy(), rows["seconds"][0].as_py())
