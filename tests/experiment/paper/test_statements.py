import numpy as np
import pytest
from synthetic import pair

from prospect_mj.experiment.paper import measures, statements
from prospect_mj.experiment.paper.bands import Interval
from prospect_mj.experiment.paper.sample import Sample
from prospect_mj.experiment.paper.statements import Kind, Target, Verdict, about

INF = np.inf


@pytest.mark.parametrize(
    ("low", "high", "verdict"),
    [
        (640, 660, Verdict.HOLDS),
        (560, 590, Verdict.HOLDS),
        (500, 580, Verdict.FAILS),
        (716, 800, Verdict.FAILS),
        (INF, INF, Verdict.FAILS),
        (700, INF, Verdict.HOLDS),
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
    over = Target(6, 7, False, "over 6")
    assert over.verdict(Interval(low, low, high)) == verdict


@pytest.mark.parametrize(
    ("value", "kind", "words"),
    [
        (650.0, Kind.TRIAL, "650"),
        (0.4872, Kind.SHARE, "48.7 %"),
        (6.128, Kind.ACTIONS, "6.13"),
        (INF, Kind.TRIAL, "never"),
        (np.nan, Kind.SHARE, "none"),
    ],
)
def test_numbers_are_written_as_what_they_are(value, kind, words):
    assert statements.number(value, kind) == words


def test_what_was_planted_is_judged():
    sample = Sample.of(*pair(runs=100), np.random.default_rng(0))
    judged = {j.statement.measure: j for j in statements.judge(sample)}
    # Planted: a chance of 0.97 after 485 trials, 0.93 of which is near-optimal enough.
    near = judged[measures.near_optimal]
    assert 440 <= near.measured.estimate <= 490
    assert near.verdict == Verdict.FAILS
    assert judged[measures.pretraining_near_optimal].measured.estimate < 230
    # Planted: from 0.97 to 0.3, then as fast as without pretraining.
    assert judged[measures.easy_drop].measured.estimate == pytest.approx(0.67, abs=0.1)
    assert judged[measures.easy_drop].verdict == Verdict.HOLDS
    low, high = judged[measures.fall_ratio].measured[1:]
    assert low <= 1 <= high


def test_the_table_has_a_row_for_each_statement():
    sample = Sample.of(*pair(), np.random.default_rng(0))
    judged = statements.judge(sample)
    rows = statements.table(judged).to_pylist()
    assert [row["statement"] for row in rows] == [s.text for s in statements.STATEMENTS]
    assert rows[1]["measured"] == judged[1].measured.estimate
    assert (rows[1]["low_target"], rows[1]["high_target"]) == (585, 715)
