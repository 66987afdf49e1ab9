"""The band of recorded runs, and live ones on it."""

from dataclasses import replace

import numpy as np
import pytest
from synthetic import improving, pair

from prospect_mj.experiment.paper.figures import actions_figure
from prospect_mj.experiment.paper.figures.figure_frame import Heading
from prospect_mj.experiment.paper.live import live_check
from prospect_mj.experiment.paper.live.live_folders import FoundRuns
from prospect_mj.experiment.paper.report.report_live import section
from prospect_mj.experiment.populations.scenario import Scenario


def seeded():
    return np.random.default_rng(0)


def band_of_means(curves, size, rng, n):
    """Bounds of means; those of sums are as many times larger."""
    return live_check.band_of_sums(curves, size, rng, n).bounds / size


def test_runs_of_the_same_kind_leave_the_band_as_rarely_as_it_says():
    rng = seeded()
    curves = np.cumsum(rng.standard_normal((500, 30)), axis=1)
    low, high = band_of_means(curves, 20, rng, 1500)
    fresh = np.cumsum(rng.standard_normal((300, 20, 30)), axis=2).mean(axis=1)
    inside = ((low <= fresh) & (fresh <= high)).all(axis=1)
    # Binomial: 285 expected, standard deviation 4.
    assert 268 <= inside.sum() <= 297
    pointwise = np.quantile(fresh, [0.025, 0.975], axis=0)
    assert (low < pointwise[0] + 0.05).all()
    assert (high - low > pointwise[1] - pointwise[0]).all()


def test_p_values_of_runs_of_the_same_kind_are_uniform():
    rng = seeded()
    curves = rng.standard_normal((2000, 12))
    band = live_check.band_of_sums(curves, 20, rng, 1000)
    fresh = rng.standard_normal((500, 20, 12)).sum(axis=1)
    far = live_check.scaled(fresh, band.centre, band.spread).max(axis=1)
    p_values = np.sort([band.p_value(one) for one in far])
    # Kolmogorov and Smirnov: exceeded by one pair of samples, of 500 and 1000, in 100.
    assert np.abs(p_values - np.linspace(0, 1, 500)).max() < 0.089


def test_a_p_value_counts_the_means_that_are_as_far_away():
    band = live_check.Band(np.zeros(1), np.ones(1), np.array([0.5, 1.0, 2.0, 3.0]))
    assert band.p_value(2.0) == pytest.approx(3 / 5)
    assert band.p_value(0.1) == 1.0
    assert band.p_value(np.inf) == pytest.approx(1 / 5)


def test_runs_that_are_all_alike_have_a_band_without_width():
    curves = np.tile([3, 2], (7, 1))
    band = live_check.band_of_sums(curves, 4, seeded(), 50)
    np.testing.assert_array_equal(band.bounds, [[12, 8], [12, 8]])
    away = live_check.scaled(np.array([12, 9]), band.centre, band.spread)
    np.testing.assert_array_equal(away, [0, np.inf])


def test_live_runs_agree_with_their_like_and_not_with_others():
    recorded = pair(runs=300)[0]
    like = improving(20, Scenario(1000), 77).n_actions
    check = live_check.check(FoundRuns(like, 3), recorded, seeded())
    assert check.agrees is True
    assert (check.runs, check.unfinished, check.not_begun) == (20, 3, 0)
    assert check.deviation.inside == 1.0
    assert check.deviation.largest <= check.deviation.reach
    assert check.deviation.p_value >= 0.05
    slow = improving(20, Scenario(1000), 77, speed=0.8).n_actions
    check = live_check.check(FoundRuns(slow, 0), recorded, seeded())
    assert check.agrees is False
    assert 0 < check.deviation.inside < 0.9
    assert check.deviation.largest > check.deviation.reach
    assert check.deviation.p_value < 0.05


def test_where_live_runs_can_be_no_other_than_recorded_ones_they_agree():
    """Means of tenths, such as 2.1, are the same number however they are added up."""
    recorded = pair(runs=30)[0]
    always = np.tile(recorded.n_actions[:1], (30, 1))
    alike = replace(recorded, n_actions=always)
    live = always[:20].astype(np.int64)
    check = live_check.check(FoundRuns(live, 0), alike, seeded())
    assert check.agrees is True
    assert (check.deviation.largest, check.deviation.p_value) == (0.0, 1.0)
    live[0, 500] += 1
    check = live_check.check(FoundRuns(live, 0), alike, seeded())
    assert check.agrees is False
    assert check.deviation.largest == np.inf


@pytest.mark.parametrize("runs", [1, 19])
@pytest.mark.parametrize("speed", [1.0, 0.5])
def test_fewer_runs_than_are_expected_decide_nothing(runs, speed):
    live = improving(runs, Scenario(1000), 77, speed=speed).n_actions
    check = live_check.check(FoundRuns(live, 0), pair(runs=100)[0], seeded())
    assert check.agrees is None
    assert check.not_begun == 20 - runs
    assert check.deviation is not None


def test_without_a_complete_run_nothing_is_compared():
    none = FoundRuns(np.empty((0, 1000), np.int64), 4)
    check = live_check.check(none, pair(runs=5)[0], seeded())
    assert (check.runs, check.unfinished, check.agrees) == (0, 4, None)
    assert check.table.num_rows == 0
    assert "of 4 live runs none is complete" in " ".join(section(check))


@pytest.mark.parametrize(
    ("runs", "unfinished", "speed", "words"),
    [
        (20, 0, 1.0, ["live physics: 20. ", "**They agree.**", "inside in 100.0 %"]),
        (22, 2, 1.0, ["live physics: 22 (2 unfinished). ", "**They agree.**"]),
        (20, 0, 0.5, ["**They do not agree.**", "p < 0.001"]),
        (
            3,
            1,
            1.0,
            [
                "3 (1 unfinished, 16 of the 20 expected not begun). ",
                "**Undecided, as 20 complete runs are expected.**",
            ],
        ),
    ],
)
def test_the_report_tells_runs_deviation_and_verdict(runs, unfinished, speed, words):
    live = improving(runs, Scenario(1000), 77, speed=speed).n_actions
    recorded = pair(runs=300)[0]
    check = live_check.check(FoundRuns(live, unfinished), recorded, seeded())
    told = " ".join(section(check))
    for expected in words:
        assert expected in told
    assert f"{check.deviation.largest:.2f} standard deviations" in told
    assert f"the band reaches to {check.deviation.reach:.2f}" in told


def test_both_are_drawn():
    recorded = pair(runs=50)[0]
    found = FoundRuns(recorded.n_actions[:5], 0)
    check = live_check.check(found, recorded, seeded())
    heading = Heading("Title", "means")
    once, again = (
        actions_figure.live(check.table, heading, 10, 2.0, 5) for _ in range(2)
    )
    assert once == again
    moved = check.table.set_column(1, "live", check.table["recorded"])
    assert actions_figure.live(moved, heading, 10, 2.0, 5) != once
