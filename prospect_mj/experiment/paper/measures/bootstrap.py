"""How sure a number is: the bootstrap over runs.

A resample draws as many runs as there are, with replacement (Efron and Tibshirani, An
Introduction to the Bootstrap, 1993, chapters 6 and 13). Percentiles are data points,
not interpolated, so that infinity, for what is never reached, may be among them.

Percentiles of the largest of several noisy means lie too high: it is too large on
average, and its resamples are so once more. So an extreme is sought among moving means
(`curves.moving_means`), where there is little noise left; but for the smallest lead in
single sets, which the paper's *never* may mean. Bias-corrected percentiles
(section 14.3) are no way out: they are too narrow for times at which a curve settles.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from prospect_mj.experiment.estimate import LEVEL

RESAMPLES = 2000
"""Of the runs, for every interval and band."""

Floats = NDArray[np.float64]


class Interval(NamedTuple):
    """An estimate with its confidence interval; NaN for what is not there."""

    estimate: float
    low: float
    high: float
    lacking: float = 0.0
    """Share of the resamples in which it is not there; the others make the bounds."""


def times_drawn(n_runs: int, rng: np.random.Generator, n: int = RESAMPLES) -> Floats:
    """How often each run is in each of n resamples, (n, n_runs); whole numbers."""
    drawn = rng.multinomial(n_runs, np.full(n_runs, 1.0 / n_runs), size=n)
    return drawn.astype(np.float64)


def interval(estimate: float, resampled: Floats) -> Interval:
    """The percentile interval of an estimate from its resamples (b,).

    A resample is NaN where it lacks what is measured.
    """
    there = resampled[~np.isnan(resampled)]
    lacking = 1.0 - len(there) / len(resampled)
    low, high = band(there) if len(there) else (np.nan, np.nan)
    return Interval(float(estimate), float(low), float(high), lacking)


def band(resampled: Floats) -> Floats:
    """Pointwise bounds (2, ...) of curves resampled along their first axis (b, ...)."""
    tail = (1 - LEVEL) / 2
    return np.quantile(resampled, [tail, 1 - tail], axis=0, method="inverted_cdf")


def median(values: Floats) -> Floats:
    """The lower median over the last axis, a data point as the percentiles are."""
    return np.quantile(values, 0.5, axis=-1, method="inverted_cdf")
