from dataclasses import replace

import numpy as np
import pytest
from synthetic import of_strategies, pair

from prospect_mj.agent.haptics import LEFT, NONE, RIGHT
from prospect_mj.experiment.paper.measures import corrections
from prospect_mj.experiment.paper.measures.bootstrap import band, times_drawn
from prospect_mj.experiment.paper.measures.curves import (
    RunCounts,
    mean_of_sets,
    moving_means,
)
from prospect_mj.experiment.populations.scenario import Scenario
from prospect_mj.experiment.populations.strategies import Strategy

OPTIMAL, EARLY, LATE, OTHER = Strategy


def resampled(counts, rng, n):
    return counts.drawn(times_drawn(len(counts.actions), rng, n))


def by_hand():
    """Two runs of 24 trials, the first ten of them easy: the lid to the right."""
    first = [OPTIMAL] * 6 + [OTHER] * 4 + [LATE] * 10 + [OTHER] * 4
    second = [EARLY] * 10 + [OPTIMAL] * 5 + [LATE] * 5 + [OTHER] * 4
    lid = [RIGHT] * 10 + [RIGHT] * 2 + [LEFT] * 8 + [LEFT] * 4
    return of_strategies([first, second], lid, Scenario(24, 10))


def test_counts_of_a_population_by_hand():
    mean = RunCounts.of(by_hand()).mean()
    assert mean.switch == 1
    # (6 * 2 + 4 * 10 + 10 * 3) / 20, (10 * 4 + 5 * 2 + 5 * 4) / 20; four trials left.
    np.testing.assert_allclose(mean.actions, [[4.1, 3.5]])
    np.testing.assert_allclose(mean.unsolved, [[0.2, 0.0]])
    np.testing.assert_allclose(
        mean.easy.strategies[0, :, 0], [6 / 20, 10 / 20, 0, 4 / 20]
    )
    np.testing.assert_allclose(mean.easy.strategies[0, :, 1], [2 / 4, 0, 2 / 4, 0])
    np.testing.assert_allclose(
        mean.difficult.strategies[0, :, 1], [3 / 16, 0, 13 / 16, 0]
    )
    assert np.isnan(mean.difficult.strategies[0, :, 0]).all()
    # First grasps: in the first set ten of twenty trials are early corrections.
    np.testing.assert_allclose(mean.easy.grips[0, :, 0], [0.5, 0.5])
    np.testing.assert_allclose(mean.difficult.grips[0, :, 1], [3 / 16, 13 / 16])


def test_a_trial_without_a_grasp_has_no_grip():
    population = of_strategies([[OTHER] * 10], RIGHT, Scenario(10))
    hand = population.first_hand.copy()
    hand[0, :4], hand[0, 4:6] = NONE, LEFT
    mean = RunCounts.of(replace(population, first_hand=hand)).mean()
    np.testing.assert_allclose(mean.easy.grips[0, :, 0], [4 / 6, 2 / 6])


@pytest.mark.parametrize("runs", [3, 7, 49, 1000])
def test_a_mean_of_just_the_threshold_is_the_threshold(runs):
    # Two sets with 2 and 2.8 actions in turn: 2.4 of all runs, or of equal shares.
    strategy = np.full((2 * runs, 10), OPTIMAL)
    strategy[::2, :8] = EARLY
    counts = RunCounts.of(of_strategies(strategy, RIGHT, Scenario(10)))
    assert counts.mean().actions[0, 0] == 2.4
    turns = np.random.default_rng(0).integers(1, 9, size=(100, runs))
    times = np.repeat(turns, 2, axis=1).astype(float)
    assert (counts.drawn(times).actions == 2.4).all()


@pytest.mark.parametrize("runs", [7, 49, 1000])
def test_a_share_of_just_the_threshold_is_the_threshold(runs):
    # One trial of fifty, the other runs have no difficult ones.
    strategy = np.full((5 * runs, 10), LATE)
    strategy[::5, 0] = EARLY
    counts = RunCounts.of(of_strategies(strategy, LEFT, Scenario(10)))
    assert counts.mean().difficult.strategies[0, EARLY, 0] == corrections.GONE[0]


def test_equal_means_are_equal_to_the_last_bit_in_whatever_order_runs_come():
    counts = RunCounts.of(pair(runs=97)[1])
    order = np.random.default_rng(0).permutation(97)
    shuffled = RunCounts.of(
        replace(
            population := pair(runs=97)[1],
            **{
                name: getattr(population, name)[order]
                for name in ("lid", "n_actions", "solved", "strategy", "first_hand")
            },
        )
    )
    np.testing.assert_array_equal(shuffled.mean().actions, counts.mean().actions)
    np.testing.assert_array_equal(
        shuffled.mean().easy.strategies, counts.mean().easy.strategies
    )


def test_shares_of_all_strategies_add_up_to_one():
    curves = resampled(RunCounts.of(pair()[1]), np.random.default_rng(0), 50)
    np.testing.assert_allclose(curves.easy.strategies.sum(axis=1), 1)
    np.testing.assert_allclose(curves.difficult.strategies[..., 40:].sum(axis=1), 1)
    assert np.isnan(curves.difficult.strategies[..., :40]).all()


def test_resamples_spread_as_the_mean_of_so_many_runs_does():
    population = pair(runs=200)[0]
    counts = RunCounts.of(population)
    many = resampled(counts, np.random.default_rng(1), 4000).actions
    standard_error = (counts.actions / 10).std(axis=0) / np.sqrt(200)
    np.testing.assert_allclose(many.mean(axis=0), counts.mean().actions[0], rtol=0.01)
    np.testing.assert_allclose(many.std(axis=0), standard_error, rtol=0.06)


def test_runs_that_are_all_alike_leave_no_doubt():
    strategy = np.full((5, 20), LATE)
    counts = RunCounts.of(of_strategies(strategy, RIGHT, Scenario(20)))
    low, high = band(resampled(counts, np.random.default_rng(0), 100).actions)
    np.testing.assert_allclose([low, high], 4)


def test_a_mean_of_sets_passes_over_those_without_a_trial():
    shares = np.array([[0.2, np.nan, 0.4], [np.nan] * 3])
    np.testing.assert_allclose(mean_of_sets(shares), [0.3, np.nan])


def test_moving_means_pass_over_sets_without_a_trial_and_stop_at_the_ends():
    shares = np.array([[1.0, 2.0, np.nan, 4.0, 5.0, 6.0]])
    np.testing.assert_allclose(moving_means(shares), [[12 / 4, 17 / 4]])
    np.testing.assert_allclose(moving_means(shares[:, :3]), [[1.5]])


def test_the_same_seed_gives_the_same_band():
    counts = RunCounts.of(pair()[0])
    once, again = (resampled(counts, np.random.default_rng(3), 20) for _ in range(2))
    np.testing.assert_array_equal(once.actions, again.actions)
    other = resampled(counts, np.random.default_rng(4), 20)
    assert (once.actions != other.actions).any()


@pytest.mark.parametrize("n_trials", [9, 10, 11])
def test_only_full_sets_count(n_trials):
    strategy = np.full((2, n_trials), OPTIMAL)
    counts = RunCounts.of(of_strategies(strategy, RIGHT, Scenario(n_trials)))
    assert counts.actions.shape == (2, n_trials // 10)
