"""What the fingers feel of jars: grasps, their models, and which end these tell."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import NamedTuple

import pyarrow as pa

from prospect_mj.checks import check_integer
from prospect_mj.experiment.development.haptics import ends, live
from prospect_mj.experiment.development.haptics.grasp import Grasp, table
from prospect_mj.experiment.development.haptics.recorded import grasps
from prospect_mj.experiment.development.haptics.settings import JARS, HapticSettings
from prospect_mj.experiment.populations.population import MOST_JOBS
from prospect_mj.haptics import TrajectoryModels
from prospect_mj.recording.recording import Recording
from prospect_mj.recording.workers import Workers

FOLDER = "haptics"
"""Of live grasps, in that of the study."""


def models_file(world: str) -> str:
    """Name of the file with the models of a world's recorded grasps."""
    return f"models_{world}.json"


@dataclass(frozen=True)
class HapticResults:
    """What came out."""

    grasps: Mapping[str, Sequence[Grasp]]
    """Of each jar, by its world: recorded ones, or live ones where none are."""
    models: Mapping[str, TrajectoryModels]
    """Of the grasps of each jar."""
    others: Mapping[str, Mapping[int, TrajectoryModels]]
    """Of each jar, by their number: other numbers of models, from two."""
    told: pa.Table
    """Under `ends.TOLD`: how often the end is told right, by what."""
    numbers: pa.Table
    """Under `ends.NUMBERS`: what other numbers of models come to."""

    @property
    def tables(self) -> dict[str, pa.Table]:
        """All of them, by the name of their file."""
        return {
            "haptics_grasps": _all_grasps(self.grasps),
            "haptics_told": self.told,
            "haptics_numbers": self.numbers,
        }


def run(
    folder: Path,
    recordings: Mapping[str, Recording],
    settings: HapticSettings | None = None,
    jobs: int = 1,
    tell: Callable[[str], object] = print,
) -> HapticResults:
    """Cluster what was felt; the jars of no recording are grasped live, or read.

    Args:
        folder: of the study; live grasps are kept in `haptics` in it, the models of
            the recorded ones beside them.
        recordings: with what was felt, by the names of their worlds.
        settings: of the study.
        jobs: processes side by side.
        tell: takes a line for people now and then.

    Raises:
        RecordingError: if a recording has no grasps, or too few of an end.
        RenderingUnavailable: if jars are to be grasped and there is no OpenGL.
        RunFolderError: if a kept file is damaged.
        ChildProcessError: if a process was killed.
    """
    settings = HapticSettings() if settings is None else settings
    check_integer("jobs", jobs, 1, MOST_JOBS)
    felt = {world: grasps(one) for world, one in recordings.items()}
    others = [jar for jar in JARS if jar not in recordings]
    felt |= live.grasps(folder / FOLDER, others, settings, jobs, tell)
    found = _all_found(felt, settings, jobs)
    own = settings.clusters.models
    models = {jar: one.models[own] for jar, one in found.items()}
    others = {
        jar: {n: each for n, each in one.models.items() if n not in (1, own)}
        for jar, one in found.items()
    }
    for world in recordings:
        models[world].write(folder / FOLDER / models_file(world))
    told = pa.concat_tables(one.told for one in found.values())
    numbers = pa.concat_tables(one.numbers for one in found.values())
    return HapticResults(felt, models, others, told, numbers)


class _Given(NamedTuple):
    """What is clustered in one process."""

    jar: str
    felt: Sequence[Grasp]
    settings: HapticSettings


class _Found(NamedTuple):
    """What came out of the grasps of one jar, as in `HapticResults`."""

    models: dict[int, TrajectoryModels]
    """By their number."""
    told: pa.Table
    numbers: pa.Table


def _all_found(
    felt: Mapping[str, Sequence[Grasp]], settings: HapticSettings, jobs: int
) -> dict[str, _Found]:
    """What came out of each jar's grasps, in the order of the jars."""
    given = [_Given(jar, each, settings) for jar, each in felt.items()]
    made = dict(Workers(min(jobs, len(given))).map(_found, given))
    return {jar: made[jar] for jar in felt}


def _found(given: _Given) -> tuple[str, _Found]:
    """A jar, and what came out of its grasps."""
    jar, felt, settings = given
    clusters = settings.clusters
    whole, tried, halves = settings.rng(jar).spawn(3)
    surely = replace(clusters, starts=settings.starts)
    most = min(settings.most_models, len(felt))
    fits = {
        n: ends.clustered(felt, replace(surely, models=n), whole)
        for n in sorted({*range(1, most + 1), clusters.models})
    }
    return jar, _Found(
        {n: one.models for n, one in fits.items()},
        ends.told(jar, felt, clusters, tried),
        ends.numbers(jar, felt, fits, clusters, halves),
    )


def _all_grasps(felt: Mapping[str, Sequence[Grasp]]) -> pa.Table:
    """Grasps of all jars, under `grasp.SCHEMA` and the jar's name."""
    return pa.concat_tables(
        table(each).add_column(0, "jar", pa.array([jar] * len(each), pa.string()))
        for jar, each in felt.items()
    )
