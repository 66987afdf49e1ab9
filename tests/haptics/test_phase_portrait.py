"""Phase portraits, computed by hand."""

import numpy as np
import pytest

from prospect_mj.errors import InvalidValue
from prospect_mj.haptics import phase_samples
from prospect_mj.haptics.phase_portrait import together


def test_rate_is_the_residuals_change_in_a_period():
    felt = np.array([[0.30, 0.010], [0.32, 0.014], [0.34, 0.013]])
    expected = [[0.010, 0.0, 0], [0.014, 0.2, 0], [0.013, -0.05, 0]]
    np.testing.assert_allclose(phase_samples(felt), expected, atol=1e-12)


def test_rate_is_zero_where_a_new_probe_begins():
    felt = np.array([[0.30, 0.05], [0.32, 0.05], [0.80, 0.01], [0.82, 0.02]])
    _, rate, probe = phase_samples(felt).T
    np.testing.assert_allclose(rate, [0, 0, 0, 0.5], atol=1e-12)
    np.testing.assert_array_equal(probe, [0, 0, 1, 1])


def test_padding_is_left_out():
    felt = np.array([[0.30, 0.01], [np.nan, np.nan]], np.float32)
    assert phase_samples(felt).shape == (1, 3)
    assert phase_samples(np.full((2, 2), np.nan)).shape == (0, 3)


def test_times_that_stand_still_are_refused():
    with pytest.raises(InvalidValue, match="time between two samples"):
        phase_samples(np.array([[0.3, 0.01], [0.3, 0.01]]))


def test_a_trajectory_without_samples_is_refused():
    with pytest.raises(InvalidValue, match=r"lengths of trajectories is \[1, 0\]"):
        together([np.zeros((1, 3)), np.zeros((0, 3))])
