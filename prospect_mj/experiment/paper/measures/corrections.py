"""What is measured on corrections; see `measure`.

When a correction has disappeared the paper doesn't say, and early ones are rare from
the start. So it is asked at several fixed shares, and at several parts of a
correction's own largest share: an order that is not the same at all of them depends on
what one calls disappeared.
"""

import numpy as np

from prospect_mj.experiment.paper.measures.bootstrap import Floats
from prospect_mj.experiment.paper.measures.curves import (
    LONG,
    mean_of_sets,
    moving_means,
    ratio,
)
from prospect_mj.experiment.paper.measures.measure import Measure, measure
from prospect_mj.experiment.paper.measures.quantity import Kind
from prospect_mj.experiment.paper.measures.sample import Pair
from prospect_mj.experiment.populations.strategies import Strategy
from prospect_mj.experiment.run.learning_curve import BLOCK, settled

GONE = (0.02, 0.01, 0.005)
"""Shares of difficult trials at which a correction counts as gone. Exploration alone
makes 0.05 / 6 = 0.8 % of first grasps wrong ones, not all of which are corrected."""
FADED = (1 / 2, 1 / 4, 1 / 10)
"""Parts of its own largest share at which a correction counts as faded."""


@measure(
    Kind.POINTS,
    "Smallest lead of the optimal strategy over corrections, in single sets",
    "The smallest value, over sets of ten after the pretraining, of the share of "
    "difficult trials with the optimal strategy minus that with a correction of any "
    "kind.",
)
def smallest_lead(pair: Pair) -> Floats:
    """(b,) [1]."""
    return np.fmin.reduce(_lead(pair), axis=1)


@measure(
    Kind.POINTS,
    "Smallest lead of the optimal strategy over corrections, in means of five sets",
    "The smallest mean of the same lead over five successive sets of ten.",
)
def smallest_mean_lead(pair: Pair) -> Floats:
    """(b,) [1]."""
    return np.fmin.reduce(moving_means(_lead(pair)), axis=1)


@measure(
    Kind.POINTS,
    "Increase of corrections in the pretraining",
    "The largest mean share of corrections of any kind in five successive sets of ten "
    "of the pretraining, minus that in its first set.",
)
def pretraining_increase(pair: Pair) -> Floats:
    """(b,) [1]."""
    return _increase(_corrections(_pretraining(pair)))


@measure(
    Kind.POINTS,
    "Increase of corrections in difficult trials",
    "The largest mean share of corrections of any kind in the difficult trials of five "
    "successive sets of ten after the pretraining, minus that in the first set.",
)
def difficult_increase(pair: Pair) -> Floats:
    """(b,) [1]."""
    return _increase(_corrections(_difficult(pair)))


@measure(
    Kind.RATIO,
    "Part of the corrections left at the end of the pretraining",
    "The mean share of corrections of any kind in the last hundred trials of the "
    "pretraining, divided by the largest mean over five successive sets of ten of it.",
)
def pretraining_left(pair: Pair) -> Floats:
    """(b,) [1]."""
    return _left(_corrections(_pretraining(pair)))


@measure(
    Kind.RATIO,
    "Part of the corrections left in difficult trials at the end",
    "The mean share of corrections of any kind in the difficult ones of the last "
    "hundred trials, divided by the largest mean over five successive sets of ten "
    "after the pretraining.",
    of_end=True,
)
def difficult_left(pair: Pair) -> Floats:
    """(b,) [1]."""
    return _left(_corrections(_difficult(pair)))


@measure(
    Kind.SHARE,
    "Largest share of early corrections",
    "The largest mean share of early corrections in the difficult trials of five "
    "successive sets of ten after the pretraining.",
)
def early_largest(pair: Pair) -> Floats:
    """(b,) [1]."""
    return _largest(_difficult(pair)[:, Strategy.EARLY])


@measure(
    Kind.SHARE,
    "Largest share of late corrections",
    "The same of late corrections.",
)
def late_largest(pair: Pair) -> Floats:
    """(b,) [1]."""
    return _largest(_difficult(pair)[:, Strategy.LATE])


