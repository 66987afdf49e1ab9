"""Intervals: published values, closed forms, and what they cover."""

import numpy as np
import pytest
from scipy import stats

from prospect_mj.experiment.estimate import (
    Estimate,
    mean_of_few,
    share,
    stratified_mean,
)


@pytest.mark.parametrize(
    ("part", "whole", "low", "high"),
    # Newcombe, Statistics in Medicine 17, 1998, table I, method 3.
    [
        (81, 263, 0.2553, 0.3662),
        (15, 148, 0.0624, 0.1605),
        (0, 20, 0.0, 0.1611),
        (1, 29, 0.0061, 0.1718),
    ],
)
def test_shares_have_wilsons_interval(part, whole, low, high):
    found = share(part, whole)
    assert found.estimate == part / whole
    assert (found.low, found.high) == pytest.approx((low, high), abs=5e-5)


def test_all_solved_leaves_a_chance():
    z = stats.norm.ppf(0.975)
    assert share(100, 100).low == pytest.approx(100 / (100 + z**2))


def test_the_mean_of_few_has_students_interval():
    found = mean_of_few([1.0, 2.0, 3.0])
    reach = 4.302652729911275 / np.sqrt(3)  # t of 2 degrees of freedom, deviation 1
    assert found == Estimate(2.0, pytest.approx(2 - reach), pytest.approx(2 + reach))
    low, high = stats.ttest_1samp([3, 5, 9, 4], 0).confidence_interval(0.95)
    four = mean_of_few([3, 5, 9, 4])
    assert (four.low, four.high) == pytest.approx((low, high))


def test_of_equal_values_the_mean_is_sure_and_of_one_nothing_is_known():
    assert mean_of_few([4.0, 4.0]) == Estimate(4.0, 4.0, 4.0)
    assert mean_of_few([4.0]).words(1) == "4.0"
    assert mean_of_few([]).words(1) == "-"


def test_an_interval_can_leave_out_what_can_not_be():
    assert Estimate(0.9, 0.7, 1.1).within(0, 1) == Estimate(0.9, 0.7, 1)


def test_words_are_rounded_and_scaled():
    assert Estimate(0.5, 0.25, 0.75).words(1, scale=100) == "50.0 (25.0 to 75.0)"


def test_the_bootstrap_of_a_mean_is_near_the_normal_interval():
    rng = np.random.default_rng(3)
    groups = [rng.normal(2, 1, 400), rng.normal(8, 1, 400)]
    found = stratified_mean(groups, rng)
    # Var of the mean of both: their own spread alone, not their distance.
    reach = 1.96 * np.sqrt(sum(np.var(g) for g in groups) / 2 / 800)
    assert found.estimate == pytest.approx(np.concatenate(groups).mean())
    assert found.high - found.estimate == pytest.approx(reach, rel=0.1)
    assert found.estimate - found.low == pytest.approx(reach, rel=0.1)
