"""Figures with 95 % confidence intervals."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Self

import numpy as np
from numpy.typing import NDArray
from scipy import stats

LEVEL = 0.95
"""Of every interval."""

_Values = NDArray[np.number]


@dataclass(frozen=True)
class Estimate:
    """A figure with its interval; NaN for what is not there."""

    estimate: float
    low: float
    high: float

    def within(self, least: float, most: float) -> Self:
        """The same with an interval that leaves out what can't be."""
        low, high = (float(np.clip(b, least, most)) for b in (self.low, self.high))
        return replace(self, low=low, high=high)

    def words(self, digits: int, scale: float = 1.0) -> str:
        """Write it for people.

        Args:
            digits: after the point.
            scale: what it is multiplied by, such as 100 for percent.
        """
        if np.isnan(self.estimate):
            return "-"
        value, low, high = (
            f"{scale * part:.{digits}f}"
            for part in (self.estimate, self.low, self.high)
        )
        return value if np.isnan(self.low) else f"{value} ({low} to {high})"


def share(part: int, whole: int) -> Estimate:
    """A share with Wilson's interval.

    It leaves a chance where there was none: of 100 in 100 its lower bound is 96.3 %
    (Wilson, Journal of the American Statistical Association 22, 1927).
    """
    bounds = stats.binomtest(part, whole).proportion_ci(LEVEL, method="wilson")
    return Estimate(part / whole, float(bounds.low), float(bounds.high))


def clustered_share(part: int, whole: int, clusters: int) -> Estimate:
    """A share with an interval for cases that come in clusters.

    However much the cases of one cluster depend on each other: it is Wilson's interval
    of as many cases as there are clusters, (p + z^2/2n +- z (p (1 - p)/n +
    z^2/4n^2)^1/2) / (1 + z^2/n), whose n p need not be whole.

    Args:
        part: cases that count.
        whole: all cases.
        clusters: how many there are.
    """
    p, n, z = part / whole, clusters, stats.norm.ppf((1 + LEVEL) / 2)
    reach = z * np.sqrt(p * (1 - p) / n + (z / (2 * n)) ** 2)
    bounds = (p + z**2 / (2 * n) + np.array([-reach, reach])) / (1 + z**2 / n)
    return Estimate(p, *map(float, bounds)).within(0.0, 1.0)


def stratified_mean(groups: Sequence[_Values]) -> Estimate:
    """The mean over all values of some groups with Student's interval.

    How far the groups are apart is no uncertainty of it, as each was asked for. The
    degrees of freedom are those of Welch and Satterthwaite (Biometrics Bulletin 2,
    1946, equation 17). It has no width where all values of each group are equal,
    however few they are.

    Args:
        groups: values (n,) of each, two at least.
    """
    sizes = np.array([len(group) for group in groups])
    estimate = float(np.mean(np.concatenate(groups)))
    errors = sizes / sizes.sum() * [stats.sem(group) for group in groups]
    variance = np.sum(errors**2)
    if variance == 0.0:
        return Estimate(estimate, estimate, estimate)
    freedom = variance**2 / np.sum(errors**4 / (sizes - 1))
    reach = float(stats.t.ppf((1 + LEVEL) / 2, freedom) * np.sqrt(variance))
    return Estimate(estimate, estimate - reach, estimate + reach)


def mean_of_few(values: Sequence[float]) -> Estimate:
    """The mean of a few values with Student's interval.

    Args:
        values: none gives NaN for all, a single one for the bounds.
    """
    if not len(values):
        return Estimate(np.nan, np.nan, np.nan)
    low, high = band_of_few(np.reshape(values, (-1, 1)))
    return Estimate(float(np.mean(values)), float(low[0]), float(high[0]))


def band_of_few(values: _Values) -> NDArray[np.float64]:
    """Student's interval of the mean, column by column.

    Args:
        values: (r, s), a row for each run.

    Returns:
        (2, s): lower and upper bounds, NaN for a single row.
    """
    n_rows, mean = len(values), np.mean(values, axis=0)
    if n_rows == 1:
        return np.full((2, len(mean)), np.nan)
    reach = stats.t.ppf((1 + LEVEL) / 2, n_rows - 1) * stats.sem(values, axis=0)
    return np.stack([mean - reach, mean + reach])
