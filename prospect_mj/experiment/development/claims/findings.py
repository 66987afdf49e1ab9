"""All that is measured on one population, as claims ask for it."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Self

import numpy as np

from prospect_mj.experiment.development.measures.ages import AgeFound, ages, in_order
from prospect_mj.experiment.development.measures.changes import Changes
from prospect_mj.experiment.development.measures.development import Development
from prospect_mj.experiment.development.measures.measures import MEASURES, order
from prospect_mj.experiment.development.measures.sequences import (
    SequenceShare,
    late_alone,
    late_before_early,
    sequences,
)
from prospect_mj.experiment.estimate import Estimate
from prospect_mj.experiment.paper.measures.bootstrap import RESAMPLES, Interval
from prospect_mj.experiment.populations.population import Population


@dataclass(frozen=True)
class Findings:
    """What one population came to."""

    development: Development
    """Its curves."""
    measured: Mapping[str, Interval]
    """Each of `MEASURES`, by name."""
    order: float
    """Share of the resamples in which late corrections are gone before early ones."""
    sequences: tuple[SequenceShare, ...]
    """Strategies that prevail in single runs, the most frequent sequence first."""
    late_first: Estimate
    """Share of the runs whose median late correction is before the median early one."""
    late_alone: Estimate
    """Share of the runs that have a phase of late corrections alone."""
    changes: Changes
    """From late to early corrections, run by run."""
    ages: tuple[AgeFound, ...]
    """Where the patterns of infants are found."""
    ages_in_order: float
    """Share of the resamples in which they all are, one after the other [1]."""

    @classmethod
    def of(
        cls, population: Population, rng: np.random.Generator, n: int = RESAMPLES
    ) -> Self:
        """Measure a population.

        Args:
            population: with a dominant hand.
            rng: draws the resamples.
            n: their number.
        """
        development = Development.of(population, rng, n)
        return cls(
            development,
            {one.name: one.estimate(development) for one in MEASURES},
            order(development),
            tuple(sequences(population)),
            late_before_early(population),
            late_alone(population),
            Changes.of(population, rng, n),
            tuple(ages(development)),
            in_order(development),
        )
