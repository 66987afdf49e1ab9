import numpy as np
import pytest

from prospect_mj.experiment.run.learning_curve import (
    block_means,
    first_near_optimal_window,
    moving_mean,
    settled,
    smoothed_near_optimal_trial,
)


def test_block_means_by_hand():
    assert block_means([1, 3, 2, 6, 9], size=2).tolist() == [2, 4]
    assert block_means([[1, 3, 2, 6], [3, 5, 2, 2]], size=2).tolist() == [3, 3]
    assert block_means([1, 2, 3], size=10).tolist() == []


def test_moving_mean_by_hand():
    assert moving_mean([1, 2, 3, 7], 3).tolist() == [2, 4]
    assert moving_mean([1, 2], 3).size == 0


@pytest.mark.parametrize(
    ("means", "expected"),
    [
        ([8, 5, 3, 2.4, 2.4, 2.4, 2.2], 30),
        ([8, 2, 2, 2, 8, 8, 2, 2, 2], 60),  # not by the first, which does not stay
        ([8, 2, 2, 2, 2, 8], None),
        ([2, 2, 2], 0),
        ([8, 8, 8], None),
        ([2, 2], None),
        # 2.5 in one set is not yet a loss: (2.5 + 2.2 + 2.2) / 3 < 2.4
        ([8, 2.2, 2.2, 2.5, 2.2, 2.2], 10),
    ],
)
def test_smoothed_near_optimal_trial_by_hand(means, expected):
    assert smoothed_near_optimal_trial(means) == expected


def test_settling_by_hand():
    curves = np.array(
        [[9, 3, 2, 3], [9, 4, np.nan, 3], [np.nan, 1, 1, 1], [9, 1, 1, 4]]
    )
    assert settled(curves, 3).tolist() == [1, 2, 0, np.inf]
    assert settled(curves, np.array([[2], [9], [1], [9]])).tolist() == [np.inf, 0, 0, 0]


def test_first_near_optimal_window_by_hand():
    assert first_near_optimal_window([9, 2, 3, 2, 9], window=3) == 1
    assert first_near_optimal_window([9, 2, 3, 9, 2], window=3) is None
    assert first_near_optimal_window(np.full(10, 2), window=50) is None
