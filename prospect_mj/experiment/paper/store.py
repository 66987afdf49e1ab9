"""Populations that are kept on disk, so that a study goes on where it was stopped.

A file is known by the digest of all that decides its numbers: scenario, settings, the
recording's outcomes, and the code of the learner and of what is below it.
"""

import inspect
import json
import time
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from types import ModuleType

import numpy as np
import pyarrow as pa
from pyarrow.lib import ArrowException

from prospect_mj import tables
from prospect_mj.agent import features
from prospect_mj.agent.storage import replace_file
from prospect_mj.errors import ForeignTable, RunFolderError
from prospect_mj.experiment.paper import (
    kernel,
    outcome_graph,
    population,
    programme,
    strategies,
)
from prospect_mj.experiment.paper.population import Population, run_population
from prospect_mj.experiment.paper.scenario import PopulationSettings, Scenario
from prospect_mj.recording.provenance import code_digest, sha256, source_digest
from prospect_mj.recording.recording import Recording

_CODE: Sequence[ModuleType] = (
    features,
    kernel,
    outcome_graph,
    population,
    programme,
    strategies,
)
_SCHEMA = pa.schema(
    {
        "run": pa.int32(),
        "trial": pa.int32(),
        "lid": pa.int8(),
        "n_actions": pa.int8(),
        "solved": pa.bool_(),
        "strategy": pa.int8(),
    }
)
_SECONDS_SCHEMA = pa.schema({"seconds": pa.float64()})


@dataclass(frozen=True)
class Kept:
    """A population, and how long it took."""

    population: Population
    seconds: float
    """Wall time when it was computed [s]."""


class Store:
    """A folder of populations that learned from one recording.

    Args:
        folder: where they are kept; made if it isn't there.
        recording: what they learn from.
        jobs: threads.
    """

    def __init__(self, folder: Path, recording: Recording, jobs: int) -> None:
        """Open the folder."""
        folder.mkdir(parents=True, exist_ok=True)
        self._folder, self._recording, self._jobs = folder, recording, jobs
        self._base = {"recording": recording_digest(recording), "code": _code()}

    def get(self, scenario: Scenario, settings: PopulationSettings) -> Kept:
        """Read a population, or let it learn and keep it.

        Raises:
            RunFolderError: if its file is damaged; it is left as it is.
        """
        settled = {"scenario": asdict(scenario), "settings": asdict(settings)}
        digest = sha256(json.dumps(self._base | settled, sort_keys=True).encode())
        path = self._folder / f"{digest[:16]}.parquet"
        if path.exists():
            seconds = _read(_seconds_path(path), _SECONDS_SCHEMA, digest)
            rows = _read(path, _SCHEMA, digest)
            return Kept(_population(rows, scenario), seconds["seconds"][0].as_py())
        began = time.perf_counter()
        learned = run_population(self._recording, scenario, settings, self._jobs)
        kept = Kept(learned, time.perf_counter() - began)
        _write(path, digest, kept)
        return kept


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


def _code() -> str:
    """Digest of the code that decides what is learned."""
    learner = ((module.__name__, inspect.getsource(module)) for module in _CODE)
    return sha256(f"{code_digest(learner)} {source_digest()}".encode())


def _seconds_path(path: Path) -> Path:
    return path.with_name(f"{path.stem}-seconds.parquet")


def _write(path: Path, digest: str, kept: Kept) -> None:
    """Keep a population; its own file comes last, as it is what is looked for."""
    seconds = pa.table({"seconds": [kept.seconds]}, schema=_SECONDS_SCHEMA)
    replace_file(_seconds_path(path), tables.parquet(seconds, digest))
    learned = kept.population
    run, trial = np.indices(learned.lid.shape, np.int32)
    columns = {
        "run": run,
        "trial": trial,
        "lid": learned.lid,
        "n_actions": learned.n_actions,
        "solved": learned.solved,
        "strategy": learned.strategy,
    }
    rows = {name: values.ravel() for name, values in columns.items()}
    content = tables.parquet(pa.table(rows, schema=_SCHEMA), digest, "zstd")
    replace_file(path, content)


def _read(path: Path, schema: pa.Schema, digest: str) -> pa.Table:
    try:
        return tables.read(path, schema, digest, of="study")
    except ForeignTable as error:
        raise RunFolderError(str(error)) from error
    except (OSError, ArrowException) as error:
        raise RunFolderError(
            f"{path} can't be read: it is damaged; move it away and run again"
        ) from error


def _population(rows: pa.Table, scenario: Scenario) -> Population:
    shape = (-1, scenario.trials)
    names = ("lid", "n_actions", "solved", "strategy")
    columns = (rows[name].to_numpy().reshape(shape) for name in names)
    return Population(scenario, *columns)
