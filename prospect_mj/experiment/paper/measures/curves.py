"""Means over runs in sets of ten trials.

Runs are counted and resampled in whole numbers, which float64 holds exactly, and
divided once: a mean of just 2.4 actions in a set is 2.4 on every machine, whatever
order its matrix product adds up in. Means over several sets are rounded.
"""

from dataclasses import dataclass
from typing import Self

import numpy as np
from numpy.typing import NDArray

from prospect_mj.experiment.paper.measures.bootstrap import Floats
from prospect_mj.experiment.populations.population import Population
from prospect_mj.experiment.populations.strategies import (
    Grip,
    Strategy,
    easy,
    first_grip,
)
from prospect_mj.experiment.run.learning_curve import BLOCK

SMOOTHED = 5
"""Sets per moving mean where an extreme is sought: the largest or smallest of so many
single sets is the one with most noise."""
LONG = 10
"""Sets of the hundred trials before a change, or at the end."""


@dataclass(frozen=True)
class OfKind:
    """Means over the trials of a kind, easy or difficult; NaN without such trials."""

    actions: Floats
    """(b, s) [actions] per trial."""
    strategies: Floats
    """(b, 4, s), share of each `Strategy`."""
    grips: Floats
    """(b, 2, s), share of each `Grip` in the first grasps."""


@dataclass(frozen=True)
class Curves:
    """Means over runs, b times resampled, of s sets of ten trials."""

    actions: Floats
    """(b, s) [actions] per trial."""
    unsolved: Floats
    """(b, s), share of trials cut off."""
    easy: OfKind
    difficult: OfKind
    switch: int
    """Sets of pretraining."""

    def middle(self, numbers: NDArray[np.intp]) -> Floats:
        """Trials in the middle of moving means after the pretraining, by number."""
        length = min(SMOOTHED, self.actions.shape[1] - self.switch)
        return BLOCK * (self.switch + numbers + length / 2)


@dataclass(frozen=True)
class KindCounts:
    """What is counted in the trials of a kind, easy or difficult; whole numbers."""

    actions: Floats
    """(r, s) [actions]."""
    strategies: Floats
    """(r, 4, s), trials with each `Strategy`."""
    grips: Floats
    """(r, 2, s), trials that begin with each `Grip`."""

    @classmethod
    def of(cls, population: Population, of_kind: NDArray[np.bool_]) -> Self:
        """Count the trials of a kind (runs, trials)."""
        grip = first_grip(population.lid, population.first_hand)
        used = [of_kind & (population.strategy == strategy) for strategy in Strategy]
        began = [of_kind & (grip == kind) for kind in Grip]
        actions = _sums(population.n_actions * of_kind)
        return cls(actions, _counts(used), _counts(began))

    def drawn(self, times: Floats) -> OfKind:
        """Means where each run is there so many times (b, r)."""
        trials = times @ self.strategies.sum(axis=1)
        return OfKind(
            ratio(times @ self.actions, trials),
            _shares(times, self.strategies),
            _shares(times, self.grips),
        )


@dataclass(frozen=True)
class RunCounts:
    """What is counted in each of r runs and s sets of ten trials; whole numbers."""

    actions: Floats
    """(r, s) [actions]."""
    unsolved: Floats
    """(r, s), trials cut off."""
    easy: KindCounts
    difficult: KindCounts
    switch: int
    """Sets of pretraining."""

    @classmethod
    def of(cls, population: Population) -> Self:
        """Count; trials that don't fill a last set are left out."""
        is_easy = easy(population.lid, population.scenario.dominant)
        return cls(
            actions=_sums(population.n_actions),
            unsolved=_sums(~population.solved),
            easy=KindCounts.of(population, is_easy),
            difficult=KindCounts.of(population, ~is_easy),
            switch=population.scenario.pretrain // BLOCK,
        )

    def mean(self) -> Curves:
        """The curves of all runs, b = 1."""
        return self.drawn(np.ones((1, len(self.actions))))

    def drawn(self, times: Floats) -> Curves:
        """Means where each run is there so many times (b, r)."""
        trials = BLOCK * times.sum(axis=1, keepdims=True)
        return Curves(
            times @ self.actions / trials,
            times @ self.unsolved / trials,
            self.easy.drawn(times),
            self.difficult.drawn(times),
            self.switch,
        )


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


def ratio(values: Floats, references: Floats) -> Floats:
    """NaN unless the reference is above zero and finite."""
    usable = np.isfinite(references) & (references > 0)
    return np.divide(values, references, out=np.full_like(values, np.nan), where=usable)


def moving_means(shares: Floats) -> Floats:
    """Means (b, s - 4) over five successive sets of shares (b, s), or over all."""
    length = min(SMOOTHED, shares.shape[1])
    windows = np.lib.stride_tricks.sliding_window_view(shares, length, axis=1)
    return mean_of_sets(windows)


def _sums(values: NDArray[np.generic]) -> Floats:
    """Sums (runs, sets) over the trials of each set."""
    return in_sets(values).sum(axis=2).astype(np.float64)


def _counts(masks: list[NDArray[np.bool_]]) -> Floats:
    """Trials per run, mask and set."""
    return np.stack([_sums(mask) for mask in masks], axis=1)


def _shares(times: Floats, counts: Floats) -> Floats:
    """Shares (b, k, s) of counts (r, k, s), each run there so many times (b, r)."""
    totals = np.tensordot(times, counts, axes=1)
    trials = totals.sum(axis=1, keepdims=True)
    shares = np.full_like(totals, np.nan)
    return np.divide(totals, trials, out=shares, where=trials > 0)
