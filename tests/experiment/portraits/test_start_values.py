"""Q-values at the start, and names that don't cover each other."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from prospect_mj.experiment.portraits.start_value_picture import apart, first_values

heights = arrays(np.float64, st.integers(1, 8), elements=st.floats(-300, 300))


@given(heights, st.floats(0.5, 20))
def test_names_keep_their_distance_and_order(wanted, least):
    spread = apart(wanted, least)
    order = wanted.argsort(kind="stable")
    assert (np.diff(np.sort(spread)) >= least - 1e-9).all()
    rising = spread[order][np.r_[True, np.diff(wanted[order]) > 0]]
    assert (np.diff(rising) > 0).all()


@given(heights)
def test_names_that_have_room_stay(wanted):
    roomy = 40.0 * np.argsort(np.argsort(wanted)) + wanted / 300
    np.testing.assert_allclose(apart(roomy, 10.0), roomy, atol=1e-9)


def test_names_at_one_height_are_spread_to_both_sides():
    np.testing.assert_allclose(np.sort(apart(np.zeros(3), 10.0)), [-10, 0, 10])


def test_first_values_are_those_before_the_first_action(pretrained):
    values = first_values(pretrained)
    assert values.shape == (pretrained.n_trials, 6)
    for trial in (0, 7, 229):
        row = pretrained.actions_of(trial).to_pylist()[0]
        assert row["step"] == 0
        assert values[trial].tolist() == row["q_values"]
