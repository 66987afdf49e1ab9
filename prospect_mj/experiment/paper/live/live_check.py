"""Live physics against recorded: do live runs lie among those of the same size?

As many recorded runs as there are live ones are drawn again and again, and their mean
taken. With m and s the mean and standard deviation of these means in each set of ten
trials, 95 % of them have

    max over sets |mean - m| / s <= c ,

so that m +- c s is a simultaneous 95 % band of the mean (the studentised maximum; for
instance Montiel Olea and Plagborg-Moller, Journal of Applied Econometrics 34, 2019). If
live runs were of the same kind, their mean would leave it anywhere in 5 % of studies.
"""

from dataclasses import dataclass

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from prospect_mj.experiment.paper.live.live_folders import FoundRuns
from prospect_mj.experiment.paper.measures.bootstrap import LEVEL, RESAMPLES, Floats
from prospect_mj.experiment.paper.measures.curves import in_sets
from prospect_mj.experiment.populations.population import Population
from prospect_mj.experiment.run.learning_curve import BLOCK

SCHEMA = pa.schema(
    {
        "trial": pa.int32(),
        "live": pa.float64(),
        "recorded": pa.float64(),
        "low": pa.float64(),
        "high": pa.float64(),
    }
)
"""A set of ten trials: its first trial, mean actions of the live runs, of all recorded
runs, the simultaneous band of means of as many recorded runs."""

EXPECTED = 20
"""Live runs. The band of fewer is so wide that to be inside says little."""


@dataclass(frozen=True)
class Band:
    """What the mean of so many curves is like, from n means of them."""

    centre: Floats
    """(s,), mean of the means."""
    spread: Floats
    """(s,), their standard deviation."""
    largest: Floats
    """(n,), how far each is from `centre` in the set where it is farthest [standard
    deviations]."""

    @property
    def reach(self) -> float:
        """How far the band reaches to either side [standard deviations]."""
        return float(np.quantile(self.largest, LEVEL))

    @property
    def bounds(self) -> Floats:
        """(2, s), lower and upper ones."""
        return self.centre + np.outer([-self.reach, self.reach], self.spread)

    def p_value(self, deviation: float) -> float:
        """Chance that a mean of such curves is as far away, or farther.

        The mean in question counts as one of them (Davison and Hinkley, Bootstrap
        Methods and their Application, 1997, section 4.2), so that it is never zero.
        """
        as_far = np.count_nonzero(self.largest >= deviation)
        return (1 + as_far) / (1 + len(self.largest))


@dataclass(frozen=True)
class Deviation:
    """How far the mean of live runs is from recorded ones."""

    inside: float
    """Share of sets in which it is inside of the band."""
    largest: float
    """In the set where it is farthest away [standard deviations of such means]."""
    reach: float
    """How far the band reaches [standard deviations of such means]."""
    p_value: float
    """Chance that so many recorded runs are as far away, or farther."""


@dataclass(frozen=True)
class LiveCheck:
    """How live runs compare with recorded ones."""

    table: pa.Table
    """Under `SCHEMA`."""
    runs: int
    """Live runs compared."""
    unfinished: int
    """Live runs left out, as they have too few trials yet."""
    deviation: Deviation | None
    """None without a run to compare."""

    @property
    def not_begun(self) -> int:
        """Live runs that are still missing."""
        return max(EXPECTED - self.runs - self.unfinished, 0)

    @property
    def agrees(self) -> bool | None:
        """Whether the mean is inside of the band everywhere; None with too few runs."""
        if self.deviation is None or self.runs < EXPECTED:
            return None
        return self.deviation.largest <= self.deviation.reach


def check(live: FoundRuns, recorded: Population, rng: np.random.Generator) -> LiveCheck:
    """Hold the mean of live runs against the band of recorded ones.

    Args:
        live: what was found; without a complete run nothing is compared.
        recorded: learners of the same scenario and settings.
        rng: for resampling.
    """
    n_runs = len(live.n_actions)
    if not n_runs:
        return LiveCheck(SCHEMA.empty_table(), 0, live.unfinished, None)
    # Whole numbers of actions: sums of them are exact, and equal where they should be.
    curves = _actions_per_set(recorded.n_actions)
    band = band_of_sums(curves, n_runs, rng)
    total = _actions_per_set(live.n_actions).sum(axis=0)
    deviations = scaled(total, band.centre, band.spread)
    table = _table(total, curves, band, n_runs)
    largest = float(deviations.max())
    inside = float(np.mean(deviations <= band.reach))
    deviation = Deviation(inside, largest, band.reach, band.p_value(largest))
    return LiveCheck(table, n_runs, live.unfinished, deviation)


def band_of_sums(
    curves: Floats, size: int, rng: np.random.Generator, n: int = RESAMPLES
) -> Band:
    """What sums of some of the curves are like; see the module.

    Args:
        curves: (runs, s).
        size: curves per sum.
        rng: draws them.
        n: number of sums.
    """
    drawn = rng.integers(len(curves), size=(n, size))
    sums = np.stack([curves[rows].sum(axis=0) for rows in drawn])
    centre, spread = sums.mean(axis=0), sums.std(axis=0)
    return Band(centre, spread, scaled(sums, centre, spread).max(axis=1))


def scaled(values: Floats, centre: Floats, spread: Floats) -> Floats:
    """|values - centre| / spread; without any spread 0 where they are equal, or inf."""
    away = np.abs(values - centre)
    alone = np.where(away > 0, np.inf, 0.0)
    return np.divide(away, spread, out=alone, where=spread > 0)


def _actions_per_set(n_actions: NDArray[np.integer]) -> NDArray[np.int64]:
    """(runs, sets) from (runs, trials)."""
    return in_sets(n_actions).sum(axis=2, dtype=np.int64)


def _table(
    total: NDArray[np.int64], curves: NDArray[np.int64], band: Band, n_runs: int
) -> pa.Table:
    """All means per trial."""
    low, high = band.bounds / (n_runs * BLOCK)
    columns = {
        "trial": BLOCK * np.arange(len(total)),
        "live": total / (n_runs * BLOCK),
        "recorded": curves.mean(axis=0) / BLOCK,
        "low": low,
        "high": high,
    }
    return pa.table(columns, schema=SCHEMA)
