"""Whether recorded numbers differ from those of the abstract task."""

from dataclasses import dataclass
from math import isinf, isnan

import pyarrow as pa

from prospect_mj.experiment.development.measures.sequences import NAMED
from prospect_mj.experiment.development.study.abstract_told import Abstract
from prospect_mj.experiment.development.study.measured import ORDER, Measured
from prospect_mj.experiment.paper.measures.bootstrap import Interval
from prospect_mj.experiment.paper.measures.quantity import Kind
from prospect_mj.experiment.run.learning_curve import BLOCK

ALIKE = 0.1
"""What is at most this beyond an interval is alike: a share of trials [1], or this part
of a number of trials, one block at least."""
_ROUNDED = 0.005
"""Shares of the abstract task are told to hundredths [1]."""

COMPARED_SCHEMA = pa.schema(
    {
        "part": pa.string(),
        "name": pa.string(),
        "rule": pa.string(),
        "measure": pa.string(),
        "abstract": pa.float64(),
        "estimate": pa.float64(),
        "low": pa.float64(),
        "high": pa.float64(),
        "outside": pa.bool_(),
        "differs": pa.bool_(),
    }
)
"""Trials or shares [1]; NaN: never above 10 %; infinite: never gone."""


@dataclass(frozen=True)
class Compared:
    """A number that both tasks have."""

    name: str
    """Of the measure."""
    title: str
    kind: Kind
    may_lack: bool = False
    """Whether NaN says that it is not there, and not that it isn't told."""

    def said(self, told: Abstract) -> float:
        """That of the abstract task."""
        return getattr(told, self.name)

    def is_told(self, told: Abstract) -> bool:
        """Whether the abstract task has it."""
        return self.may_lack or not isnan(self.said(told))

    def found(self, one: Measured) -> Interval:
        """That of a row."""
        return one.measured[self.name]

    def is_outside(self, told: Abstract, one: Measured) -> bool:
        """Whether the abstract number, as rounded, is outside of a row's interval."""
        rounded = 0.0 if self.kind is Kind.TRIAL else _ROUNDED
        return self._is_beyond(told, one, rounded)

    def differs(self, told: Abstract, one: Measured) -> bool:
        """Whether it is outside by more than what counts as alike."""
        if self.kind is not Kind.TRIAL:
            return self._is_beyond(told, one, ALIKE)
        said = self.said(told)
        reach = 0.0 if isinf(said) else max(ALIKE * said, BLOCK)
        return self._is_beyond(told, one, reach)

    def brought(self, told: Abstract, before: Measured, after: Measured) -> bool:
        """Whether a change brings a number that differs to the abstract one.

        It must not differ any more, and must have left the interval that it had: a
        wider interval alone brings nothing.

        Args:
            told: by the abstract task.
            before: as recorded; the number differs.
            after: with the change.
        """
        if self.differs(told, after):
            return False
        if isnan(self.said(told)) or isnan(self.found(before).estimate):
            return True
        return self._has_moved(told, before, after)

    def nearer(self, told: Abstract, before: Measured, after: Measured) -> bool:
        """Whether a change brings it nearer, but not there; arguments as above."""
        said, was, now = self.said(told), self.found(before), self.found(after)
        if any(map(isnan, (said, was.estimate, now.estimate))):
            return False
        less = abs(now.estimate - said) < abs(was.estimate - said)
        there = not self.differs(told, after)
        return less and not there and self._has_moved(told, before, after)

    def _is_beyond(self, told: Abstract, one: Measured, reach: float) -> bool:
        said, found = self.said(told), self.found(one)
        if isnan(said) or isnan(found.estimate):
            return self.is_told(told) and isnan(said) != isnan(found.estimate)
        return not found.low - reach <= said <= found.high + reach

    def _has_moved(self, told: Abstract, before: Measured, after: Measured) -> bool:
        """Whether a number has left the interval that it had, the right way."""
        was, now = self.found(before), self.found(after).estimate
        return now < was.low if self.said(told) < was.low else now > was.high


class ComparedOrder(Compared):
    """In which part of the resamples late corrections are gone before early ones."""

    def found(self, one: Measured) -> Interval:
        """The share; it has no interval."""
        return Interval(one.order, one.order, one.order)

    def is_outside(self, told: Abstract, one: Measured) -> bool:
        """As `differs`."""
        return self.differs(told, one)


COMPARED = (
    Compared("late_gone", "late gone", Kind.TRIAL, may_lack=True),
    Compared("early_gone", "early gone", Kind.TRIAL, may_lack=True),
    ComparedOrder(ORDER, "late gone first", Kind.SHARE),
    Compared("dominance", "corrections dominate", Kind.TRIAL),
    Compared("early_lead", "early corrections lead", Kind.TRIAL),
    Compared("late_most", "most late corrections", Kind.SHARE),
    Compared("early_most", "most early corrections", Kind.SHARE),
    Compared("other_first", "other at the beginning", Kind.SHARE),
    Compared("optimal_last", "optimal at the end", Kind.SHARE),
    Compared("easy_worst", "worst block of easy trials", Kind.SHARE),
    *(
        Compared(name, f"runs with {name.replace('_', ', ')} alone", Kind.SHARE)
        for name in NAMED
    ),
)
