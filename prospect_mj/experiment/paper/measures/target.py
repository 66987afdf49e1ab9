"""Ranges that measures are held to, and how an interval is judged by one."""

from collections.abc import Iterable
from dataclasses import dataclass
from enum import StrEnum
from math import inf, isnan

from prospect_mj.experiment.paper.measures.bootstrap import LEVEL, Interval


class Verdict(StrEnum):
    """Whether a statement holds."""

    HOLDS = "holds"
    FAILS = "does not hold"
    OPEN = "undecided"
    DEPENDS = "depends on the measure"
    """It holds by one measure of the same, and does not by another."""

    def not_denied(self) -> "Verdict":
        """The same, but undecided in place of a denial."""
        return Verdict.OPEN if self is Verdict.FAILS else self


@dataclass(frozen=True)
class Target:
    """Where a measure should be."""

    low: float
    high: float
    words: str = ""
    """The published number or comparison, and what counts as that."""
    number: float | None = None
    """The published number itself, or the bound of the comparison."""

    def verdict(self, measured: Interval, end: float = inf) -> Verdict:
        """Judge a measure by its interval; the wider it is, the less it confirms.

        Args:
            measured: the interval.
            end: where the study ends, at or after which lies what was not reached.

        Returns:
            HOLDS if all of the interval is inside, FAILS if none of it is, else OPEN;
            OPEN too if what is measured is not there, or too often not in a resample.
        """
        if isnan(measured.estimate) or measured.lacking > 1 - LEVEL:
            return Verdict.OPEN
        if measured.high < self.low or min(measured.low, end) > self.high:
            return Verdict.FAILS
        inside = self.low <= measured.low and measured.high <= self.high
        return Verdict.HOLDS if inside else Verdict.OPEN


def about(number: float, words: str) -> Target:
    """A tenth of a number to either side of it."""
    return Target(9 * number / 10, 11 * number / 10, words, number)


def agreed(verdicts: Iterable[Verdict]) -> Verdict:
    """What several measures of the same say."""
    said = set(verdicts)
    if {Verdict.HOLDS, Verdict.FAILS} <= said:
        return Verdict.DEPENDS
    return said.pop() if len(said) == 1 else Verdict.OPEN
