"""Populations that are kept on disk, so that a study goes on where it was stopped.

A file is known by the digest of all that decides its numbers: scenario, settings, the
recording's outcomes, the code of the learner and of what is below it, and the versions
of the packages that compute them. All of it stands in the metadata of the file's
schema, as JSON, next to what the learners did in every trial, or to what was seen in
them when they had ended.
"""

import json
import time
from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pyarrow as pa

from prospect_mj import tables
from prospect_mj.agent import Learner
from prospect_mj.errors import RunFolderError
from prospect_mj.experiment.populations.digests import code, world_digest
from prospect_mj.experiment.populations.population import (
    Population,
    look_into,
    run_population,
)
from prospect_mj.experiment.populations.recorded_world import RecordedWorld
from prospect_mj.experiment.populations.scenario import PopulationSettings, Scenario
from prospect_mj.experiment.run.records import ACTION_NAMES
from prospect_mj.recording.provenance import installed_versions, sha256
from prospect_mj.recording.recording import Recording
from prospect_mj.storage import make_folder, replace_file

PACKAGES = ("numpy", "numba")
_KEPT = ("lid", "n_actions", "solved", "strategy", "first_hand")
_SCHEMA = pa.schema(
    {
        "run": pa.int32(),
        "trial": pa.int32(),
        "lid": pa.int8(),
        "n_actions": pa.int8(),
        "solved": pa.bool_(),
        "strategy": pa.int8(),
        "first_hand": pa.int8(),
        "splits": pa.list_(pa.int32()),
        "seconds": pa.float32(),
        "jobs": pa.int16(),
    }
)
"""A trial of a run, as `Population` has it, with the splits of a run in its first
trial, haptic state by haptic state, and null in the others. The wall time in which all
runs learned [s] and the threads that they had are the same in every row."""


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


@dataclass(frozen=True)
class Look:
    """What is to be seen in a learner that has ended."""

    see: Callable[[Learner], list[dict[str, Any]]]
    """Rows of it."""
    schema: pa.Schema
    """Of a row."""
    code: str
    """Digest of what sees it."""


class _File(NamedTuple):
    """Where something is kept."""

    path: Path
    digest: str
    """Of all that decides on it."""


class Store:
    """A folder of populations that begin in one world.

    Args:
        folder: where they are kept; made if it isn't there.
        recording: what they learn from.
        jobs: threads.
    """

    def __init__(
        self, folder: Path, recording: Recording | RecordedWorld, jobs: int
    ) -> None:
        """Open the folder.

        Raises:
            RunFolderError: if there is a file, or it can't be made.
        """
        make_folder(folder, RunFolderError)
        self._folder, self._world, self._jobs = (
            folder,
            RecordedWorld.of(recording),
            jobs,
        )
        self._used: set[Path] = set()
        self._codes: dict[str, str] = {}
        self._base = {
            "recording": world_digest(self._world),
            "versions": installed_versions(PACKAGES),
        }

    def get(
        self,
        scenario: Scenario,
        settings: PopulationSettings,
        then: Recording | RecordedWorld | None = None,
        tick: Callable[[], object] = lambda: None,
    ) -> Kept:
        """Read a population, or let it learn and keep it.

        Args:
            scenario: what the trials present.
            settings: of the population.
            then: the world of the scenario's last trials, if it has such.
            tick: called when a learner has ended.

        Raises:
            RunFolderError: if its file is damaged; it is left as it is.
        """
        changes = {
            "then": None if then is None else world_digest(RecordedWorld.of(then))
        }
        decides = self._decides(scenario, settings) | changes
        file = self._file("dominant" if scenario.pretrain else "baseline", decides)
        if file.path.exists():
            return _kept(tables.read_kept(file.path, _SCHEMA, file.digest), scenario)
        began, given = time.perf_counter(), (self._world, scenario, settings)
        learned = run_population(*given, self._jobs, then, tick)
        kept = Kept(learned, time.perf_counter() - began, self._jobs)
        _keep(file, _rows(kept), decides)
        return kept

    def looked_into(
        self, scenario: Scenario, settings: PopulationSettings, look: Look
    ) -> pa.Table:
        """Read what was seen in learners, or let them learn once more and look.

        Args:
            scenario: what the trials present.
            settings: of the population.
            look: what is seen in each of them.

        Returns:
            Rows of the look's schema, each with the number of its run first.

        Raises:
            RunFolderError: if its file is damaged; it is left as it is.
        """
        decides = self._decides(scenario, settings) | {"look": look.code}
        file = self._file("looked", decides)
        schema = look.schema.insert(0, pa.field("run", pa.int32()))
        if not file.path.exists():
            given = self._world, scenario, settings, look.see, self._jobs
            rows = [
                {"run": number, **row}
                for number, seen in enumerate(look_into(*given))
                for row in seen
            ]
            _keep(file, pa.Table.from_pylist(rows, schema=schema), decides)
        return tables.read_kept(file.path, schema, file.digest)

    def _decides(
        self, scenario: Scenario, settings: PopulationSettings
    ) -> dict[str, object]:
        """What decides on what is learned."""
        return {
            "scenario": asdict(scenario),
            "settings": asdict(settings),
            "code": self._code(settings.learner.name),
            **self._base,
        }

    def _file(self, kind: str, decides: Mapping[str, object]) -> _File:
        """Where something is kept; that is used from now on."""
        digest = sha256(json.dumps(decides, sort_keys=True).encode())
        file = _File(self._folder / f"{kind}-{digest[:16]}.parquet", digest)
        self._used.add(file.path)
        return file

    def _code(self, learner: str) -> str:
        """Digest of the code of a learner, by its name; taken once."""
        if learner not in self._codes:
            self._codes[learner] = code(learner)
        return self._codes[learner]

    def unused(self) -> list[Path]:
        """Files that were not asked for, such as those of older code."""
        return sorted({*self._folder.glob("*.parquet")} - self._used)


def _keep(file: _File, rows: pa.Table, decides: Mapping[str, object]) -> None:
    """Write a table, with all that decides on it in its metadata."""
    notes = {name: json.dumps(value) for name, value in decides.items()}
    replace_file(file.path, tables.parquet(rows, file.digest, "zstd", notes))


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
    splits = iter(learned.splits.reshape(len(learned.splits), -1).tolist())
    rows["splits"] = [None if n else next(splits) for n in rows["trial"].tolist()]
    return pa.table({name: rows[name] for name in _SCHEMA.names}, schema=_SCHEMA)


def _kept(rows: pa.Table, scenario: Scenario) -> Kept:
    """The population of a table."""
    shape = (-1, scenario.all_trials)
    columns = [rows[name].to_numpy().reshape(shape) for name in _KEPT]
    of_runs = rows["splits"].drop_null().to_pylist()
    splits = np.array(of_runs, np.int32).reshape(len(of_runs), -1, len(ACTION_NAMES))
    seconds, jobs = rows["seconds"][0].as_py(), rows["jobs"][0].as_py()
    return Kept(Population(scenario, *columns, splits), seconds, jobs, earlier=True)
