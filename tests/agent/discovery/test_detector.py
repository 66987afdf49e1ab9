import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.stats import ks_2samp, kstwobign

from prospect_mj.agent.discovery.detector import (
    BETTER,
    WORSE,
    Detector,
    detector,
    likelier_class,
    required_distance,
    separation,
)
from prospect_mj.agent.discovery.feature import Feature, cumulative

samples = st.lists(st.integers(0, 9).map(float), min_size=1, max_size=12).map(np.array)


def test_separation_by_hand():
    # After 2: three quarters of the one, none of the other.
    apart = separation(np.array([2.0, 0.0, 1.0, 7.0]), np.array([5.0, 6.0]))
    assert apart == (0.75, 3.5)
    assert separation(np.array([1.0, 2.0]), np.array([9.0])) == (1.0, 5.5)
    assert separation(np.array([3.0, 3.0]), np.array([3.0])) == (0.0, 3.0)


@given(samples, samples)
def test_distance_is_that_of_kolmogorov_and_smirnov(worse, better):
    distance, cut = separation(worse, better)
    expected = ks_2samp(worse, better, method="asymp").statistic
    assert distance == pytest.approx(expected, abs=1e-12)
    at_cut = abs((worse <= cut).mean() - (better <= cut).mean())
    assert at_cut == pytest.approx(distance, abs=1e-12)


@given(samples, samples)
def test_separation_has_no_favourite(worse, better):
    assert separation(worse, better) == separation(better, worse)


def test_guard_is_the_asymptotic_distribution():
    # P(sqrt(mn / (m + n)) D > x) is 2 exp(-2 x^2), but for terms that don't count here.
    m, n, probability = 30, 20, 1e-4
    scaled = required_distance(m, n, probability) * math.sqrt(m * n / (m + n))
    assert kstwobign.sf(scaled) == pytest.approx(probability, rel=1e-6)


def test_a_perfect_feature_needs_thirteen_examples_of_either_class():
    assert required_distance(12, 12, 1e-5) > 1 > required_distance(13, 13, 1e-5)
    assert required_distance(13, 13, 1e-7) > 1
    assert required_distance(13, 40, 1e-5) < required_distance(13, 13, 1e-5)


def pictures(*first_bins):
    """Cumulative histograms that differ in their first bin."""
    visual = np.zeros((len(first_bins), 100))
    visual[:, 0] = first_bins
    return np.array([cumulative(row) for row in visual])


def test_detector_counts_where_it_is_there():
    found = detector(Feature(0, 1, 0, 0), pictures(1, 2, 6), pictures(5, 6, 7, 3))
    assert (found.distance, found.cut) == (pytest.approx(2 / 3), 2.5)
    assert found.present.tolist() == [1, 4]
    assert found.total.tolist() == [3, 4]


def some_detector(begin, present, total=(8, 8)):
    """That of one bin, there where it is not empty."""
    counts = np.array(present), np.array(total)
    return Detector(Feature(begin, begin + 1, 0, 0), 0.0, 1.0, *counts)


def test_naive_bayes_by_hand():
    visual = np.zeros(100)
    visual[0] = 1.0
    picture = cumulative(visual)
    # There: (1 + 1) / 10 against (6 + 1) / 10.
    first = some_detector(0, [1, 6])
    assert likelier_class([first], picture) == BETTER
    # Not there: (8 - 2 + 1) / 10 against (8 - 8 + 1) / 10: .2 x .7 > .7 x .1.
    second = some_detector(1, [2, 8])
    assert likelier_class([second], picture) == WORSE
    assert likelier_class([first, second], picture) == WORSE
    # .2 x .7 < .7 x .3
    assert likelier_class([first, some_detector(1, [2, 6])], picture) == BETTER


def test_equal_likelihoods_are_no_better_class():
    assert likelier_class([some_detector(0, [4, 4])], pictures(1)[0]) == WORSE


def test_counts_are_smoothed_after_laplace():
    # Never there in either class; rarer where more were seen.
    few = some_detector(0, [0, 0], total=(20, 2))
    assert likelier_class([few], pictures(1)[0]) == BETTER
