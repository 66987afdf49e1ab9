"""What it takes to develop as infants do, and as the paper's agent does.

Three bounds of infants' order were set before the study was made: 95 % of the
resamples, fifty trials, 75 % of the easy ones. The others are the study's own, and each
says that a stage is there at all. Each criterion is asked of every learner under every
rule, controls among them.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from math import inf, isnan
from typing import Protocol

from prospect_mj.experiment.development.measures.measures import PREVAILING
from prospect_mj.experiment.paper.measures.bootstrap import Interval
from prospect_mj.experiment.paper.measures.quantity import Kind, number, with_interval
from prospect_mj.experiment.paper.measures.target import Target, Verdict

CONFIDENT = 0.95
"""Share of the resamples that an order takes."""


class Figures(Protocol):
    """What criteria need to know of a population."""

    @property
    def measured(self) -> Mapping[str, Interval]:
        """Each of `MEASURES`, by name."""
        ...

    @property
    def order(self) -> float:
        """Share of the resamples in which late corrections go before early ones [1]."""
        ...


@dataclass(frozen=True)
class Judged:
    """A criterion, held against one population."""

    verdict: Verdict
    words: str
    """What was measured."""


@dataclass(frozen=True)
class Criterion:
    """What is asked of a population."""

    name: str
    """In tables."""
    words: str
    """What is asked, in words."""
    judge: Callable[[Figures], Judged]


def _measured(name: str, kind: Kind, target: Target) -> Callable[[Figures], Judged]:
    """A measure that must be in a range, with all of its interval."""

    def judge(findings: Figures) -> Judged:
        found = findings.measured[name]
        unit = " trials" if kind is Kind.TRIAL else ""
        return Judged(target.verdict(found), with_interval(found, kind) + unit)

    return judge


def _ordered(findings: Figures) -> Judged:
    late, early = (_gone(findings, kind) for kind in ("late", "early"))
    words = f"{late}, {early}; {_percent(findings.order)} of the resamples"
    return Judged(by_share(findings.order), words)


def _gone(findings: Figures, kind: str) -> str:
    """When a correction is gone, or how rare it was if it never was there."""
    end = findings.measured[f"{kind}_gone"].estimate
    if not isnan(end):
        return f"{kind} {number(end, Kind.TRIAL)}"
    most = findings.measured[f"{kind}_most"].estimate
    return f"{kind} never above 10 % ({_percent(most)} at most)"


def _unordered(findings: Figures) -> Judged:
    judged = _ordered(findings)
    return Judged(by_share(1.0 - findings.order), judged.words)


def by_share(share: float) -> Verdict:
    """The verdict on what is so in a share of the resamples [1]."""
    if share >= CONFIDENT:
        return Verdict.HOLDS
    return Verdict.FAILS if share <= 1.0 - CONFIDENT else Verdict.OPEN


def _percent(share: float) -> str:
    return f"{100 * share:.1f} %"


LATE_GONE_FIRST = Criterion(
    "late gone first",
    "late corrections are gone before early ones in 95 % of the resamples",
    _ordered,
)
STAGES = (
    Criterion(
        "late corrections prevail",
        "in a block late corrections are more than a half of the difficult trials",
        _measured("late_most", Kind.SHARE, Target(PREVAILING, 1.0)),
    ),
    LATE_GONE_FIRST,
    Criterion(
        "corrections dominate",
        "corrections exceed the optimal strategy for fifty trials on end",
        _measured("dominance", Kind.TRIAL, Target(50, inf)),
    ),
    Criterion(
        "early corrections lead",
        "for ten trials on end they do so with more early than late ones",
        _measured("early_lead", Kind.TRIAL, Target(10, inf)),
    ),
    Criterion(
        "optimal in the end",
        "the optimal strategy is more than a half of the difficult ones of the last "
        "hundred trials",
        _measured("optimal_last", Kind.SHARE, Target(PREVAILING, 1.0)),
    ),
)
"""Late, then early, then optimal."""

LIKE_INFANTS = (
    *STAGES,
    Criterion(
        "easy trials spared",
        "no block has less than 75 % optimal ones among its easy trials",
        _measured("easy_worst", Kind.SHARE, Target(0.75, 1.0)),
    ),
)
"""The stages, with the dominant hand kept where it is right."""

UNLIKE_INFANTS = (
    Criterion(
        "corrections do not dominate",
        "corrections never exceed the optimal strategy for fifty trials on end",
        _measured("dominance", Kind.TRIAL, Target(0, 49)),
    ),
    Criterion(
        "late not gone first",
        "late corrections are not gone before early ones in 95 % of the resamples",
        _unordered,
    ),
)
"""The mismatches that the paper admits of its own agent (section 3.2), at the bounds of
infants' order. To the letter, never and early ones first, they depend on the measure
(docs/reproduction.md)."""


def develops(figures: Figures) -> Verdict:
    """Whether a population develops as infants do, by all criteria together."""
    return together(LIKE_INFANTS, figures).verdict


def together(criteria: Sequence[Criterion], figures: Figures) -> Judged:
    """What some criteria come to, with those that decide if they don't all hold."""
    judged = {one.name: one.judge(figures) for one in criteria}
    verdict = all_of([one.verdict for one in judged.values()])
    if verdict is Verdict.HOLDS:
        return Judged(verdict, verdict)
    decide = [
        f"{name}, {one.words}" for name, one in judged.items() if one.verdict is verdict
    ]
    return Judged(verdict, f"{verdict} ({'; '.join(decide)})")


def all_of(verdicts: list[Verdict]) -> Verdict:
    """Whether everything holds, or something does not."""
    if Verdict.FAILS in verdicts:
        return Verdict.FAILS
    return Verdict.HOLDS if set(verdicts) == {Verdict.HOLDS} else Verdict.OPEN
