"""The published statements, each with its measures and the range they are held to.

Wheeler, Fagg and Grupen (2002), section 3.2. Where the paper says "about" or "the
same", a tenth of the number to either side counts as that: the figures of the time
can't be read off more exactly. Where it doesn't say how something was measured, several
measures of the same are taken, and the statement depends on the measure if they differ.

What the paper leaves open, above all the scale of the histogram and the spread of the
initial weights, was chosen by four of its numbers. Their statements are marked as
fitted: that they hold is no prediction. The others had no part in any choice, but one
of them follows from two that are fitted.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import groupby
from math import inf
from typing import NamedTuple

import pyarrow as pa

from prospect_mj.experiment.paper.measures import corrections, easy_trials, learning
from prospect_mj.experiment.paper.measures.bootstrap import Interval
from prospect_mj.experiment.paper.measures.measure import Measure
from prospect_mj.experiment.paper.measures.sample import Sample
from prospect_mj.experiment.paper.measures.target import Target, Verdict, about, agreed
from prospect_mj.experiment.run.learning_curve import BLOCK


@dataclass(frozen=True)
class Statement:
    """Something that the paper says."""

    text: str
    """The paper's own words."""
    measures: tuple[Measure, ...]
    """Of the same thing; one, where there is no doubt how it is to be measured."""
    target: Target
    fitted: bool = False
    """Whether defaults were chosen by it."""
    follows: bool = False
    """Whether it follows from others that are fitted."""


@dataclass(frozen=True)
class Judgement:
    """A statement by one of its measures."""

    statement: Statement
    measure: Measure
    measured: Interval
    verdict: Verdict


_SWITCH = (
    "At trial 400, random orientations were introduced. Average actions per trial rose "
    "to over six primarily due to poor performance on difficult trials, but also due "
    "to interference with easy trials (refer to discussion of Figure 6a)."
)
_TAPERS = (
    "Our results generally show similar characteristics whenever the agent encounters "
    "a new experience [...]: There is an initial increase in nonradial grasps and "
    "subsequent corrective actions which tapers off as the agent learns the optimal "
    "strategy."
)
_DROP = (
    "In the easy trials after random orientations are introduced [...], our results "
    "show a temporary drop in the optimal strategy as the agent explores nonradial "
    "grips."
)
_BY_A_SET = Target(float(BLOCK), inf, "first: by a set or more")

EARLY_FIRST = Statement(
    "In the child study, late corrections disappear before early corrections, but in "
    "our data, early corrections disappear first.",
    (
        *map(corrections.gone_lag, corrections.GONE),
        *map(corrections.faded_lag, corrections.FADED),
    ),
    _BY_A_SET,
)
STATEMENTS = (
    Statement(
        "Initially, the untrained agent performed poorly, with most trials timing out "
        "after ten actions.",
        (learning.first_unsolved,),
        Target(0.5, 1.0, "most: over a half", 0.5),
        fitted=True,
    ),
    Statement(
        "After approximately 650 trials, the agent exhibited nearly optimal "
        "performance.",
        (learning.near_optimal,),
        about(650, "about 650: 585 to 715"),
        fitted=True,
    ),
    Statement(
        "During pretraining starting at trial 0, the untrained agent initially "
        "exhibited poor performance, but approached optimality after approximately "
        "250 trials.",
        (learning.pretraining_near_optimal,),
        about(250, "about 250: 225 to 275"),
        fitted=True,
    ),
    Statement(
        "The agent learned faster during pretraining because the object was always "
        "presented in the same orientation.",
        (learning.pretraining_ratio,),
        Target(0.0, 0.9, "faster: in 0.9 of the time or less"),
        follows=True,
    ),
    Statement(
        _SWITCH,
        (learning.actions_after_switch,),
        Target(6.0, 7.0, "over 6: 6 to 7", 6.0),
        fitted=True,
    ),
    Statement(
        _SWITCH,
        (easy_trials.difficult_part_of_rise,),
        Target(0.5, inf, "primarily: over a half"),
    ),
    Statement(
        _SWITCH,
        (easy_trials.easy_rise_at_once, easy_trials.easy_rise_at_most),
        Target(0.1, inf, "also easy trials: by 0.1 actions or more"),
    ),
    Statement(
        "Learning then progressed at the same rate as for trials without a dominant "
        "hand.",
        tuple(learning.fall_ratio(*levels) for levels in learning.RATE_LEVELS),
        about(1, "the same: 0.9 to 1.1 times"),
    ),
    Statement(
        _TAPERS,
        (corrections.pretraining_increase, corrections.difficult_increase),
        Target(0.05, 1.0, "an increase: over 5 points"),
    ),
    Statement(
        _TAPERS,
        (corrections.pretraining_left, corrections.difficult_left),
        Target(0.0, 0.1, "tapers off: a tenth of it left at most"),
    ),
    Statement(
        "With the object always presented in the same orientation, [...] the agent "
        "quickly learns that late corrections are a poor strategy, early corrections "
        "are better, and the optimal strategy is best.",
        tuple(map(corrections.pretraining_lag, corrections.FADED)),
        _BY_A_SET,
    ),
    Statement(
        _DROP,
        (easy_trials.easy_drop,),
        Target(0.05, 1.0, "a drop: over 5 points"),
    ),
    Statement(
        _DROP,
        (easy_trials.easy_regained,),
        Target(0.9, inf, "temporary: over 0.9 of it regained"),
    ),
    Statement(
        "With young children, the nonradial corrective strategies are dominant, "
        "whereas in our results, corrective strategies never dominate the optimal "
        "strategy.",
        (corrections.smallest_lead, corrections.smallest_mean_lead),
        Target(0.0, 1.0, "never: a lead of zero or more"),
    ),
    EARLY_FIRST,
)

