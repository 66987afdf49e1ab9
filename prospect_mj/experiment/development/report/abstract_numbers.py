"""What the abstract task came to, and whether a recorded number differs from it.

The numbers are those of a rough study on a simulator without a robot, with made-up
histograms, whose code is gone ("Development feasibility", sections 3 and 4b); its
blocks of ten trials are written as trials here.
"""

from collections.abc import Mapping
from math import isnan, nan
from types import MappingProxyType
from typing import NamedTuple

from prospect_mj.experiment.development.study.measured import Measured
from prospect_mj.experiment.paper.measures.bootstrap import Interval
from prospect_mj.experiment.paper.measures.quantity import Kind, number, with_interval
from prospect_mj.experiment.run.learning_curve import BLOCK

Key = tuple[str, str]
"""Learner and rule."""

_ALIKE = 0.1
"""A number is the same if it differs by a tenth of itself, or by one block of ten."""


class Abstract(NamedTuple):
    """What a row came to on the abstract task; NaN where it isn't told."""

    late_gone: float
    """[trials], NaN: never above 10 %."""
    early_gone: float
    order: float
    """[1]"""
    dominance: float
    """[trials]"""
    early_lead: float
    """[trials]"""
    optimal_last: float
    """[1]"""
    easy_worst: float
    """[1]"""


ABSTRACT: Mapping[Key, Abstract] = MappingProxyType(
    {
        ("linear", "allowed"): Abstract(250, nan, 0.0, 20, 0, 0.97, 0.72),
        ("linear", "suppressed"): Abstract(350, nan, 0.0, 60, 0, 0.96, 0.95),
        ("linear, step .02", "allowed"): Abstract(90, 410, 0.98, 10, 0, 0.92, 0.77),
        ("linear, step .05", "allowed"): Abstract(50, 320, 1.0, 0, 0, 0.97, 0.62),
        ("linear, step .1", "allowed"): Abstract(30, 240, 1.0, 0, 0, 0.98, 0.47),
        ("linear, step .02", "suppressed"): Abstract(100, nan, 0, 20, 0, 0.98, 0.87),
        ("linear, step .05", "suppressed"): Abstract(50, 160, 1, 10, 0, 0.98, 0.68),
        ("replay", "allowed"): Abstract(30, 70, 1.0, 50, 40, 0.98, 0.97),
        ("replay", "suppressed"): Abstract(50, 100, 1.0, 80, 40, 0.98, 0.97),
        ("table", "suppressed"): Abstract(90, 100, 0.96, 0, 0, 0.98, 0.97),
        ("table, copied habit", "suppressed"): Abstract(
            130, nan, 0.0, 60, 0, 0.98, 0.97
        ),
        ("table, copied habit, replays", "suppressed"): Abstract(
            70, nan, 0.0, 60, 0, 0.98, 0.97
        ),
        ("table, copied habit, known correction", "suppressed"): Abstract(
            30, nan, 0.0, nan, 0, 0.98, nan
        ),
        ("table, copied habit, known correction, replays", "suppressed"): Abstract(
            50, 140, 1.0, nan, 80, 0.98, nan
        ),
        ("discovery", "allowed"): Abstract(60, 160, 1.0, 120, 90, 0.95, 0.83),
        ("discovery", "suppressed"): Abstract(80, 210, 1.0, 170, 100, 0.93, 0.81),
    }
)
"""By learner and rule."""


class Compared(NamedTuple):
    """A number that both tasks have."""

    name: str
    """Of the measure."""
    title: str
    kind: Kind
    may_lack: bool = False
    """Whether NaN says that it is not there, and not that it isn't told."""

    def said(self, key: Key) -> float:
        """That of the abstract task."""
        return getattr(ABSTRACT[key], self.name)

    def said_words(self, key: Key) -> str:
        """The same in words."""
        said = self.said(key)
        lacks = isnan(said) and not self.may_lack
        return "-" if lacks else number(said, self.kind)

    def found(self, one: Measured) -> Interval:
        """That of a row."""
        return one.measured[self.name]

    def found_words(self, one: Measured) -> str:
        """The same in words."""
        return with_interval(self.found(one), self.kind)

    def differs(self, key: Key, one: Measured) -> bool:
        """Whether a row has another number than the abstract task."""
        said, found = self.said(key), self.found(one)
        if isnan(said) or isnan(found.estimate):
            told = self.may_lack or not isnan(said)
            return told and isnan(said) != isnan(found.estimate)
        reach = max(_ALIKE * said, BLOCK) if self.kind is Kind.TRIAL else _ALIKE
        return not found.low - reach <= said <= found.high + reach

    def brought(self, key: Key, before: Measured, after: Measured) -> bool:
        """Whether a change brings a number that differs to the abstract one.

        It must not differ any more, and must have left the interval that it had: a
        wider interval alone brings nothing.

        Args:
            key: of the row.
            before: as recorded; the number differs.
            after: with the change.
        """
        if self.differs(key, after):
            return False
        said, was, now = self.said(key), self.found(before), self.found(after)
        if isnan(said) or isnan(was.estimate):
            return True
        below = said < was.low
        return now.estimate < was.low if below else now.estimate > was.high


COMPARED = (
    Compared("late_gone", "late gone", Kind.TRIAL, may_lack=True),
    Compared("early_gone", "early gone", Kind.TRIAL, may_lack=True),
    Compared("dominance", "corrections dominate", Kind.TRIAL),
    Compared("early_lead", "early corrections lead", Kind.TRIAL),
    Compared("optimal_last", "optimal at the end", Kind.SHARE),
    Compared("easy_worst", "worst block of easy trials", Kind.SHARE),
)
