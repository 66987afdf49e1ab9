"""What the published text leaves open, one choice at a time round the default.

How far a choice is from the paper is the sum of squared differences from the published
numbers that are fitted (`statements.FITTED`), each in units of a tenth of that number.
They are taken from the ranges that the statements are held to, as the paper says
"about": inside there is no difference. What is never reached is reached at the end of
the study at the soonest, so that its distance is a lower bound.

The scale of the histogram was chosen with the default's other choices. So that it
favours them less, some that fit worse are tried at other scales too: those that were
nearest to the paper among the energies 1 to 12, for each such choice.

Inside of the ranges many choices are at no distance at all, and which of them is the
nearest is chance. So each is held against the default: the default is kept as long as
no other choice of the same thing is nearer beyond doubt.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from prospect_mj.agent.features import FeatureSettings
from prospect_mj.agent.settings import LinearSettings
from prospect_mj.experiment.paper.measures.bootstrap import Floats, Interval, interval
from prospect_mj.experiment.paper.measures.measure import Measure
from prospect_mj.experiment.paper.measures.sample import Pair, Sample
from prospect_mj.experiment.paper.measures.statements import FITTED, Judgement, judge
from prospect_mj.experiment.paper.measures.target import Target
from prospect_mj.experiment.populations.scenario import PopulationSettings

_TENTH = 0.1


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
    return [
        *_readings("reading of the 303 features"),
        *_scales("scale of the histogram"),
        *_modes("supervisor mode"),
        *_initial_weights("initial weights"),
        *_bootstrapping("bootstrapping at the cap"),
        *_noises("image noise"),
    ]


def _readings(factor: str) -> Iterator[Variant]:
    for reading in ("product", "one_hot"):
        yield Variant(factor, reading, _features(reading=reading))
    for energy in (3.0, 3.4, 4.0):
        changes = _features(reading="one_hot", energy=energy)
        yield Variant(factor, f"one_hot, energy {energy:g}", changes)


def _scales(factor: str) -> Iterator[Variant]:
    for energy in (1.0, 2.0, 2.4, 3.0, 4.0):
        yield Variant(factor, f"energy {energy:g}", _features(energy=energy))
    for normalisation in ("max_bin", "unit_sum"):
        yield Variant(factor, normalisation, _features(normalisation=normalisation))


def _modes(factor: str) -> Iterator[Variant]:
    for mode, energy in (("none", None), ("safe", 3.0), ("productive", 1.9)):
        yield Variant(factor, mode, {"supervisor": mode})
        if energy is not None:
            changes = {"supervisor": mode} | _features(energy=energy)
            yield Variant(factor, f"{mode}, energy {energy:g}", changes)


def _initial_weights(factor: str) -> Iterator[Variant]:
    yield Variant(factor, "zero", _learner(initial_sd=0.0))
    for sd in (0.01, 0.02, 0.03, 0.1, 1.0, 3.0):
        yield Variant(factor, f"normal, sd {sd:g}", _learner(initial_sd=sd))
    changes = _learner(initial_sd=1.0) | _features(energy=8.0)
    yield Variant(factor, "normal, sd 1, energy 8", changes)


def _bootstrapping(factor: str) -> Iterator[Variant]:
    for choice, does in (("yes", True), ("no", False)):
        yield Variant(factor, choice, {"bootstrap_at_truncation": does})


def _noises(factor: str) -> Iterator[Variant]:
    yield Variant(factor, "none: one picture per side", {"pictures": "one_per_side"})
    yield Variant(factor, "as recorded", {"pictures": "recorded"})
    noisy = {"image_noise": 0.05}
    yield Variant(factor, "recorded, and sd 0.05 per bin", noisy)
    changes = noisy | _features(energy=2.8)
    yield Variant(factor, "recorded, and sd 0.05 per bin, energy 2.8", changes)


def _features(**changes: Any) -> dict[str, FeatureSettings]:  # noqa: ANN401
    return {"features": FeatureSettings(**changes)}


def _learner(**changes: Any) -> dict[str, LinearSettings]:  # noqa: ANN401
    return {"learner": LinearSettings(**changes)}


@dataclass(frozen=True)
class Row:
    """What a choice came to."""

    variant: Variant
    is_default: bool
    judgements: Sequence[Judgement]
    """Of every published statement."""
    distance: Interval
    """From the published numbers [1]."""
    resampled: Floats
    """(b,), the distance in every resample."""

    @property
    def fitted(self) -> list[Judgement]:
        """Of the statements that the distance is from."""
        return [judged for judged in self.judgements if judged.statement.fitted]


def measure_row(variant: Variant, is_default: bool, sample: Sample) -> Row:
    """Measure a choice.

    Args:
        variant: the choice.
        is_default: whether the default makes the same.
        sample: curves of the populations that learned with it.
    """
    far, many = distance(sample.mean)[0], distance(sample.resampled)
    return Row(variant, is_default, judge(sample), interval(far, many), many)


def distance(pair: Pair) -> Floats:
    """Sum of squared differences (b,) from the published ranges, in tenths."""
    total = np.zeros(len(pair.baseline.actions))
    for said in FITTED:
        for measure in said.measures:
            off = _off(measure, said.target, pair)
            total += (off / (_TENTH * said.target.number)) ** 2
    return total


def _off(measure: Measure, target: Target, pair: Pair) -> Floats:
    """By how much a measure is out of its range (b,), at the least."""
    values = measure(pair)
    if measure.end is not None:
        end = max(measure.end(pair), target.low)
        values = np.where(np.isinf(values), end, values)
    return values - np.clip(values, target.low, target.high)


def farther(row: Row, other: Row) -> Interval:
    """By how much a choice's distance is larger than that of another.

    The runs of all choices have the same seeds, and resamples draw the same ones, so
    that the chance which both share falls out of the difference.
    """
    difference = row.distance.estimate - other.distance.estimate
    return interval(difference, row.resampled - other.resampled)


def default_of(rows: Sequence[Row]) -> Row:
    """The default among the choices for one thing."""
    return next(row for row in rows if row.is_default)


def nearer(rows: Sequence[Row]) -> list[Row]:
    """Choices that are nearer to the paper than the default, beyond doubt."""
    default = default_of(rows)
    return [row for row in rows if farther(row, default).high < 0]


def as_good(rows: Sequence[Row]) -> list[Row]:
    """Choices that can't be told from the default, itself left out."""
    default = default_of(rows)
    others = [row for row in rows if row is not default]
    compared = [(row, farther(row, default)) for row in others]
    return [row for row, more in compared if more.low <= 0 <= more.high]


def nearest(rows: Sequence[Row]) -> Row:
    """The choice at the smallest distance, be it by chance."""
    return min(rows, key=lambda row: row.distance.estimate)


def by_factor(rows: Sequence[Row]) -> dict[str, list[Row]]:
    """The choices for each thing that is left open."""
    factors: dict[str, list[Row]] = {}
    for row in rows:
        factors.setdefault(row.variant.factor, []).append(row)
    return factors
