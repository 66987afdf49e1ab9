"""Trials until near-optimal, on runs made by hand."""

import numpy as np
import pytest

from prospect_mj.experiment.development.figures.rivals import learning_curves
from prospect_mj.experiment.development.rivals import learning
from prospect_mj.experiment.development.rivals.learning import Runs
from prospect_mj.experiment.development.rivals.settings import (
    LINEAR,
    MASKABLE_PPO,
    RivalSettings,
)


def step(trials, at, runs=4):
    """Ten actions, from a trial on two."""
    return Runs(np.where(np.arange(trials) < at, 10, 2) * np.ones((runs, 1), int), 1.5)


def measured(runs, size=4):
    (row,) = learning.learning({LINEAR: runs}, size, seed=0).to_pylist()
    return row


def test_a_step_is_near_optimal_from_the_step_on():
    row = measured(step(300, 100))
    assert row["all_runs"] == 100
    # A mean over five sets is good once it has left all of the others.
    for bound in ("", "_low", "_high"):
        assert row[f"smoothed{bound}"] == 100
    # Of 50 trials, two and a half may still have ten actions.
    assert row["single_run"] == 100 - 2 + 50
    assert (row["last_actions"], row["runs"], row["trials"]) == (2, 4, 300)
    assert row["seconds_per_run"] == 1.5


def test_who_never_learns_is_never_near_optimal():
    row = measured(step(200, 200))
    assert np.isinf(row["all_runs"])
    assert np.isinf(row["smoothed"])
    assert np.isinf(row["single_run_low"])


def test_a_learner_with_many_runs_is_smoothed_as_if_it_had_few():
    """Each group of ten runs would come out as the deep learners' ten do."""
    chances = np.maximum(np.linspace(8, -30, 800), 0.38)
    actions = 2 + np.random.default_rng(4).poisson(chances, (300, 800))
    few = [measured(Runs(part, 0), 10) for part in np.split(actions, 30)]
    many = measured(Runs(actions, 0), 10)
    for name in ("smoothed", "smoothed_low", "smoothed_high"):
        found = sorted(row[name] for row in few)
        assert found[13] <= many[name] <= found[16]
    assert many["smoothed"] > measured(Runs(actions, 0), 300)["smoothed"]
    assert (many["smoothed_runs"], many["runs"], few[0]["runs"]) == (10, 300, 10)


def test_one_unlucky_group_decides_nothing():
    actions = np.full((30, 200), 2)
    actions[:10] = 10
    row = measured(Runs(actions, 0), 10)
    assert row["smoothed"] == row["smoothed_high"] == 0
    assert np.isinf(row["all_runs"])


def test_smoothed_is_of_the_runs_themselves_and_resamples_only_bound_it():
    """One run of four is slow, and then nearly good enough."""
    actions = np.full((4, 200), 2)
    actions[0, :100] = 10
    actions[0, 100:] = 3
    row = measured(Runs(actions, 0))
    assert row["smoothed"] == row["all_runs"] == 100
    # Drawn twice it makes a mean of 2.5; not drawn at all, one of 2.
    assert row["smoothed_low"] == 0
    assert np.isinf(row["smoothed_high"])


def test_one_unlucky_set_spoils_only_the_strict_measure():
    actions = np.full((10, 300), 2)
    actions[:, 205] = 8
    row = measured(Runs(actions, 0), 10)
    assert row["all_runs"] == 210
    assert row["smoothed"] == 0


def test_a_curve_has_the_mean_of_each_set_and_a_band_round_it():
    rng = np.random.default_rng(1)
    runs = Runs(rng.integers(2, 11, (10, 100)), 0)
    table = learning.curves({LINEAR: runs}, 10, seed=0)
    expected = runs.n_actions.reshape(10, 10, 10).mean(axis=(0, 2))
    np.testing.assert_allclose(table["actions"].to_numpy(), expected)
    assert table["trial"].to_pylist() == list(range(0, 100, 10))
    low, high = table["low"].to_numpy(), table["high"].to_numpy()
    assert (low < expected).all()
    assert (expected < high).all()


def test_a_learner_has_the_same_interval_whoever_else_there_is():
    rng = np.random.default_rng(2)
    both = {name: Runs(rng.integers(2, 4, (5, 90)), 0) for name in (LINEAR, "other")}
    alone = learning.curves({"other": both["other"]}, 5, seed=3)
    assert alone.equals(learning.curves(both, 5, seed=3).slice(9))


def test_all_learners_are_drawn():
    learners = {LINEAR: step(300, 100), MASKABLE_PPO: step(300, 50)}
    table = learning.curves(learners, 4, seed=0)
    pictures = [
        learning_curves(table.slice(0, rows), RivalSettings(deep_runs=4))
        for rows in (30, 60)
    ]
    assert all(picture.startswith(b"\x89PNG") for picture in pictures)
    assert len(pictures[0]) < len(pictures[1])


def test_settings_hold_only_what_can_be_compared():
    with pytest.raises(ValueError, match="learner is 'sarsa'; valid: linear, linear-m"):
        RivalSettings(agents=("sarsa",))
    with pytest.raises(ValueError, match="each of them once"):
        RivalSettings(agents=(LINEAR, LINEAR))
    assert RivalSettings(agents=(LINEAR, MASKABLE_PPO)).deep == (MASKABLE_PPO,)
