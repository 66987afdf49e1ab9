"""What the measures are taken on: the curves of one population, and their resamples."""

from typing import NamedTuple, Self

import numpy as np

from prospect_mj.experiment.paper.measures.bootstrap import (
    RESAMPLES,
    Floats,
    times_drawn,
)
from prospect_mj.experiment.paper.measures.curves import Curves, RunCounts
from prospect_mj.experiment.populations.population import Population
from prospect_mj.experiment.populations.strategies import Strategy


class Development(NamedTuple):
    """Curves as they are, and resampled."""

    mean: Curves
    """b = 1."""
    resampled: Curves
    """As many runs, drawn with replacement."""

    @classmethod
    def of(
        cls, population: Population, rng: np.random.Generator, n: int = RESAMPLES
    ) -> Self:
        """Count the runs, and resample them.

        Args:
            population: with a dominant hand.
            rng: draws the resamples.
            n: their number.
        """
        counts = RunCounts.of(population)
        return cls(
            counts.mean(), counts.drawn(times_drawn(len(population.lid), rng, n))
        )


def difficult(curves: Curves, strategy: Strategy) -> Floats:
    """Share (b, s) of a strategy in the difficult trials of each block of ten."""
    return curves.difficult.strategies[:, strategy, curves.switch :]


def easy(curves: Curves, strategy: Strategy) -> Floats:
    """The same in the easy trials."""
    return curves.easy.strategies[:, strategy, curves.switch :]


def corrections(curves: Curves) -> Floats:
    """Share (b, s) of corrections, late and early, in the difficult trials."""
    return difficult(curves, Strategy.LATE) + difficult(curves, Strategy.EARLY)
