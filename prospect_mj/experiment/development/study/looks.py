"""How alike the pictures of both orientations are in a world.

Of scaled histograms, |v|^2 the same for all: the cosine of the mean ones of both
orientations, the mean cosine of two pictures of one orientation, and the noise of a
bin, the standard deviation between pictures of an orientation divided by the bin's mean
(the root of the mean square over bins, each weighted by its mean square).
"""

from collections.abc import Iterable
from typing import NamedTuple

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from prospect_mj.agent import StateFeatureGenerator
from prospect_mj.experiment.development.study.recordings import Recordings
from prospect_mj.experiment.populations.scenario import PopulationSettings
from prospect_mj.recording.hands import NUMBERS
from prospect_mj.recording.recording import Recording

Floats = NDArray[np.float64]

LOOKS_SCHEMA = pa.schema(
    {
        "world": pa.string(),
        "pictures": pa.int32(),
        "between": pa.float64(),
        "within": pa.float64(),
        "noise": pa.float64(),
    }
)
"""Cosines [1] and noise [1]; see the module."""


class Looks(NamedTuple):
    """See the module."""

    between: float
    within: float
    noise: float


def histograms(recording: Recording) -> dict[str, Floats]:
    """Scaled histograms v (n, 100) [1] of complete presentations, by orientation."""
    shown, scaled = recording.presentations, StateFeatureGenerator().scaled_histogram
    complete = recording.complete(PopulationSettings.max_actions)
    return {
        side: np.stack([scaled(shown.histogram[n]) for n in complete[found]])
        for side, lid in NUMBERS.items()
        if (found := shown.lid[complete] == lid).any()
    }


def looks(by_side: dict[str, Floats]) -> Looks:
    """Measure pictures (n, 100) of both orientations."""
    one, other = by_side.values()
    means = one.mean(axis=0), other.mean(axis=0)
    within = np.mean([_mean_cosine(rows) for rows in by_side.values()])
    noise = np.mean([_noise(rows) for rows in by_side.values()])
    return Looks(_cosine(*means), float(within), float(noise))


def table(recordings: Recordings, worlds: Iterable[str]) -> pa.Table:
    """The looks of some worlds, under `LOOKS_SCHEMA`."""
    rows = []
    for world in worlds:
        by_side = histograms(recordings.by_world[world])
        pictures = sum(map(len, by_side.values()))
        found = looks(by_side)._asdict()
        rows.append({"world": world, "pictures": pictures} | found)
    return pa.Table.from_pylist(rows, schema=LOOKS_SCHEMA)


def _cosine(one: Floats, other: Floats) -> float:
    return float(one @ other / np.linalg.norm(one) / np.linalg.norm(other))


def _mean_cosine(rows: Floats) -> float:
    """Over all pairs of different rows; 1 of a single one."""
    if len(rows) == 1:
        return 1.0
    unit = rows / np.linalg.norm(rows, axis=1, keepdims=True)
    cosines = unit @ unit.T
    return float((cosines.sum() - np.trace(cosines)) / (len(rows) * (len(rows) - 1)))


def _noise(rows: Floats) -> float:
    return float(np.sqrt(np.sum(rows.var(axis=0)) / np.sum(rows.mean(axis=0) ** 2)))
