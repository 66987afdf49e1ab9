"""One measure of learners that are told more of a grasp, beside those told the hand."""

from collections.abc import Callable, Iterable, Iterator
from math import isfinite, isnan
from typing import NamedTuple

from prospect_mj.experiment.development.haptics.touch import BITS, Touch
from prospect_mj.experiment.development.study.measured import MeasuredCurves
from prospect_mj.experiment.paper.measures.bootstrap import LEVEL, Interval
from prospect_mj.experiment.paper.measures.measure import Measure
from prospect_mj.experiment.paper.measures.quantity import Kind, number, with_interval
from prospect_mj.experiment.paper.measures.target import Verdict

_SAID = {
    Kind.TRIAL: {
        Verdict.HOLDS: "gone sooner",
        Verdict.FAILS: "gone later",
        Verdict.OPEN: "gone neither clearly sooner nor later",
    },
    Kind.SHARE: {
        Verdict.HOLDS: "rarer at their most",
        Verdict.FAILS: "more frequent at their most",
        Verdict.OPEN: "neither clearly rarer nor more frequent at their most",
    },
}

_NOTHING = "never above 10 %"


class Compared(NamedTuple):
    """What telling more of a grasp does to a measure."""

    measure: Measure
    usual: Interval
    """Of those that are told which hand it is."""
    told: Interval
    """Of those that are told more."""

    @property
    def there(self) -> bool:
        """Whether one of both has what is measured."""
        return not (isnan(self.usual.estimate) and isnan(self.told.estimate))

    @property
    def less(self) -> Verdict:
        """Whether it is less where more is told, by whole intervals.

        What is never above the level is gone from the first trial on.
        """
        usual, told = _bounds(self.usual), _bounds(self.told)
        if told.high < usual.low:
            return Verdict.HOLDS
        return Verdict.FAILS if told.low > usual.high else Verdict.OPEN

    @property
    def kind(self) -> str:
        """Of corrections: late or early."""
        return self.measure.name.partition("_")[0]

    @property
    def words(self) -> str:
        """What it does, with both intervals."""
        return self._said(with_interval)

    @property
    def brief(self) -> str:
        """What it does, with both numbers."""
        return self._said(lambda found, kind: number(found.estimate, kind))

    def _said(self, words: Callable[[Interval, Kind], str]) -> str:
        if not self.there:
            return _NOTHING
        kind, numbers = self.measure.kind, []
        for one in (self.told, self.usual):
            unit = " trials" if kind is Kind.TRIAL and isfinite(one.estimate) else ""
            there = not isnan(one.estimate)
            numbers.append(words(one, kind) + unit if there else _NOTHING)
        told, usual = numbers
        return f"{_SAID[kind][self.less]}, {told} in place of {usual}"


class Telling(NamedTuple):
    """A learner that is told more, beside the same told the hand only."""

    learner: str
    jar: str
    """World whose grasps these are."""
    usual: MeasuredCurves
    told: MeasuredCurves

    @property
    def touch(self) -> Touch:
        """What it is told."""
        return self.told.row.touch

    def compared(self, measure: Measure) -> Compared:
        """What that does to a measure."""
        both = (one.measured.measured[measure.name] for one in (self.usual, self.told))
        return Compared(measure, *both)


def tellings(rows: Iterable[MeasuredCurves]) -> Iterator[Telling]:
    """All of them: each learner told each thing more."""
    usual: dict[tuple[str, str], MeasuredCurves] = {}
    others = []
    for one in rows:
        if one.row.touch == BITS:
            usual[one.row.name, one.row.world] = one
        else:
            others.append(one)
    for one in others:
        of = one.row.name, one.row.world
        yield Telling(*of, usual[of], one)


def _bounds(found: Interval) -> Interval:
    """The interval, in which what is not there is 0, as are its resamples."""
    if isnan(found.estimate):
        return Interval(0.0, 0.0, 0.0 if isnan(found.high) else found.high)
    return found if found.lacking <= 1 - LEVEL else found._replace(low=0.0)