MEASURES = tuple(measure for said in STATEMENTS for measure in said.measures)
FITTED = tuple(said for said in STATEMENTS if said.fitted)
"""Those that choices of what the paper leaves open are held against."""

FURTHER: tuple[Measure, ...] = (
    learning.relearning_ratio,
    learning.most_actions,
    learning.most_actions_trial,
    easy_trials.easy_low_trial,
    corrections.early_largest,
    corrections.late_largest,
    learning.last_actions,
)
"""Measured beside, of which the paper says no number."""


def judge(
    sample: Sample, statements: Sequence[Statement] = STATEMENTS
) -> list[Judgement]:
    """Hold statements against what was measured, by each of their measures."""
    return [
        _judged(statement, measure, sample)
        for statement in statements
        for measure in statement.measures
    ]


def _judged(statement: Statement, measure: Measure, sample: Sample) -> Judgement:
    measured = measure.estimate(sample)
    end = inf if measure.end is None else measure.end(sample.mean)
    verdict = statement.target.verdict(measured, end)
    if measure.of_end and sample.is_short:
        verdict = verdict.not_denied()
    return Judgement(statement, measure, measured, verdict)


class Judged(NamedTuple):
    """A statement by all of its measures."""

    statement: Statement
    judgements: Sequence[Judgement]
    verdict: Verdict
    """What they say together."""


def by_statement(judgements: Sequence[Judgement]) -> list[Judged]:
    """Each statement with what its measures say."""
    groups = groupby(judgements, key=lambda judged: judged.statement)
    listed = [(statement, list(of_it)) for statement, of_it in groups]
    return [
        Judged(statement, of_it, agreed(each.verdict for each in of_it))
        for statement, of_it in listed
    ]


def table(judgements: Sequence[Judgement]) -> pa.Table:
    """A row for each measure of a statement, with the range that it is held to."""
    return pa.Table.from_pylist(
        [
            {
                "statement": statement.text,
                "measure": judged.measure.name,
                "low_target": statement.target.low,
                "high_target": statement.target.high,
                "measured": judged.measured.estimate,
                "low": judged.measured.low,
                "high": judged.measured.high,
                "lacking": judged.measured.lacking,
                "verdict": str(judged.verdict),
                "statement_verdict": str(together),
                "fitted": statement.fitted,
            }
            for statement, of_it, together in by_statement(judgements)
            for judged in of_it
        ]
    )
