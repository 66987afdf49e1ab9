"""The measures of development, each defined once; `MEASURES` has those of tables.

All of them are of the trials after the pretraining, in blocks of ten. Difficult trials
are those in which the lid lies away from the dominant hand, the others are easy.
Corrections are late and early ones.

The largest or smallest share of many blocks is too large or too small by chance, and
its resamples are so once more (see `paper.measures.bootstrap`): where all blocks are
alike, its interval may leave it out. For the worst block of easy trials that errs on
the side of denying what is claimed.
"""

import numpy as np

from prospect_mj.experiment.development.measures import stretches
from prospect_mj.experiment.development.measures.development import (
    Development,
    corrections,
    difficult,
    easy,
)
from prospect_mj.experiment.paper.measures.bootstrap import Floats
from prospect_mj.experiment.paper.measures.curves import LONG, Curves, mean_of_sets
from prospect_mj.experiment.paper.measures.measure import measure
from prospect_mj.experiment.paper.measures.quantity import Kind
from prospect_mj.experiment.populations.strategies import Strategy
from prospect_mj.experiment.run.learning_curve import BLOCK

GONE = 0.10
"""Share of difficult trials at or below which a correction counts as gone."""
BEGINNING = 5
"""Blocks of the beginning."""
PREVAILING = 0.5
"""Share of difficult trials above which a strategy prevails."""


@measure(
    Kind.TRIAL,
    "Late corrections gone",
    "End of the last block in which late corrections are more than 10 % of the "
    "difficult trials; none if they never are.",
)
def late_gone(curves: Curves) -> Floats:
    """(b,) [trials]."""
    return stretches.over(difficult(curves, Strategy.LATE), GONE)


@measure(
    Kind.TRIAL,
    "Early corrections gone",
    "End of the last block in which early corrections are more than 10 % of the "
    "difficult trials; none if they never are.",
)
def early_gone(curves: Curves) -> Floats:
    """(b,) [trials]."""
    return stretches.over(difficult(curves, Strategy.EARLY), GONE)


@measure(
    Kind.TRIAL,
    "Corrections dominate",
    "Longest stretch of blocks in which corrections exceed the optimal strategy in the "
    "difficult trials.",
)
def dominance(curves: Curves) -> Floats:
    """(b,) [trials]."""
    return stretches.longest(_dominated(curves))


@measure(
    Kind.TRIAL,
    "Early corrections lead",
    "Longest stretch of blocks in which corrections exceed the optimal strategy in the "
    "difficult trials, and early ones exceed late ones as well.",
)
def early_lead(curves: Curves) -> Floats:
    """(b,) [trials]."""
    early, late = (difficult(curves, kind) for kind in _EARLY_AND_LATE)
    return stretches.longest(_dominated(curves) & (early > late))


@measure(
    Kind.SHARE,
    "Largest share of late corrections",
    "The largest share of late corrections in the difficult trials of a block; as the "
    "largest of many it errs to the high side, and its interval more so.",
)
def late_most(curves: Curves) -> Floats:
    """(b,) [1]."""
    return np.fmax.reduce(difficult(curves, Strategy.LATE), axis=1)


@measure(
    Kind.SHARE,
    "Largest share of early corrections",
    "The largest share of early corrections in the difficult trials of a block; as the "
    "largest of many it errs to the high side, and its interval more so.",
)
def early_most(curves: Curves) -> Floats:
    """(b,) [1]."""
    return np.fmax.reduce(difficult(curves, Strategy.EARLY), axis=1)


@measure(
    Kind.SHARE,
    "Other at the beginning",
    "Mean share, over the first fifty trials, of difficult trials that were neither "
    "optimal nor corrected, those cut off among them.",
)
def other_first(curves: Curves) -> Floats:
    """(b,) [1]."""
    return mean_of_sets(difficult(curves, Strategy.OTHER)[:, :BEGINNING])


@measure(
    Kind.SHARE,
    "Optimal at the end",
    "Mean share of the optimal strategy in the difficult ones of the last hundred "
    "trials.",
    of_end=True,
)
def optimal_last(curves: Curves) -> Floats:
    """(b,) [1]."""
    return mean_of_sets(difficult(curves, Strategy.OPTIMAL)[:, -LONG:])


@measure(
    Kind.SHARE,
    "Worst block of easy trials",
    "The smallest share of the optimal strategy in the easy trials of a block; as the "
    "smallest of many it errs to the low side, and its interval more so.",
)
def easy_worst(curves: Curves) -> Floats:
    """(b,) [1]."""
    return np.fmin.reduce(easy(curves, Strategy.OPTIMAL), axis=1)


MEASURES = (
    late_gone,
    early_gone,
    dominance,
    early_lead,
    late_most,
    early_most,
    other_first,
    optimal_last,
    easy_worst,
)
"""In the order of tables."""

_EARLY_AND_LATE = Strategy.EARLY, Strategy.LATE


@measure(
    Kind.TRIAL,
    "Late corrections alone",
    "Blocks in which late corrections are more than a half of the difficult trials, "
    "before the first one in which early ones are more than 10 %.",
)
def late_alone(curves: Curves) -> Floats:
    """(b,) [trials]. Claims ask for it; it is in no table."""
    early, late = (difficult(curves, kind) for kind in _EARLY_AND_LATE)
    before = ~np.logical_or.accumulate(early > GONE, axis=1)
    return BLOCK * ((late > PREVAILING) & before).sum(axis=1).astype(np.float64)


def order(development: Development) -> float:
    """Share of the resamples in which late corrections are gone before early ones [1].

    Both must have been above the level once, and late ones must be gone; early ones
    that are above it to the end outlast them.
    """
    late, early = (gone(development.resampled) for gone in (late_gone, early_gone))
    return float(np.mean((late < early) & np.isfinite(late)))


def _dominated(curves: Curves) -> np.ndarray:
    return corrections(curves) > difficult(curves, Strategy.OPTIMAL)
