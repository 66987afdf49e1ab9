"""What the rows of the study come to, as numbers and as tables."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np
import pyarrow as pa

from prospect_mj.experiment.development.claims.findings import Findings
from prospect_mj.experiment.development.measures.development import Development
from prospect_mj.experiment.development.measures.measures import MEASURES, order
from prospect_mj.experiment.development.study.rows import Row
from prospect_mj.experiment.development.study.splits import Splits
from prospect_mj.experiment.paper.measures.bootstrap import Interval, band
from prospect_mj.experiment.paper.measures.measure import Measure
from prospect_mj.experiment.populations.population import Population
from prospect_mj.experiment.populations.strategies import Strategy
from prospect_mj.experiment.run.learning_curve import BLOCK

_NAMES = {
    "part": pa.string(),
    "name": pa.string(),
    "rule": pa.string(),
    "world": pa.string(),
    "then": pa.string(),
    "touch": pa.string(),
    "categories": pa.int32(),
}
MEASURED_SCHEMA = pa.schema(
    {
        **_NAMES,
        "runs": pa.int32(),
        "measure": pa.string(),
        "estimate": pa.float64(),
        "low": pa.float64(),
        "high": pa.float64(),
        "lacking": pa.float64(),
    }
)
"""Trials or shares [1]; lacking: part of the resamples in which it is not there. The
measure `order` is a share of the resamples, and has no interval."""
SHARES_SCHEMA = pa.schema(
    {
        **_NAMES,
        "trials": pa.string(),
        "strategy": pa.string(),
        "trial": pa.int32(),
        "share": pa.float64(),
        "low": pa.float64(),
        "high": pa.float64(),
    }
)
"""Share of the easy or the difficult trials [1] in a set of ten that begins with a
trial, counted from the end of the pretraining."""
SEQUENCES_SCHEMA = pa.schema(
    {
        **_NAMES,
        "sequence": pa.string(),
        "share": pa.float64(),
        "low": pa.float64(),
        "high": pa.float64(),
    }
)
"""Share of the runs [1] in which these strategies prevail one after the other."""

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
        return Measured(self.row, self.runs, found.measured, found.order)

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
    """Measure a row's development, and the first splits of a discovery learner.

    Args:
        row: it.
        population: that learned.
        rng: draws the resamples.
        measures: what is measured.
    """
    development = Development.of(population, rng)
    found = {one.name: one.estimate(development) for one in measures}
    if row.settings.learner.name == "discovery" and row.then is None:
        splits = Splits.of(population, rng)
        found |= {INSERTION: splits.insertion, GRASP: splits.grasp}
    numbers = Measured(row, len(population.lid), found, order(development))
    return MeasuredCurves(numbers, development)


def measured_table(rows: Iterable[Measured]) -> pa.Table:
    """All numbers, under `MEASURED_SCHEMA`."""
    lines = [line for row in rows for line in _measured_lines(row)]
    return pa.Table.from_pylist(lines, schema=MEASURED_SCHEMA)


def shares_table(developments: Iterable[tuple[Row, Development]]) -> pa.Table:
    """Curves of the strategies, under `SHARES_SCHEMA`."""
    lines = [line for pair in developments for line in _share_lines(*pair)]
    return pa.Table.from_pylist(lines, schema=SHARES_SCHEMA)


def sequences_table(rows: Iterable[Told]) -> pa.Table:
    """What single runs do, under `SEQUENCES_SCHEMA`."""
    lines = [
        _names(one.row)
        | {"sequence": words(found.sequence), "share": found.share.estimate}
        | {"low": found.share.low, "high": found.share.high}
        for one in rows
        for found in one.findings.sequences
    ]
    return pa.Table.from_pylist(lines, schema=SEQUENCES_SCHEMA)


def words(sequence: Sequence[Strategy]) -> str:
    """A sequence of strategies, such as `late, early, optimal`."""
    return ", ".join(strategy.name.lower() for strategy in sequence) or "none"


def _names(row: Row) -> dict[str, str | int | None]:
    return {
        "part": row.part,
        "name": row.name,
        "rule": row.rule,
        "world": row.world,
        "then": row.then,
        "touch": row.touch,
        "categories": row.settings.categories,
    }


def _measured_lines(one: Measured) -> Iterator[dict[str, object]]:
    names = _names(one.row) | {"runs": one.runs}
    for name, found in one.measured.items():
        yield names | {"measure": name} | found._asdict()
    yield names | {"measure": ORDER, "estimate": one.order}


def _share_lines(row: Row, development: Development) -> Iterator[dict[str, object]]:
    switch = development.mean.switch
    for trials in ("easy", "difficult"):
        once, many = (getattr(curves, trials).strategies for curves in development)
        low, high = band(many)
        for strategy in Strategy:
            for number in range(switch, once.shape[2]):
                yield _names(row) | {
                    "trials": trials,
                    "strategy": strategy.name.lower(),
                    "trial": BLOCK * (number - switch),
                    "share": once[0, strategy, number],
                    "low": low[strategy, number],
                    "high": high[strategy, number],
                }
