"""Means over runs in sets of ten trials, and how sure they are: bootstrap over runs.

A resample draws as many runs as there are, with replacement (Efron and Tibshirani, An
Introduction to the Bootstrap, 1993, chapters 6 and 13). Percentiles are data points,
not interpolated, so that infinity, for what is never reached, may be among them.
"""

from dataclasses import dataclass
from typing import NamedTuple, Self

import numpy as np
from numpy.typing import NDArray

from prospect_mj.experiment.learning_curve import BLOCK
from prospect_mj.experiment.paper.population import Population
from prospect_mj.experiment.paper.strategies import Grip, Strategy, easy, first_grip

LEVEL = 0.95
"""Of every interval and band."""
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


@dataclass(frozen=True)
class Curves:
    """Means over runs, b times resampled, of s sets of ten trials."""

    actions: Floats
    """(b, s) [actions] per trial."""
    unsolved: Floats
    """(b, s), share of trials cut off."""
    easy: Floats
    """(b, 4, s), share of each `Strategy` in easy trials; NaN without such trials."""
    difficult: Floats
    """(b, 4, s), the same in the difficult trials."""
    easy_grips: Floats
    """(b, 2, s), share of each `Grip` in the first grasps of easy trials; NaN without
    any."""
    difficult_grips: Floats
    """(b, 2, s), the same in the difficult trials."""
    switch: int
    """Sets of pretraining."""


@dataclass(frozen=True)
class RunCounts:
    """What is counted in each of r runs and s sets of ten trials."""

    actions: Floats
    """(r, s) [actions] per trial."""
    unsolved: Floats
    """(r, s), share of trials cut off."""
    easy: Floats
    """(r, 4, s), easy trials with each `Strategy`."""
    difficult: Floats
    """(r, 4, s), difficult trials with each."""
    easy_grips: Floats
    """(r, 2, s), easy trials that begin with each `Grip`."""
    difficult_grips: Floats
    """(r, 2, s), difficult trials that do."""
    switch: int
    """Sets of pretraining."""

    @classmethod
    def of(cls, population: Population) -> Self:
        """Count; trials that don't fill a last set are left out."""
        is_easy = easy(population.lid, population.scenario.dominant)
        used = [population.strategy == strategy for strategy in Strategy]
        grip = first_grip(population.lid, population.first_hand)
        began = [grip == kind for kind in Grip]
        return cls(
            actions=in_sets(population.n_actions).mean(axis=2),
            unsolved=in_sets(~population.solved).mean(axis=2),
            easy=_counts([was & is_easy for was in used]),
            difficult=_counts([was & ~is_easy for was in used]),
            easy_grips=_counts([was & is_easy for was in began]),
            difficult_grips=_counts([was & ~is_easy for was in began]),
            switch=population.scenario.pretrain // BLOCK,
        )

    def mean(self) -> Curves:
        """The curves of all runs, b = 1."""
        n_runs = len(self.actions)
        return self.weighted(np.full((1, n_runs), 1.0 / n_runs))

    def weighted(self, weights: Floats) -> Curves:
        """Means with the weights (b, r) of the runs."""
        return Curves(
            weights @ self.actions,
            weights @ self.unsolved,
            _shares(weights, self.easy),
            _shares(weights, self.difficult),
            _shares(weights, self.easy_grips),
            _shares(weights, self.difficult_grips),
            self.switch,
        )


def resampling_weights(
    n_runs: int, rng: np.random.Generator, n: int = RESAMPLES
) -> Floats:
    """Weights (n, n_runs) of the runs in n resamples; each row adds up to one."""
    drawn = rng.multinomial(n_runs, np.full(n_runs, 1.0 / n_runs), size=n)
    return drawn / n_runs


def in_sets(values: NDArray[np.generic]) -> NDArray[np.generic]:
    """Trials (runs, trials) in sets of ten, (runs, sets, 10)."""
    n_runs, n_trials = values.shape
    n_sets = n_trials // BLOCK
    return values[:, : n_sets * BLOCK].reshape(n_runs, n_sets, BLOCK)


def mean_of_sets(shares: Floats) -> Floats:
    """Mean over sets, the last axis, that have what a share is of; NaN if none has."""
    there = ~np.isnan(shares)
    n_there = there.sum(axis=-1)
    total = np.where(there, shares, 0.0).sum(axis=-1)
    return np.divide(total, n_there, out=np.full_like(total, np.nan), where=n_there > 0)


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


def _counts(masks: list[NDArray[np.bool_]]) -> Floats:
    """Trials per run, mask and set."""
    counted = [in_sets(mask).sum(axis=2) for mask in masks]
    return np.stack(counted, axis=1).astype(np.float64)


def _shares(weights: Floats, counts: Floats) -> Floats:
    """Shares (b, k, s) from weights (b, r) of the runs and their counts (r, k, s)."""
    totals = np.tensordot(weights, counts, axes=1)
    trials = totals.sum(axis=1, keepdims=True)
    shares = np.full_like(totals, np.nan)
    return np.divide(totals, trials, out=shares, where=trials > 0)
