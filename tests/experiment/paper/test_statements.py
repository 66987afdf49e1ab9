import numpy as np
import pytest
from synthetic import pair, sampled

from prospect_mj.experiment.paper import (
    measures,
    quantity,
    report_statements,
    statements,
)
from prospect_mj.experiment.paper.bootstrap import Interval
from prospect_mj.experiment.paper.quantity import Kind
from prospect_mj.experiment.paper.sample import title
from prospect_mj.experiment.paper.statements import Judgement
from prospect_mj.experiment.paper.target import Target, Verdict, about, agreed

INF, NAN = np.inf, np.nan


@pytest.mark.parametrize(
    ("low", "high", "verdict"),
    [
        (640, 660, Verdict.HOLDS),
        (585, 715, Verdict.HOLDS),
        (560, 590, Verdict.OPEN),
        (300, 1000, Verdict.OPEN),
        (100, INF, Verdict.OPEN),
        (500, 580, Verdict.FAILS),
        (716, 800, Verdict.FAILS),
        (INF, INF, Verdict.FAILS),
        (700, INF, Verdict.OPEN),
    ],
)
def test_about_a_number_is_a_tenth_to_either_side(low, high, verdict):
    assert about(650, "").verdict(Interval(low, low, high)) == verdict


@pytest.mark.parametrize(
    ("low", "high", "verdict"),
    [
        (6.1, 6.3, Verdict.HOLDS),
        (5.9, 6.3, Verdict.OPEN),
        (5.0, 5.9, Verdict.FAILS),
        (6.5, 7.5, Verdict.OPEN),
    ],
)
def test_a_comparison_holds_only_with_all_of_the_interval(low, high, verdict):
    over = Target(6, 7, "over 6")
    assert over.verdict(Interval(low, low, high)) == verdict


def test_what_is_not_there_is_undecided():
    any_number = Target(-INF, INF, "")
    assert any_number.verdict(Interval(NAN, NAN, NAN, 1.0)) == Verdict.OPEN
    assert any_number.verdict(Interval(1.0, 1.0, 1.0, 0.2)) == Verdict.OPEN
    assert any_number.verdict(Interval(1.0, 1.0, 1.0, 0.01)) == Verdict.HOLDS


@pytest.mark.parametrize(
    ("value", "kind", "words"),
    [
        (650.0, Kind.TRIAL, "650"),
        (0.4872, Kind.SHARE, "48.7 %"),
        (6.128, Kind.ACTIONS, "6.13"),
        (-0.0001, Kind.SHARE, "0.0 %"),
        (-0.001, Kind.RATIO, "0.00"),
        (-0.001, Kind.ACTIONS, "0.00"),
        (-0.2, Kind.LAG, "0"),
        (-0.01, Kind.RATIO, "-0.01"),
        (INF, Kind.TRIAL, "never"),
        (NAN, Kind.SHARE, "none"),
        (170.0, Kind.LAG, "170"),
        (INF, Kind.LAG, "late corrections never gone"),
        (-INF, Kind.LAG, "early corrections never gone"),
    ],
)
def test_numbers_are_written_as_what_they_are(value, kind, words):
    assert quantity.number(value, kind) == words


@pytest.mark.parametrize(
    ("measured", "kind", "words"),
    [
        ((650.0, 640.0, 660.0), Kind.TRIAL, "650 (640 to 660)"),
        ((INF, INF, INF), Kind.TRIAL, "never"),
        ((650.0, 640.0, INF), Kind.TRIAL, "650 (640 to never)"),
        ((-INF, -INF, -INF), Kind.LAG, "early corrections never gone"),
        ((NAN, NAN, NAN, 1.0), Kind.LAG, "none"),
        ((0.5, 0.4, 0.6, 0.04), Kind.RATIO, "0.50 (0.40 to 0.60)"),
        (
            (0.5, 0.4, 0.6, 0.21),
            Kind.RATIO,
            "0.50 (0.40 to 0.60; none in 21 % of the resamples)",
        ),
    ],
)
def test_intervals_are_written_as_far_as_they_are_there(measured, kind, words):
    assert quantity.with_interval(Interval(*measured), kind) == words


@pytest.mark.parametrize(
    ("verdicts", "words"),
    [
        (
            (Verdict.HOLDS, Verdict.HOLDS),
            "By both measures early corrections disappear",
        ),
        ((Verdict.FAILS, Verdict.FAILS), "By neither measure"),
        ((Verdict.HOLDS, Verdict.FAILS), "can't be told"),
        ((Verdict.HOLDS, Verdict.OPEN), "can't be told"),
        ((Verdict.OPEN, Verdict.OPEN), "can't be told"),
    ],
)
def test_the_report_says_whether_the_order_of_corrections_can_be_told(verdicts, words):
    judged = [
        Judgement(said, Interval(1.0, 1.0, 1.0), verdict)
        for said, verdict in zip(statements.EARLY_FIRST, verdicts, strict=True)
    ]
    assert words in list(report_statements.published(judged))[-1]


def test_what_was_planted_is_judged():
    sample = sampled(*pair(runs=100))
    judged = {j.statement.measure: j for j in statements.judge(sample)}
    # Planted: a chance of 0.97 after 485 trials, 0.93 of which is near-optimal enough.
    near = judged[measures.near_optimal]
    assert 440 <= near.measured.estimate <= 490
    assert near.verdict == Verdict.FAILS
    assert judged[measures.pretraining_near_optimal].measured.estimate < 230
    # Planted: from 0.97 to 0.3, then as fast as without pretraining.
    assert judged[measures.easy_drop].measured.estimate == pytest.approx(0.67, abs=0.1)
    assert judged[measures.easy_drop].verdict == Verdict.HOLDS
    low, high = judged[measures.fall_ratio].measured[1:3]
    assert low <= 1 <= high


def test_fitted_statements_are_those_that_the_defaults_were_chosen_by():
    numbers = {said.measure: said.target.number for said in statements.FITTED}
    assert numbers == {
        measures.first_unsolved: 0.5,
        measures.near_optimal: 650,
        measures.pretraining_near_optimal: 250,
        measures.actions_after_switch: 6.0,
    }


def test_the_report_marks_fitted_statements_and_no_others():
    sample = sampled(*pair())
    text = "\n".join(report_statements.published(statements.judge(sample)))
    for judged in statements.judge(sample):
        (line,) = (line for line in text.splitlines() if _tells(line, judged))
        assert line.endswith("**, fitted |") == judged.statement.fitted
    assert "*Fitted*" in text


def _tells(line, judged):
    return line.startswith("|") and f"| {title(judged.statement.measure)}: " in line


def test_what_differs_is_undecided():
    assert agreed([Verdict.HOLDS, Verdict.HOLDS]) == Verdict.HOLDS
    assert agreed([Verdict.FAILS]) == Verdict.FAILS
    assert agreed([Verdict.HOLDS, Verdict.FAILS]) == Verdict.OPEN
    assert agreed([Verdict.HOLDS, Verdict.OPEN]) == Verdict.OPEN


def test_the_table_has_a_row_for_each_statement():
    sample = sampled(*pair())
    judged = statements.judge(sample)
    rows = statements.table(judged).to_pylist()
    assert [row["statement"] for row in rows] == [s.text for s in statements.STATEMENTS]
    assert rows[1]["measured"] == judged[1].measured.estimate
    assert (rows[1]["low_target"], rows[1]["high_target"]) == (585, 715)
    assert [row["fitted"] for row in rows[:5]] == [True] * 4 + [False]
