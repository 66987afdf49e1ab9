import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from prospect_mj.agent.discovery.feature import Feature, cumulative, draw, measure

VISUAL = np.random.default_rng(3).random(100)


@given(st.integers(0, 2**32))
def test_a_feature_is_the_difference_of_two_parts(seed):
    feature = draw(np.random.default_rng(seed))
    more = VISUAL[feature.begin : feature.end].sum()
    less = VISUAL[feature.less_begin : feature.less_end].sum()
    strength = measure(feature, cumulative(VISUAL))
    np.testing.assert_allclose(strength, more - less, atol=1e-12)


@given(st.integers(0, 2**32))
def test_ranges_lie_in_the_picture_and_have_the_widths_of_their_kind(seed):
    begin, end, less_begin, less_end = draw(np.random.default_rng(seed))
    assert 0 <= begin < end <= 100
    assert 1 <= end - begin <= 16
    assert 0 <= less_begin <= less_end <= 100
    assert less_end - less_begin in (0, *range(2, 17))
    if less_end > less_begin:
        assert end - begin >= 2


def test_kinds_are_equally_frequent_and_every_bin_is_reached():
    rng = np.random.default_rng(0)
    drawn = [draw(rng) for _ in range(3000)]
    bins = [one for one in drawn if one.end - one.begin == 1]
    two = [one for one in drawn if one.less_end > one.less_begin]
    # Three standard deviations of 3000 draws at 1/3: 77.
    assert abs(len(bins) - 1000) < 78
    assert abs(len(two) - 1000) < 78
    assert {one.begin for one in bins} == set(range(100))
    assert max(one.end for one in drawn) == 100


def test_an_empty_range_measures_exactly_zero():
    visual = np.zeros(100)
    visual[:50] = 0.1
    assert measure(Feature(60, 61, 0, 0), cumulative(visual)) == 0.0


def test_many_pictures_are_measured_at_once():
    pictures = np.stack([cumulative(VISUAL), cumulative(2 * VISUAL)])
    feature = Feature(3, 9, 20, 30)
    alone = [measure(feature, picture) for picture in pictures]
    np.testing.assert_array_equal(measure(feature, pictures), alone)
