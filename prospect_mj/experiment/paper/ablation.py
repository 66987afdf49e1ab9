"""What the published text leaves open, one choice at a time round the default.

How far a choice is from the paper is the sum of squared differences from four published
numbers, each in units of a tenth of that number: the share of first trials cut off,
near-optimal without a dominant hand and in pretraining, and the peak after it. A number
inside of the published range has no difference. What is never reached counts as reached
at the end, so that its distance is a lower bound.
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np
import pyarrow as pa

from prospect_mj.agent.features import FeatureSettings
from prospect_mj.experiment.learning_curve import BLOCK
from prospect_mj.experiment.paper import measures, statements
from prospect_mj.experiment.paper.bands import Floats, Interval, interval
from prospect_mj.experiment.paper.sample import Measure, Pair, Sample, estimate
from prospect_mj.experiment.paper.scenario import PopulationSettings
from prospect_mj.experiment.paper.statements import Kind, Target

_TENTH = 0.1


class Published(NamedTuple):
    """A published number that choices are held against."""

    measure: Measure
    kind: Kind
    target: Target
    aim: float
    """The number itself, or the bound of its range that differences are relative to."""


PUBLISHED = {
    "first_unsolved": Published(
        measures.first_unsolved, Kind.SHARE, statements.TIMING_OUT, 0.5
    ),
    "near_optimal": Published(
        measures.near_optimal, Kind.TRIAL, statements.NEAR_OPTIMAL, 650
    ),
    "pretraining": Published(
        measures.pretraining_near_optimal, Kind.TRIAL, statements.PRETRAINED, 250
    ),
    "peak": Published(measures.peak_after_switch, Kind.ACTIONS, statements.PEAK, 6.0),
}


@dataclass(frozen=True)
class Variant:
    """One choice of one thing that the paper leaves open."""

    factor: str
    choice: str
    changes: Mapping[str, Any]
    """Settings of the population that differ from the default; none: the default."""

    def settings(self, default: PopulationSettings) -> PopulationSettings:
        """The population's settings with this choice."""
        return replace(default, **self.changes)


def variants() -> list[Variant]:
    """Every choice, the default's own among them."""
    reading, scale = "reading of the 303 features", "scale of the histogram"
    masks, begins = "supervisor mode", "initial weights"
    cap, noise = "bootstrapping at the cap", "image noise"
    energies = [
        Variant(scale, f"energy {energy:g}", _features(energy=energy))
        for energy in (1.0, 2.0, 2.4, 3.0, 4.0)
    ]
    return [
        Variant(reading, "product", _features(reading="product")),
        Variant(reading, "one_hot", _features(reading="one_hot")),
        *energies,
        Variant(scale, "max_bin", _features(normalisation="max_bin")),
        Variant(scale, "unit_sum", _features(normalisation="unit_sum")),
        Variant(masks, "none", {"supervisor": "none"}),
        Variant(masks, "safe", {"supervisor": "safe"}),
        Variant(masks, "productive", {"supervisor": "productive"}),
        Variant(begins, "zero", {"initial_sd": 0.0}),
        Variant(begins, "normal, sd 0.03", {"initial_sd": 0.03}),
        Variant(begins, "normal, sd 1", {"initial_sd": 1.0}),
        Variant(begins, "normal, sd 3", {"initial_sd": 3.0}),
        Variant(cap, "yes", {"bootstrap_at_truncation": True}),
        Variant(cap, "no", {"bootstrap_at_truncation": False}),
        Variant(noise, "none: one recorded look per side", {"presentations": 1}),
        Variant(noise, "as recorded: all looks", {"presentations": None}),
        Variant(noise, "recorded, and sd 0.05 per bin", {"image_noise": 0.05}),
    ]


def _features(**changes: Any) -> dict[str, FeatureSettings]:  # noqa: ANN401
    return {"features": FeatureSettings(**changes)}


@dataclass(frozen=True)
class Row:
    """What a choice came to."""

    variant: Variant
    is_default: bool
    measured: Mapping[str, Interval]
    """By the names of `PUBLISHED`."""
    distance: Interval
    """From the published numbers [1]."""


def measure_row(variant: Variant, is_default: bool, sample: Sample) -> Row:
    """Measure a choice.

    Args:
        variant: the choice.
        is_default: whether the default makes the same.
        sample: curves of the populations that learned with it.
    """
    measured = {name: estimate(p.measure, sample) for name, p in PUBLISHED.items()}
    far = interval(distance(sample.mean)[0], distance(sample.resampled))
    return Row(variant, is_default, measured, far)


def distance(pair: Pair) -> Floats:
    """Sum of squared differences (b,) from the published numbers, in their tenths."""
    total = np.zeros(len(pair.baseline.actions))
    ends = {
        measures.near_optimal: BLOCK * pair.baseline.actions.shape[1],
        measures.pretraining_near_optimal: BLOCK * pair.dominant.switch,
    }
    for published in PUBLISHED.values():
        reached = published.measure(pair)
        reached = np.minimum(reached, ends.get(published.measure, np.inf))
        total += (_off(reached, published) / (_TENTH * published.aim)) ** 2
    return total


def _off(values: Floats, published: Published) -> Floats:
    """How far values are from a published number, or outside of its range."""
    if published.target.near:
        return values - published.aim
    return values - np.clip(values, published.target.low, published.target.high)


def best(rows: list[Row]) -> Row:
    """The choice that is nearest to the paper."""
    return min(rows, key=lambda row: row.distance.estimate)


def as_good(rows: list[Row]) -> list[Row]:
    """Choices whose intervals reach down to that of the best one, itself among them."""
    limit = best(rows).distance.high
    return [row for row in rows if row.distance.low <= limit]


def table(rows: list[Row]) -> pa.Table:
    """All rows, a number and its interval's bounds per column."""
    plain = []
    for row in rows:
        variant = row.variant
        columns = {
            "factor": variant.factor,
            "choice": variant.choice,
            "default": row.is_default,
        }
        for name, measured in (*row.measured.items(), ("distance", row.distance)):
            names = (name, f"{name}_low", f"{name}_high")
            columns |= dict(zip(names, measured, strict=True))
        plain.append(columns)
    return pa.Table.from_pylist(plain)
