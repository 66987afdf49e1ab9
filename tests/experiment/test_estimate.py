"""Intervals: published values, closed forms, and what they cover."""

import numpy as np
import pytest
from scipy import stats

from prospect_mj.experiment.estimate import (
    Estimate,
    clustered_share,
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


@pytest.mark.parametrize(("part", "whole"), [(81, 263), (0, 20), (20, 20)])
def test_clusters_of_one_are_cases(part, whole):
    found, expected = clustered_share(part, whole, whole), share(part, whole)
    assert found.estimate == expected.estimate
    assert found.low == pytest.approx(expected.low, abs=1e-12)
    assert found.high == pytest.approx(expected.high, abs=1e-12)


def test_cases_that_come_in_pairs_count_half():
    assert clustered_share(40, 60, 30) == clustered_share(20, 30, 30)
    # Half a case: the bounds are the roots of (p - b)^2 = z^2 b (1 - b) / n.
    z, found = stats.norm.ppf(0.975), clustered_share(23, 24, 12)
    for bound in (found.low, found.high):
        error = (23 / 24 - bound) ** 2
        assert error == pytest.approx(z**2 * bound * (1 - bound) / 12)


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


def test_a_stratified_mean_has_the_interval_of_a_difference():
    # Half the sum of two means is half the difference of one and the other's negative.
    left, right = [2, 3, 2, 5, 2], [2, 2, 4, 10, 2]
    welch = stats.ttest_ind(left, np.negative(right), equal_var=False)
    low, high = welch.confidence_interval(0.95)
    found = stratified_mean([np.array(left), np.array(right)])
    assert found.estimate == pytest.approx(np.mean(left + right))
    assert (found.low, found.high) == pytest.approx((low / 2, high / 2))


def test_a_single_stratum_has_students_interval():
    values = np.array([2.0, 4.0, 2.0, 10.0])
    few, found = mean_of_few(values), stratified_mean([values])
    assert (found.low, found.high) == pytest.approx((few.low, few.high))


def test_strata_count_by_their_size_and_resemble_the_normal_where_they_are_large():
    rng = np.random.default_rng(3)
    groups = [rng.normal(2, 1, 400), rng.normal(8, 1, 1200)]
    found = stratified_mean(groups)
    # Var of the mean of both: their own spread alone, not their distance.
    reach = 1.96 * np.sqrt(sum(np.var(g) * len(g) for g in groups)) / 1600
    assert found.estimate == pytest.approx(np.concatenate(groups).mean())
    assert found.high - found.estimate == pytest.approx(reach, rel=0.01)
    assert found.estimate - found.low == pytest.approx(reach, rel=0.01)


def test_of_equal_values_a_stratified_mean_has_no_width():
    assert stratified_mean([np.array([2, 2]), np.array([4, 4])]) == Estimate(3, 3, 3)


def test_of_few_trials_the_interval_covers_the_mean_as_often_as_it_says():
    """The percentile bootstrap of three and three covers 78 %."""
    rng = np.random.default_rng(7)
    values = rng.normal(5, 1, (2000, 2, 3))
    found = [stratified_mean(list(groups)) for groups in values]
    covered = np.mean([one.low <= 5 <= one.high for one in found])
    assert 0.935 < covered < 0.985
