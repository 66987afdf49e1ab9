"""What measures are taken on: the curves of both scenarios, and their resamples."""

from typing import NamedTuple, Self

import numpy as np

from prospect_mj.experiment.paper.measures.bootstrap import Floats, times_drawn
from prospect_mj.experiment.paper.measures.curves import Curves, RunCounts
from prospect_mj.experiment.populations.population import Population
from prospect_mj.experiment.run.learning_curve import BLOCK


class Pair(NamedTuple):
    """The curves of both scenarios."""

    baseline: Curves
    """Without a dominant hand."""
    dominant: Curves
    """With one: after pretraining."""


class Resampling(NamedTuple):
    """How often each run is in every resample, to be used for all that is compared."""

    baseline: Floats
    """(b, runs) without a dominant hand."""
    dominant: Floats
    """(b, runs) with one."""

    @classmethod
    def draw(cls, runs: int, rng: np.random.Generator) -> Self:
        """Draw as many runs as there are, again and again, in either scenario."""
        return cls(*(times_drawn(runs, rng) for _ in cls._fields))


FULL = 1000
"""Trials of the paper's study."""


class Sample(NamedTuple):
    """Curves as they are, and resampled."""

    mean: Pair
    """b = 1."""
    resampled: Pair
    """As many runs, drawn with replacement."""

    @property
    def is_short(self) -> bool:
        """Whether its last trials come before those of the paper."""
        return BLOCK * self.mean.dominant.actions.shape[1] < FULL

    @classmethod
    def of(
        cls, baseline: Population, dominant: Population, resampling: Resampling
    ) -> Self:
        """Count and resample the runs of both scenarios."""
        counts = RunCounts.of(baseline), RunCounts.of(dominant)
        pairs = zip(counts, resampling, strict=True)
        resampled = Pair(*(count.drawn(times) for count, times in pairs))
        return cls(Pair(*(count.mean() for count in counts)), resampled)
