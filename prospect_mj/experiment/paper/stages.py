"""The agent's stages after its pretraining, to be compared with the order in infants.

The numbers of McCarty, Clifton and Collard (1999) are not at hand, so that nothing but
the order told by Wheeler, Fagg and Grupen (2002, sections 2 and 3.2) is compared.
"""

from dataclasses import dataclass

import numpy as np

from prospect_mj.experiment.learning_curve import BLOCK
from prospect_mj.experiment.paper.bands import Curves, Floats, Interval, interval
from prospect_mj.experiment.paper.sample import Sample
from prospect_mj.experiment.paper.strategies import Strategy

_LONGEST = 10
"""Sets of a stage, where there are enough."""


@dataclass(frozen=True)
class Stage:
    """Mean shares over successive sets of ten trials."""

    first: int
    """First trial."""
    last: int
    """Last trial."""
    easy_optimal: Interval
    """Share of the optimal strategy in easy trials."""
    optimal: Interval
    """The same in difficult ones."""
    early: Interval
    """Share of early corrections in difficult trials."""
    late: Interval
    """Share of late ones."""
    preference: Interval
    """Share of early ones in all corrections of difficult trials."""


def stages(sample: Sample) -> tuple[Stage, Stage, Stage]:
    """The beginning after pretraining, the height of corrections, and the end.

    Args:
        sample: of which the runs with a dominant hand are looked at. A stage is a
            hundred trials long, or a third of what there is.
    """
    mean = sample.mean.dominant
    switch, n_sets = mean.switch, mean.actions.shape[1]
    length = min(_LONGEST, (n_sets - switch) // 3)
    starts = switch, _height(mean, length), n_sets - length
    return tuple(_stage(sample, start, start + length) for start in starts)


def _height(mean: Curves, length: int) -> int:
    """First of the sets between beginning and end with most corrections."""
    shares = np.nan_to_num(mean.difficult[0])
    corrections = shares[Strategy.EARLY] + shares[Strategy.LATE]
    sums = np.convolve(corrections, np.ones(length), mode="valid")
    first, end = mean.switch + length, len(corrections) - 2 * length + 1
    return first + int(np.argmax(sums[first:end]))


def _stage(sample: Sample, start: int, end: int) -> Stage:
    """Sets `start` up to but not `end`."""
    (once, many) = (
        _shares(curves.dominant, start, end)
        for curves in (sample.mean, sample.resampled)
    )
    measured = (interval(o[0], m) for o, m in zip(once, many, strict=True))
    return Stage(BLOCK * start, BLOCK * end - 1, *measured)


def _shares(curves: Curves, start: int, end: int) -> tuple[Floats, ...]:
    """What a stage shows, each (b,), in its order."""
    easy = np.nanmean(curves.easy[:, Strategy.OPTIMAL, start:end], axis=1)
    difficult = np.nanmean(curves.difficult[:, :, start:end], axis=2)
    early, late = difficult[:, Strategy.EARLY], difficult[:, Strategy.LATE]
    both = early + late
    preference = np.divide(early, both, out=np.full_like(both, np.nan), where=both > 0)
    return easy, difficult[:, Strategy.OPTIMAL], early, late, preference
