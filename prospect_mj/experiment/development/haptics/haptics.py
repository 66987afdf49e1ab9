"""What the fingers feel of jars: grasps, their models, and which end these tell."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import pyarrow as pa

from prospect_mj.checks import check_integer
from prospect_mj.experiment.development.haptics import ends, live
from prospect_mj.experiment.development.haptics.grasp import Grasp, table
from prospect_mj.experiment.development.haptics.recorded import grasps
from prospect_mj.experiment.development.haptics.settings import HapticSettings
from prospect_mj.experiment.populations.population import MOST_JOBS
from prospect_mj.haptics import ClusterSettings, TrajectoryModels
from prospect_mj.recording.recording import Recording

FOLDER = "haptics"
"""Of live grasps, in that of the study."""


def recorded(world: str) -> str:
    """Name of the recorded jar of a world, among those that are grasped live."""
    return f"{world}, recorded"


def models_file(world: str) -> str:
    """Name of the file with the models of a world's recorded grasps."""
    return f"models_{world}.json"


@dataclass(frozen=True)
class HapticResults:
    """What came out."""

    grasps: Mapping[str, Sequence[Grasp]]
    """Of each jar; those of a recording are called `recorded`."""
    models: Mapping[str, TrajectoryModels]
    """Of the grasps of each jar."""
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
    """Grasp and cluster; live grasps that are kept are read.

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
    rng = np.random.default_rng(settings.seed)
    felt = {recorded(world): grasps(one) for world, one in recordings.items()}
    felt |= _live(folder, settings, jobs, tell)
    models = {
        jar: ends.clustered(each, settings.clusters, rng).models
        for jar, each in felt.items()
    }
    for world in recordings:
        models[recorded(world)].write(folder / FOLDER / models_file(world))
    tables = _told(felt, settings, rng), _numbers(felt, settings, rng)
    return HapticResults(felt, models, *tables)


def _told(
    felt: Mapping[str, Sequence[Grasp]],
    settings: HapticSettings,
    rng: np.random.Generator,
) -> pa.Table:
    return pa.concat_tables(
        ends.told(jar, each, settings.clusters, rng) for jar, each in felt.items()
    )


def _numbers(
    felt: Mapping[str, Sequence[Grasp]],
    settings: HapticSettings,
    rng: np.random.Generator,
) -> pa.Table:
    def clusters(n_models: int) -> ClusterSettings:
        return replace(settings.clusters, models=n_models)

    return pa.concat_tables(
        ends.numbers(jar, each, settings.most_models, clusters, rng)
        for jar, each in felt.items()
    )


def _all_grasps(felt: Mapping[str, Sequence[Grasp]]) -> pa.Table:
    """Grasps of all jars, under `grasp.SCHEMA` and the jar's name."""
    return pa.concat_tables(
        table(each).add_column(0, "jar", pa.array([jar] * len(each), pa.string()))
        for jar, each in felt.items()
    )


def _live(
    folder: Path, settings: HapticSettings, jobs: int, tell: Callable[[str], object]
) -> dict[str, list[Grasp]]:
    """The grasps of each jar; none if no jar is to be grasped."""
    per_side, seed = settings.grasped // 4, settings.seed
    return live.grasps(folder / FOLDER, per_side, seed, jobs, tell)
