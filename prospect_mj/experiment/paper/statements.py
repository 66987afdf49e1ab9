"""The published statements, each with the measure and the range that it is held to.

Wheeler, Fagg and Grupen (2002), section 3.2. Where the paper says "about" or "the
same", a tenth of the number to either side counts as that: the figures of the time
can't be read off more exactly.

What the paper leaves open, above all the scale of the histogram and the spread of the
initial weights, was chosen by four of its numbers. Their statements are marked as
fitted: that they hold is no prediction. The others had no part in any choice.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from math import inf

import pyarrow as pa

from prospect_mj.experiment.paper import corrections, measures
from prospect_mj.experiment.paper.bootstrap import Interval
from prospect_mj.experiment.paper.quantity import Kind
from prospect_mj.experiment.paper.sample import Measure, Sample, estimate
from prospect_mj.experiment.paper.target import Target, Verdict, about


@dataclass(frozen=True)
class Statement:
    """A sentence of the paper."""

    text: str
    """The paper's own words."""
    measure: Measure
    kind: Kind
    target: Target
    fitted: bool = False
    """Whether defaults were chosen by it."""

    @property
    def name(self) -> str:
        """Of its measure, as tables have it."""
        return self.measure.__name__


@dataclass(frozen=True)
class Judgement:
    """A statement, and what was measured."""

    statement: Statement
    measured: Interval
    verdict: Verdict


_DROP = (
    "In the easy trials after random orientations are introduced [...], our results "
    "show a temporary drop in the optimal strategy as the agent explores nonradial "
    "grips."
)

_EARLY_FIRST = (
    "In the child study, late corrections disappear before early corrections, but "
    "in our data, early corrections disappear first."
)
_LATER = Target(1.0, inf, "early first: by a set or more")
EARLY_FIRST = (
    Statement(_EARLY_FIRST, corrections.late_outlasts_early, Kind.LAG, _LATER),
    Statement(
        _EARLY_FIRST, corrections.late_outlasts_early_relatively, Kind.LAG, _LATER
    ),
)
"""Two measures of the same: by a fixed share, and by each correction's largest."""
STATEMENTS = (
    Statement(
        "Initially, the untrained agent performed poorly, with most trials timing out "
        "after ten actions.",
        measures.first_unsolved,
        Kind.SHARE,
        Target(0.5, 1.0, "most: over a half", 0.5),
        fitted=True,
    ),
    Statement(
        "After approximately 650 trials, the agent exhibited nearly optimal "
        "performance.",
        measures.near_optimal,
        Kind.TRIAL,
        about(650, "about 650: 585 to 715"),
        fitted=True,
    ),
    Statement(
        "During pretraining starting at trial 0, the untrained agent initially "
        "exhibited poor performance, but approached optimality after approximately "
        "250 trials.",
        measures.pretraining_near_optimal,
        Kind.TRIAL,
        about(250, "about 250: 225 to 275"),
        fitted=True,
    ),
    Statement(
        "At trial 400, random orientations were introduced. Average actions per trial "
        "rose to over six [...].",
        measures.actions_after_switch,
        Kind.ACTIONS,
        Target(6.0, 7.0, "over 6: 6 to 7", 6.0),
        fitted=True,
    ),
    Statement(
        "Learning then progressed at the same rate as for trials without a dominant "
        "hand.",
        measures.fall_ratio,
        Kind.RATIO,
        about(1, "the same: 0.9 to 1.1 times"),
    ),
    Statement(
        _DROP,
        measures.easy_drop,
        Kind.SHARE,
        Target(0.05, 1.0, "a drop: over 5 points"),
    ),
    Statement(
        _DROP,
        measures.easy_regained,
        Kind.RATIO,
        Target(0.9, inf, "temporary: over 0.9 of it regained"),
    ),
    Statement(
        "With young children, the nonradial corrective strategies are dominant, "
        "whereas in our results, corrective strategies never dominate the optimal "
        "strategy.",
        corrections.correction_margin,
        Kind.SHARE,
        Target(-0.01, 1.0, "never: not by 1 point in any set"),
    ),
    *EARLY_FIRST,
)

FITTED = tuple(said for said in STATEMENTS if said.fitted)
"""Those that choices of what the paper leaves open are held against."""

FURTHER: tuple[tuple[Measure, Kind], ...] = (
    (measures.relearning_ratio, Kind.RATIO),
    (measures.easy_low_trial, Kind.TRIAL),
    (corrections.early_gone, Kind.TRIAL),
    (corrections.late_gone, Kind.TRIAL),
    (corrections.early_largest, Kind.SHARE),
    (corrections.late_largest, Kind.SHARE),
    (corrections.early_faded, Kind.TRIAL),
    (corrections.late_faded, Kind.TRIAL),
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


def table(judgements: Sequence[Judgement]) -> pa.Table:
    """A row for each statement, with the range it is held to and what was measured."""
    return pa.Table.from_pylist(
        [
            {
                "statement": judged.statement.text,
                "measure": judged.statement.name,
                "low_target": judged.statement.target.low,
                "high_target": judged.statement.target.high,
                "measured": judged.measured.estimate,
                "low": judged.measured.low,
                "high": judged.measured.high,
                "lacking": judged.measured.lacking,
                "verdict": str(judged.verdict),
                "fitted": judged.statement.fitted,
            }
            for judged in judgements
        ]
    )
