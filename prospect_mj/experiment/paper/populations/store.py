"""Populations that are kept on disk, so that a study goes on where it was stopped.

A file is known by the digest of all that decides its numbers: scenario, settings, the
recording's outcomes, the code of the learner and of what is below it, and the versions
of the packages that compute them. All of it stands in the metadata of the file's
schema, as JSON, next to what the learners did in every trial.
"""

import json
import time
from dataclasses import asdict, dataclass, fields
from pathlib import Path

import numpy as np
import pyarrow as pa
from pyarrow.lib import ArrowException

from prospect_mj import paths, tables
from prospect_mj.errors import ForeignTable, RunFolderError
from prospect_mj.experiment.paper.populations.population import (
    Population,
    run_population,
)
from prospect_mj.experiment.paper.populations.scenario import (
    PopulationSettings,
    Scenario,
)
from prospect_mj.experiment.run.fingerprint import LEARNER_CODE
from prospect_mj.recording.provenance import (
    code_digest,
    installed_versions,
    sha256,
    source_digest,
)
from prospect_mj.recording.recording import Recording
from prospect_mj.storage import make_folder, replace_file

CODE = (
    *LEARNER_CODE,
    "experiment/paper/populations/compiled_learner.py",
    "experiment/paper/populations/kernel.py",
    "experiment/paper/populations/outcome_graph.py",
    "experiment/paper/populations/population.py",
    "experiment/paper/populations/programme.py",
    "experiment/paper/populations/scenario.py",
    "experiment/paper/populations/strategies.py",
    "recording/choices.py",
)
"""Files of the package, beside all code below the learner."""
PACKAGES = ("numpy", "numba")
_KEPT = [field.name for field in fields(Population) if field.name != "scenario"]
_SCHEMA = pa.schema(
    {
        "run": pa.int32(),
        "trial": pa.int32(),
        "lid": pa.int8(),
        "n_actions": pa.int8(),
        "solved": pa.bool_(),
        "strategy": pa.int8(),
        "first_hand": pa.int8(),
        "seconds": pa.float32(),
        "jobs": pa.int16(),
    }
)
"""A trial of a run, as `Population` has it; the wall time in which all runs learned [s]
and the threads that they had are the same in every row."""


@dataclass(frozen=True)
class Kept:
    """A population, and how long it took."""

    population: Population
    seconds: float
    """Wall time when it was computed [s]."""
    jobs: int
    """Threads that it had then."""
    earlier: bool = False
    """Whether that was in an earlier command."""


class Store:
    """A folder of populations that learned from one recording.

    Args:
        folder: where they are kept; made if it isn't there.
        recording: what they learn from.
        jobs: threads.
    """

    def __init__(self, folder: Path, recording: Recording, jobs: int) -> None:
        """Open the folder.

        Raises:
            RunFolderError: if there is a file, or it can't be made.
        """
        make_folder(folder, RunFolderError)
        self._folder, self._recording, self._jobs = folder, recording, jobs
        self._used: set[Path] = set()
        self._base = {
            "recording": recording_digest(recording),
            "code": code(),
            "versions": installed_versions(PACKAGES),
        }

    def get(self, scenario: Scenario, settings: PopulationSettings) -> Kept:
        """Read a population, or let it learn and keep it.

        Raises:
            RunFolderError: if its file is damaged; it is left as it is.
        """
        decides = {"scenario": asdict(scenario), "settings": asdict(settings)}
        decides |= self._base
        digest = sha256(json.dumps(decides, sort_keys=True).encode())
        kind = "dominant" if scenario.pretrain else "baseline"
        path = self._folder / f"{kind}-{digest[:16]}.parquet"
        self._used.add(path)
        if path.exists():
            return _kept(_read(path, digest), scenario)
        began = time.perf_counter()
        learned = run_population(self._recording, scenario, settings, self._jobs)
        kept = Kept(learned, time.perf_counter() - began, self._jobs)
        notes = {name: json.dumps(value) for name, value in decides.items()}
        replace_file(path, tables.parquet(_rows(kept), digest, "zstd", notes))
        return kept

    def unused(self) -> list[Path]:
        """Files that were not asked for, such as those of older code."""
        return sorted({*self._folder.glob("*.parquet")} - self._used)


def recording_digest(recording: Recording) -> str:
    """One digest of what can be learned from a recording, as far as it has grown."""
    nodes, shown = recording.nodes, recording.presentations
    arrays = (
        nodes.child,
        nodes.situation,
        nodes.inserted,
        nodes.holding,
        nodes.predicates,
        shown.root,
        shown.lid,
        shown.histogram,
        shown.depth,
    )
    parts = [recording.key.digest]
    parts += [sha256(np.ascontiguousarray(array).tobytes()) for array in arrays]
    return sha256(json.dumps(parts).encode())


def code(package: Path = Path(paths.__file__).parent) -> str:
    """Digest of the code of this package that decides what is learned."""
    learner = ((name, (package / name).read_text("utf-8")) for name in CODE)
    return sha256(f"{code_digest(learner)} {source_digest()}".encode())


def _rows(kept: Kept) -> pa.Table:
    """A population as a table."""
    learned = kept.population
    shape = learned.lid.shape
    run, trial = np.indices(shape, np.int32)
    columns = {
        "run": run,
        "trial": trial,
        **{name: getattr(learned, name) for name in _KEPT},
        "seconds": np.full(shape, kept.seconds, np.float32),
        "jobs": np.full(shape, kept.jobs, np.int16),
    }
    rows = {name: values.ravel() for name, values in columns.items()}
    return pa.table(rows, schema=_SCHEMA)


def _read(path: Path, digest: str) -> pa.Table:
    try:
        return tables.read(path, _SCHEMA, digest, of="study")
    except ForeignTable as error:
        raise RunFolderError(str(error)) from error
    except (OSError, ValueError, ArrowException) as error:
        raise RunFolderError(
            f"{path} can't be read: it is damaged; move it away and run again"
        ) from error


def _kept(rows: pa.Table, scenario: Scenario) -> Kept:
    """The population of a table."""
    shape = (-1, scenario.trials)
    columns = (rows[name].to_numpy().reshape(shape) for name in _KEPT)
    seconds, jobs = rows["seconds"][0].as_py(), rows["jobs"][0].as_py()
    return Kept(Population(scenario, *columns), seconds, jobs, earlier=True)
