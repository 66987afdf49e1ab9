"""What the rows of the study come to, as numbers."""

from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from prospect_mj.experiment.development.claims.findings import Findings
from prospect_mj.experiment.development.measures.development import Development
from prospect_mj.experiment.development.measures.measures import MEASURES, order
from prospect_mj.experiment.development.measures.sequences import (
    SequenceShare,
    named,
    sequences,
)
from prospect_mj.experiment.development.study.rows import Row
from prospect_mj.experiment.development.study.splits import Splits
from prospect_mj.experiment.paper.measures.bootstrap import Interval
from prospect_mj.experiment.paper.measures.measure import Measure
from prospect_mj.experiment.populations.population import Population

ORDER = "order"
INSERTION, GRASP = "insertion_split", "grasp_split"


class Measured(NamedTuple):
    """A row in numbers."""

    row: Row
    runs: int
    measured: Mapping[str, Interval]
    """By name of the measure."""
    order: float
    """Share of the resamples in which late corrections are gone before early ones."""


class MeasuredCurves(NamedTuple):
    """A row in numbers, with its curves."""

    measured: Measured
    development: Development

    @property
    def row(self) -> Row:
        """It."""
        return self.measured.row


class Told(NamedTuple):
    """A row in full: also its curves and single runs."""

    row: Row
    runs: int
    findings: Findings

    @property
    def measured(self) -> Measured:
        """Its numbers only."""
        found = self.findings
        numbers = {**found.measured, **single_runs(found.sequences, self.runs)}
        return Measured(self.row, self.runs, numbers, found.order)

    @property
    def development(self) -> Development:
        """Its curves."""
        return self.findings.development


def told(row: Row, population: Population, rng: np.random.Generator) -> Told:
    """Measure a row in full.

    Args:
        row: it.
        population: that learned.
        rng: draws the resamples.
    """
    return Told(row, len(population.lid), Findings.of(population, rng))


def measured(
    row: Row,
    population: Population,
    rng: np.random.Generator,
    measures: Sequence[Measure] = MEASURES,
) -> MeasuredCurves:
    """Measure a row's development, its single runs, and first splits of discovery.

    Args:
        row: it.
        population: that learned.
        rng: draws the resamples.
        measures: what is measured.
    """
    development = Development.of(population, rng)
    found = {one.name: one.estimate(development) for one in measures}
    runs = len(population.lid)
    if row.then is None:
        found |= single_runs(sequences(population), runs)
    if row.settings.learner.name == "discovery" and row.then is None:
        splits = Splits.of(population, rng)
        found |= {INSERTION: splits.insertion, GRASP: splits.grasp}
    numbers = Measured(row, runs, found, order(development))
    return MeasuredCurves(numbers, development)


def single_runs(found: Iterable[SequenceShare], runs: int) -> dict[str, Interval]:
    """Shares of the runs that go through a sequence that has a name, as numbers."""
    return {
        name: Interval(one.estimate, one.low, one.high)
        for name, one in named(found, runs).items()
    }