def gone_lag(share: float) -> Measure:
    """Trials from where early corrections are gone, at a share, to where late are."""

    def formula(pair: Pair) -> Floats:
        shares = _difficult(pair)
        return _lag(*(_gone(shares[:, kind], share) for kind in _EARLY_AND_LATE))

    percent = f"{100 * share:g} %"
    return Measure(
        f"gone_lag_{1000 * share:g}_permille",
        Kind.LAG,
        f"Late corrections outlast early ones, both gone at {percent}",
        "Trials from the first set of ten after the pretraining from which on every "
        f"set has early corrections in at most {percent} of its difficult trials, to "
        "that from which on the same is true of late ones; none if no set ever has "
        "more.",
        formula,
    )


def faded_lag(part: float) -> Measure:
    """The same at a part of each correction's own largest share."""

    def formula(pair: Pair) -> Floats:
        shares = _difficult(pair)
        return _lag(*(_faded(shares[:, kind], part) for kind in _EARLY_AND_LATE))

    return Measure(
        f"faded_lag_1_{1 / part:g}",
        Kind.LAG,
        "Late corrections outlast early ones, both faded to "
        f"1/{1 / part:g} of their own largest share",
        "Trials from the first five successive sets of ten after the pretraining from "
        "which on the mean share of early corrections in the difficult trials of five "
        f"sets stays at or below 1/{1 / part:g} of its largest value, to those from "
        "which on the same is true of late ones.",
        formula,
    )


def pretraining_lag(part: float) -> Measure:
    """Trials of the pretraining from where late corrections fade to where early do."""

    def formula(pair: Pair) -> Floats:
        shares = _pretraining(pair)
        early, late = (_faded(shares[:, kind], part) for kind in _EARLY_AND_LATE)
        return _lag(late, early)

    return Measure(
        f"pretraining_lag_1_{1 / part:g}",
        Kind.REVERSED_LAG,
        "Early corrections outlast late ones in the pretraining, both faded to "
        f"1/{1 / part:g} of their own largest share",
        "Trials from the first five successive sets of ten of the pretraining from "
        "which on the mean share of late corrections in five sets stays at or below "
        f"1/{1 / part:g} of its largest value, to those from which on the same is true "
        "of early ones.",
        formula,
    )


_EARLY_AND_LATE = Strategy.EARLY, Strategy.LATE


def _difficult(pair: Pair) -> Floats:
    """Shares (b, 4, s) of strategies in difficult trials after the pretraining."""
    return pair.dominant.difficult.strategies[:, :, pair.dominant.switch :]


def _pretraining(pair: Pair) -> Floats:
    """The same in the pretraining, all easy."""
    return pair.dominant.easy.strategies[:, :, : pair.dominant.switch]


def _corrections(shares: Floats) -> Floats:
    """Of any kind (b, s)."""
    return shares[:, Strategy.EARLY] + shares[:, Strategy.LATE]


def _lead(pair: Pair) -> Floats:
    shares = _difficult(pair)
    return shares[:, Strategy.OPTIMAL] - _corrections(shares)


def _largest(shares: Floats) -> Floats:
    return np.fmax.reduce(moving_means(shares), axis=1)


def _increase(shares: Floats) -> Floats:
    return _largest(shares) - shares[:, 0]


def _left(shares: Floats) -> Floats:
    return ratio(mean_of_sets(shares[:, -LONG:]), _largest(shares))


def _gone(shares: Floats, level: float) -> Floats:
    """Trials (b,) until shares (b, s) stay at a level; NaN if never above it."""
    gone = BLOCK * settled(shares, level)
    return np.where((shares > level).any(axis=1), gone, np.nan)


def _faded(shares: Floats, part: float) -> Floats:
    """Trials (b,) until means of five sets stay at a part of their largest."""
    means = moving_means(shares)
    largest = np.fmax.reduce(means, axis=1, keepdims=True)
    faded = BLOCK * settled(means, part * largest)
    return np.where(largest[:, 0] > 0, faded, np.nan)


def _lag(first: Floats, then: Floats) -> Floats:
    """Trials from the one to the other; NaN if either is NaN, or both are infinite."""
    with np.errstate(invalid="ignore"):
        return then - first
