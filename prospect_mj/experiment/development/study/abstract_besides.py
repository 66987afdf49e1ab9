"""Recorded rows beside what the abstract task came to, and with things of it."""

from collections.abc import Iterator, Mapping
from typing import NamedTuple

import pyarrow as pa

from prospect_mj.experiment.development.study.abstract_compared import (
    COMPARED,
    COMPARED_SCHEMA,
    Compared,
)
from prospect_mj.experiment.development.study.abstract_rows import (
    CHANGES,
    NOTHING,
    changed,
)
from prospect_mj.experiment.development.study.abstract_told import TOLD, Abstract
from prospect_mj.experiment.development.study.measured import Measured
from prospect_mj.experiment.development.study.results import Results
from prospect_mj.experiment.development.study.rows import Row


class Beside(NamedTuple):
    """A row that both tasks have."""

    told: Abstract
    recorded: Measured
    changed: Mapping[str, Measured]
    """By the name of a change; only those that make it another row, each once."""

    @property
    def row(self) -> Row:
        """It."""
        return self.recorded.row

    @property
    def title(self) -> str:
        """Its name among the rows of all parts."""
        if self.row.part == "learners":
            return f"{self.row.name}, {self.row.rule}"
        return f"{self.row.part}: {self.row.name}"

    def compared(self) -> list[Compared]:
        """The numbers that the abstract task tells of it, and the row has."""
        return [each for each in COMPARED if each.is_told(self.told)]

    def outside(self) -> list[Compared]:
        """Those outside of the recorded interval."""
        return [one for one in self.compared() if self._is_outside(one)]

    def differing(self, change: str | None = None) -> list[Compared]:
        """Those that differ.

        Args:
            change: its name, None: as recorded.
        """
        one = self.recorded if change is None else self.changed[change]
        return [each for each in self.compared() if each.differs(self.told, one)]

    def lines(self) -> Iterator[dict[str, object]]:
        """Its numbers, under `COMPARED_SCHEMA`."""
        differing, outside = self.differing(), self.outside()
        names = {name: getattr(self.row, name) for name in ("part", "name", "rule")}
        for each in self.compared():
            found = each.found(self.recorded)
            yield names | {
                "measure": each.name,
                "abstract": each.said(self.told),
                "estimate": found.estimate,
                "low": found.low,
                "high": found.high,
                "outside": each in outside,
                "differs": each in differing,
            }

    def _is_outside(self, one: Compared) -> bool:
        return one.is_outside(self.told, self.recorded)


def besides(results: Results) -> list[Beside]:
    """All rows of the study that have abstract numbers, in the study's order."""
    made = {_key(one): one for one in results.towards_abstract}
    rows = [one.measured for one in results.learners]
    rows += [*results.causal, *(one.measured for one in results.population)]
    told = ((TOLD.get((one.row.part, one.row.name, one.row.rule)), one) for one in rows)
    return [
        Beside(said, one, _changed(one, made, results))
        for said, one in told
        if said is not None
    ]


def besides_table(rows: list[Beside]) -> pa.Table:
    """All numbers, under `COMPARED_SCHEMA`."""
    lines = [line for one in rows for line in one.lines()]
    return pa.Table.from_pylist(lines, schema=COMPARED_SCHEMA)


_Key = tuple[str, str, str, str]


def _key(one: Measured) -> _Key:
    return _row_key(one.row)


def _row_key(row: Row) -> _Key:
    return row.part, row.name, row.rule, row.world


def _changed(
    one: Measured, made: Mapping[_Key, Measured], results: Results
) -> dict[str, Measured]:
    known = {change.of(one.row): name for name, change in reversed(CHANGES.items())}
    known.pop(NOTHING, None)
    return {
        name: made[_row_key(changed(one.row, known_of, results.settings))]
        for known_of, name in reversed(known.items())
    }
