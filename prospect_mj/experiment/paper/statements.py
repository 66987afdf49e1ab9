"""The published statements, each with the measure and the range that it is held to.

Wheeler, Fagg and Grupen (2002), section 3.2. Where the paper says "about" or "the
same", a tenth of the number to either side counts as that: the figures of the time
can't be read off more exactly.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from enum import StrEnum
from math import inf, isnan

import pyarrow as pa

from prospect_mj.experiment.paper import measures
from prospect_mj.experiment.paper.bands import Interval
from prospect_mj.experiment.paper.sample import Measure, Sample, estimate


class Kind(StrEnum):
    """What a number is of."""

    TRIAL = "trial"
    ACTIONS = "actions"
    SHARE = "share"
    RATIO = "ratio"


class Verdict(StrEnum):
    """Whether a statement holds."""

    HOLDS = "holds"
    FAILS = "does not hold"
    OPEN = "undecided"


@dataclass(frozen=True)
class Target:
    """Where a measure should be."""

    low: float
    high: float
    near: bool
    """Whether the statement names a number that this is the surrounding of: then it is
    enough that the interval overlaps; else all of the interval must be inside."""
    words: str
    """The published number or comparison, and what counts as that."""

    def verdict(self, measured: Interval) -> Verdict:
        """Judge a measure by its interval."""
        if measured.high < self.low or measured.low > self.high:
            return Verdict.FAILS
        inside = self.low <= measured.low and measured.high <= self.high
        return Verdict.HOLDS if self.near or inside else Verdict.OPEN


def about(number: float, words: str) -> Target:
    """A tenth of a number to either side of it."""
    return Target(9 * number / 10, 11 * number / 10, True, words)


@dataclass(frozen=True)
class Statement:
    """A sentence of the paper."""

    text: str
    """The paper's own words."""
    measure: Measure
    kind: Kind
    target: Target


@dataclass(frozen=True)
class Judgement:
    """A statement, and what was measured."""

    statement: Statement
    measured: Interval
    verdict: Verdict


TIMING_OUT = Target(0.5, 1.0, False, "most: over a half")
NEAR_OPTIMAL = about(650, "about 650: 585 to 715")
PRETRAINED = about(250, "about 250: 225 to 275")
PEAK = Target(6.0, 7.0, False, "over 6: 6 to 7")

_SAME_RATE = (
    "Learning then progressed at the same rate as for trials without a dominant hand."
)
_SAME = about(1, "the same: 0.9 to 1.1 times")
_DROP = (
    "In the easy trials after random orientations are introduced [...], our results "
    "show a temporary drop in the optimal strategy as the agent explores nonradial "
    "grips."
)

EARLY_FIRST = Statement(
    "In the child study, late corrections disappear before early corrections, but "
    "in our data, early corrections disappear first.",
    measures.late_outlasts_early,
    Kind.TRIAL,
    Target(1.0, inf, False, "early first: by a set or more"),
)
STATEMENTS = (
    Statement(
        "Initially, the untrained agent performed poorly, with most trials timing out "
        "after ten actions.",
        measures.first_unsolved,
        Kind.SHARE,
        TIMING_OUT,
    ),
    Statement(
        "After approximately 650 trials, the agent exhibited nearly optimal "
        "performance.",
        measures.near_optimal,
        Kind.TRIAL,
        NEAR_OPTIMAL,
    ),
    Statement(
        "During pretraining starting at trial 0, the untrained agent initially "
        "exhibited poor performance, but approached optimality after approximately "
        "250 trials.",
        measures.pretraining_near_optimal,
        Kind.TRIAL,
        PRETRAINED,
    ),
    Statement(
        "At trial 400, random orientations were introduced. Average actions per trial "
        "rose to over six [...].",
        measures.peak_after_switch,
        Kind.ACTIONS,
        PEAK,
    ),
    Statement(_SAME_RATE, measures.fall_ratio, Kind.RATIO, _SAME),
    Statement(_SAME_RATE, measures.relearning_ratio, Kind.RATIO, _SAME),
    Statement(
        _DROP,
        measures.easy_drop,
        Kind.SHARE,
        Target(0.05, 1.0, False, "a drop: over 5 points"),
    ),
    Statement(
        _DROP,
        measures.easy_regained,
        Kind.RATIO,
        Target(0.9, inf, False, "temporary: over 0.9 of it regained"),
    ),
    Statement(
        "With young children, the nonradial corrective strategies are dominant, "
        "whereas in our results, corrective strategies never dominate the optimal "
        "strategy.",
        measures.correction_margin,
        Kind.SHARE,
        Target(-0.01, 1.0, False, "never: not by 1 point in any set"),
    ),
    EARLY_FIRST,
)

FURTHER: tuple[tuple[Measure, Kind], ...] = (
    (measures.easy_low_trial, Kind.TRIAL),
    (measures.early_gone, Kind.TRIAL),
    (measures.late_gone, Kind.TRIAL),
    (measures.last_actions, Kind.ACTIONS),
)
"""Measured beside, of which the paper says no number."""


def judge(
    sample: Sample, statements: Sequence[Statement] = STATEMENTS
) -> list[Judgement]:
    """Hold statements against what was measured."""
    judgements = []
    for statement in statements:
        measured = estimate(statement.measure, sample)
        verdict = statement.target.verdict(measured)
        judgements.append(Judgement(statement, measured, verdict))
    return judgements


def number(value: float, kind: Kind) -> str:
    """A measured number in words."""
    if isnan(value):
        return "none"
    if value == inf:
        return "never"
    match kind:
        case Kind.TRIAL:
            return f"{value:.0f}"
        case Kind.SHARE:
            # Zero is added so that nothing is written as minus zero.
            return f"{round(100 * value, 1) + 0.0:.1f} %"
        case _:
            return f"{value:.2f}"


def with_interval(measured: Interval, kind: Kind) -> str:
    """An estimate and its interval in words."""
    if measured.low == inf:
        return number(inf, kind)
    estimate, low, high = (number(value, kind) for value in measured)
    return f"{estimate} ({low} to {high})"


def table(judgements: Sequence[Judgement]) -> pa.Table:
    """A row for each statement, with the range it is held to and what was measured."""
    return pa.Table.from_pylist(
        [
            {
                "statement": judged.statement.text,
                "measure": judged.statement.measure.__name__,
                "low_target": judged.statement.target.low,
                "high_target": judged.statement.target.high,
                "measured": judged.measured.estimate,
                "low": judged.measured.low,
                "high": judged.measured.high,
                "verdict": str(judged.verdict),
            }
            for judged in judgements
        ]
    )
