"""How abruptly late corrections give way to early ones, in a run and in the mean.

A change that is abrupt leaves early corrections before it and late ones after it to
exploration only. So a change is sought that leaves as few of them as possible; how
many are left does not depend on how long the corrections last. Where late and early
ones take turns, about half of their trials are left.
"""

from typing import NamedTuple, Self

import numpy as np
from numpy.typing import NDArray

from prospect_mj.experiment.development.measures.sequences import (
    WINDOW,
    difficult_trials,
)
from prospect_mj.experiment.estimate import Estimate, share
from prospect_mj.experiment.paper.measures.bootstrap import (
    Floats,
    Interval,
    interval,
    times_drawn,
)
from prospect_mj.experiment.populations.population import Population
from prospect_mj.experiment.populations.strategies import Strategy

ABRUPT = 1.5
"""Corrections on the wrong side of an abrupt change at most, in the mean over runs: a
chance of early ones that rises evenly over ten difficult trials leaves 1.3, and one
over twenty 3.4."""


class Changes(NamedTuple):
    """Corrections on the wrong side of the best change [difficult trials per run]."""

    n_runs: int
    """Runs with ten late and ten early corrections; others have no change, and are left
    out."""
    own: Interval
    """Mean, where each run has a change of its own."""
    common: Interval
    """Mean, where all runs have the same."""
    abrupt: Estimate
    """Share of these runs with at most one [1]."""

    @classmethod
    def of(cls, population: Population, rng: np.random.Generator, n: int) -> Self:
        """Find the changes of a population.

        Args:
            population: with a dominant hand.
            rng: draws the resamples.
            n: their number.
        """
        left = misplaced(_changing(difficult_trials(population)))
        if not len(left):
            nothing = Interval(np.nan, np.nan, np.nan, 1.0)
            return cls(0, nothing, nothing, Estimate(np.nan, np.nan, np.nan))
        own, every = left.min(axis=1), np.ones((1, len(left)))
        times = times_drawn(len(left), rng, n)
        return cls(
            len(left),
            interval(own.mean(), times @ own / len(left)),
            interval(_common(every, left)[0], _common(times, left)),
            share(int((own <= 1).sum()), len(left)),
        )


def misplaced(strategies: NDArray[np.int8]) -> Floats:
    """Early corrections before a change, and late ones after it.

    Args:
        strategies: (r, d) of the difficult trials of each run.

    Returns:
        (r, d + 1) [difficult trials], for a change before each trial and after all.
    """
    late, early = strategies == Strategy.LATE, strategies == Strategy.EARLY
    before = np.pad(early.cumsum(axis=1), ((0, 0), (1, 0)))
    after = np.pad(late[:, ::-1].cumsum(axis=1)[:, ::-1], ((0, 0), (0, 1)))
    return (before + after).astype(np.float64)


def _changing(runs: list[NDArray[np.int8]]) -> NDArray[np.int8]:
    """Runs with enough of both, cut to as many difficult trials as all have."""
    length = min(map(len, runs))
    cut = np.stack([run[:length] for run in runs])
    enough = [
        (cut == kind).sum(axis=1) >= WINDOW for kind in (Strategy.LATE, Strategy.EARLY)
    ]
    return cut[np.all(enough, axis=0)]


def _common(times: Floats, left: Floats) -> Floats:
    """Mean (b,) at the best change for all, each run there so many times (b, r)."""
    return (times @ left).min(axis=1) / len(left)
