"""What the published text leaves open, one choice at a time round the default.

How far a choice is from the paper is the sum of squared differences from four published
numbers, each in units of a tenth of that number: the share of first trials cut off,
near-optimal without a dominant hand and in pretraining, and the peak after it. They are
taken from the ranges that the statements are held to, as the paper says "about": inside
there is no difference. What is never reached counts as reached at the end, so that its
distance is a lower bound.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np
import pyarrow as pa

from prospect_mj.agent.features import FeatureSettings
from prospect_mj.agent.settings import LearnerSettings
from prospect_mj.experiment.learning_curve import BLOCK
from prospect_mj.experiment.paper import measures, statements
from prospect_mj.experiment.paper.bands import Floats, Interval, interval
from prospect_mj.experiment.paper.quantity import Kind
from prospect_mj.experiment.paper.sample import Measure, Pair, Sample, estimate
from prospect_mj.experiment.paper.scenario import PopulationSettings
from prospect_mj.experiment.paper.target import Target

_TENTH = 0.1
_ONE_LOOK = "none: one recorded look per side (also one place and one lamp)"


class Published(NamedTuple):
    """A published number that choices are held against."""

    measure: Measure
    kind: Kind
    target: Target
    number: float
    """The number itself, or the bound of its range: differences are relative to it."""


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
    drawn = [
        Variant(begins, f"normal, sd {sd:g}", _learner(initial_sd=sd))
        for sd in (0.01, 0.02, 0.03, 0.1, 1.0, 3.0)
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
        Variant(begins, "zero", _learner(initial_sd=0.0)),
        *drawn,
        Variant(cap, "yes", {"bootstrap_at_truncation": True}),
        Variant(cap, "no", {"bootstrap_at_truncation": False}),
        Variant(noise, _ONE_LOOK, {"presentations": 1}),
        Variant(noise, "as recorded: all looks", {"presentations": None}),
        Variant(noise, "recorded, and sd 0.05 per bin", {"image_noise": 0.05}),
    ]


def _features(**changes: Any) -> dict[str, FeatureSettings]:  # noqa: ANN401
    return {"features": FeatureSettings(**changes)}


def _learner(**changes: Any) -> dict[str, LearnerSettings]:  # noqa: ANN401
    return {"learner": LearnerSettings(**changes)}


@dataclass(frozen=True)
class Row:
    """What a choice came to."""

    variant: Variant
    is_default: bool
    measured: Mapping[str, Interval]
    """By the names of `PUBLISHED`."""
    distance: Interval
    """From the published numbers [1]."""
    resampled: Floats
    """(b,), the distance in every resample."""


def measure_row(variant: Variant, is_default: bool, sample: Sample) -> Row:
    """Measure a choice.

    Args:
        variant: the choice.
        is_default: whether the default makes the same.
        sample: curves of the populations that learned with it.
    """
    measured = {name: estimate(p.measure, sample) for name, p in PUBLISHED.items()}
    far, many = distance(sample.mean)[0], distance(sample.resampled)
    return Row(variant, is_default, measured, interval(far, many), many)


def distance(pair: Pair) -> Floats:
    """Sum of squared differences (b,) from the published ranges, in tenths."""
    total = np.zeros(len(pair.baseline.actions))
    ends = {
        measures.near_optimal: BLOCK * pair.baseline.actions.shape[1],
        measures.pretraining_near_optimal: BLOCK * pair.dominant.switch,
    }
    for published in PUBLISHED.values():
        reached = published.measure(pair)
        reached = np.minimum(reached, ends.get(published.measure, np.inf))
        off = reached - np.clip(reached, published.target.low, published.target.high)
        total += (off / (_TENTH * published.number)) ** 2
    return total


def best(rows: Sequence[Row]) -> Row:
    """The choice that is nearest to the paper; of equal ones that which is surer."""
    return min(rows, key=lambda row: (row.distance.estimate, row.distance.high))


def farther(row: Row, other: Row) -> Interval:
    """By how much a choice's distance is larger than that of another.

    The runs of all choices have the same seeds, and resamples the same weights, so that
    the chance which both share falls out of the difference.
    """
    difference = row.distance.estimate - other.distance.estimate
    return interval(difference, row.resampled - other.resampled)


def as_good(rows: Sequence[Row]) -> list[Row]:
    """Choices that can't be told from the best one, itself among them."""
    nearest = best(rows)
    return [row for row in rows if farther(row, nearest).low <= 0]


def by_factor(rows: Sequence[Row]) -> dict[str, list[Row]]:
    """The choices for each thing that is left open."""
    factors: dict[str, list[Row]] = {}
    for row in rows:
        factors.setdefault(row.variant.factor, []).append(row)
    return factors


def table(rows: Sequence[Row]) -> pa.Table:
    """All rows, a number and its interval's bounds per column."""
    return pa.Table.from_pylist(
        [
            _columns(row, best(choices))
            for choices in by_factor(rows).values()
            for row in choices
        ]
    )


def _columns(row: Row, nearest: Row) -> dict[str, object]:
    """A row of the table; `nearest` is the best choice of the same factor."""
    columns: dict[str, object] = {
        "factor": row.variant.factor,
        "choice": row.variant.choice,
        "default": row.is_default,
    }
    beside = {"distance": row.distance, "farther": farther(row, nearest)}
    for name, measured in {**row.measured, **beside}.items():
        names = (name, f"{name}_low", f"{name}_high")
        columns |= dict(zip(names, measured[:3], strict=True))
    return columns
