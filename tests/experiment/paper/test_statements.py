from dataclasses import replace

import numpy as np
import pytest
from synthetic import of_strategies, pair, sampled

from prospect_mj.agent.haptics import LEFT, RIGHT
from prospect_mj.experiment.paper.measures import (
    corrections,
    easy_trials,
    learning,
    quantity,
    statements,
)
from prospect_mj.experiment.paper.measures.bootstrap import Interval
from prospect_mj.experiment.paper.measures.quantity import Kind
from prospect_mj.experiment.paper.measures.sample import Sample
from prospect_mj.experiment.paper.measures.statements import (
    EARLY_FIRST,
    STATEMENTS,
    Judgement,
)
from prospect_mj.experiment.paper.measures.target import Target, Verdict, about, agreed
from prospect_mj.experiment.paper.report import report_statements
from prospect_mj.experiment.populations.scenario import Scenario
from prospect_mj.experiment.populations.strategies import Strategy

INF, NAN = np.inf, np.nan
FALL = next(m for s in STATEMENTS for m in s.measures if "5_to_3" in m.name)


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
    ("low", "end", "verdict"),
    [
        (INF, 1000, Verdict.FAILS),
        (INF, 716, Verdict.FAILS),
        (INF, 715, Verdict.OPEN),
        (INF, 560, Verdict.OPEN),
        (500, 560, Verdict.OPEN),
    ],
)
def test_what_a_short_study_did_not_reach_is_undecided(low, end, verdict):
    assert about(650, "").verdict(Interval(low, low, INF), end) == verdict


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
        (INF, Kind.REVERSED_LAG, "early corrections never gone"),
        (-INF, Kind.REVERSED_LAG, "late corrections never gone"),
        (-0.0063, Kind.POINTS, "-0.6 points"),
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
        ((NAN, INF, INF, 0.9), Kind.LAG, "none"),
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
    ("verdicts", "together"),
    [
        ((Verdict.HOLDS, Verdict.HOLDS), "holds"),
        ((Verdict.FAILS, Verdict.FAILS), "does not hold"),
        ((Verdict.HOLDS, Verdict.FAILS), "depends on the measure"),
        ((Verdict.HOLDS, Verdict.OPEN), "undecided"),
    ],
)
def test_a_statement_with_several_measures_tells_of_each_and_of_all(verdicts, together):
    said = replace(EARLY_FIRST, measures=EARLY_FIRST.measures[:2])
    judged = [
        Judgement(said, measure, Interval(1.0, 1.0, 1.0), verdict)
        for measure, verdict in zip(said.measures, verdicts, strict=True)
    ]
    line = list(report_statements.published(judged))[1].splitlines()[-1]
    assert line.endswith(f"| **{together}** |")
    one, other = (f"{j.measure.title}: 1 (1 to 1), {j.verdict}" for j in judged)
    assert f"| {one}<br>{other} |" in line


def test_what_was_planted_is_judged():
    sample = sampled(*pair(runs=100))
    judged = {j.measure: j for j in statements.judge(sample)}
    # Planted: a chance of 0.97 after 485 trials, 0.93 of which is near-optimal enough.
    near = judged[learning.near_optimal]
    assert 440 <= near.measured.estimate <= 490
    assert near.verdict == Verdict.FAILS
    assert judged[learning.pretraining_near_optimal].measured.estimate < 230
    # Planted: from 0.97 to 0.3, then as fast as without pretraining.
    assert judged[easy_trials.easy_drop].measured.estimate == pytest.approx(
        0.67, abs=0.1
    )
    assert judged[easy_trials.easy_drop].verdict == Verdict.HOLDS
    low, high = judged[FALL].measured[1:3]
    assert low <= 1 <= high


def test_fitted_statements_are_those_that_the_defaults_were_chosen_by():
    numbers = {said.measures[0]: said.target.number for said in statements.FITTED}
    assert numbers == {
        learning.first_unsolved: 0.5,
        learning.near_optimal: 650,
        learning.pretraining_near_optimal: 250,
        learning.actions_after_switch: 6.0,
    }


def test_the_report_marks_fitted_statements_and_no_others():
    sample = sampled(*pair())
    text = "\n".join(report_statements.published(statements.judge(sample)))
    for said in STATEMENTS:
        (line,) = (line for line in text.splitlines() if _tells(line, said))
        assert line.endswith("**, fitted |") == said.fitted
    assert "*Fitted*" in text


def _tells(line, said):
    return line.startswith("|") and f"| {said.measures[0].title}: " in line


def test_what_differs_is_undecided_or_depends_on_the_measure():
    assert agreed([Verdict.HOLDS, Verdict.HOLDS]) == Verdict.HOLDS
    assert agreed([Verdict.FAILS]) == Verdict.FAILS
    assert agreed([Verdict.HOLDS, Verdict.FAILS]) == Verdict.DEPENDS
    assert agreed([Verdict.HOLDS, Verdict.OPEN, Verdict.FAILS]) == Verdict.DEPENDS
    assert agreed([Verdict.HOLDS, Verdict.OPEN]) == Verdict.OPEN
    assert agreed([Verdict.FAILS, Verdict.OPEN]) == Verdict.OPEN


def test_a_study_too_short_to_tell_denies_nothing():
    sample = sampled(*pair(runs=30, trials=700))
    never = np.full_like(sample.mean.baseline.actions[:, :56], 5.0)
    short = Sample(*(cut(one, never) for one in sample))
    verdicts = {j.measure: j.verdict for j in statements.judge(short)}
    assert verdicts[learning.near_optimal] == Verdict.OPEN
    assert verdicts[learning.pretraining_ratio] == Verdict.OPEN
    assert verdicts[FALL] == Verdict.OPEN


def test_a_study_shorter_than_the_papers_denies_nothing_of_its_last_trials():
    # Corrections all along: at the end of a full study that is no tapering off.
    trials = np.arange(700)
    strategy = np.where(trials % 2, Strategy.LATE, Strategy.OPTIMAL)
    lid = np.where((trials < 400) | (trials % 4 < 2), RIGHT, LEFT)
    for length, verdict in ((700, Verdict.OPEN), (1000, Verdict.FAILS)):
        more = length - 700
        used = np.pad(np.tile(strategy, (4, 1)), ((0, 0), (0, more)), mode="wrap")
        sides = np.pad(lid, (0, more), mode="wrap")
        sides[:400] = RIGHT
        sides[700:] = lid[400 : 400 + more]
        dominant = of_strategies(used, sides, Scenario(length, 400))
        sample = sampled(pair(runs=4, trials=length)[0], dominant)
        verdicts = {j.measure: j.verdict for j in statements.judge(sample)}
        assert verdicts[corrections.difficult_left] == verdict


def cut(curves, actions):
    """The first scenario ends before anything was learned."""
    n = len(curves.baseline.actions)
    baseline = replace(curves.baseline, actions=np.repeat(actions, n, axis=0))
    return curves._replace(baseline=baseline)


def test_the_table_has_a_row_for_each_measure_of_a_statement():
    sample = sampled(*pair())
    judged = statements.judge(sample)
    rows = statements.table(judged).to_pylist()
    measured = [(s.text, m.name) for s in STATEMENTS for m in s.measures]
    assert [(row["statement"], row["measure"]) for row in rows] == measured
    assert rows[1]["measured"] == judged[1].measured.estimate
    assert (rows[1]["low_target"], rows[1]["high_target"]) == (585, 715)
    assert [row["fitted"] for row in rows[:6]] == [True] * 3 + [False, True, False]
    assert rows[0]["verdict"] == rows[0]["statement_verdict"]
