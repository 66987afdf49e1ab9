"""Figures over seeds, by hand."""

import numpy as np
import pyarrow as pa
import pytest

from prospect_mj.experiment.run.config import TrainConfig
from prospect_mj.experiment.run.records import TrialRecord, trial_table
from prospect_mj.experiment.seeds.seeds_summary import SeedsSummary
from prospect_mj.experiment.view.run_view import RunView


def view(seed, n_actions, pretrain=0):
    config = TrainConfig(trials=len(n_actions), seed=seed, pretrain=pretrain)
    rows = [
        TrialRecord(trial, "left", False, "found", int(n), bool(n < 10), 5.0)
        for trial, n in enumerate(n_actions)
    ]
    return RunView(None, config, None, None, pa.table({}), trial_table(rows))


def learning(at, n_trials=200):
    """Ten actions in each trial, and two from one on."""
    return np.where(np.arange(n_trials) < at, 10, 2)


def test_figures_of_a_seed_are_those_of_its_run():
    summary = SeedsSummary.of([view(3, learning(120))])
    (one,) = summary.seeds
    assert (one.seed, one.first_mean, one.last_mean, one.solved) == (3, 10.0, 2.0, 1.0)
    # Two of fifty trials of ten actions are a mean of 2.32, three are one of 2.48.
    assert one.near_optimal == 118


def test_pretraining_is_not_near_optimal():
    n_actions = np.concatenate([np.full(100, 2), learning(50, 150)])
    summary = SeedsSummary.of([view(0, n_actions, pretrain=100)])
    assert summary.seeds[0].near_optimal == 148


def test_means_are_over_seeds_and_near_optimal_over_those_that_reached_it():
    runs = [view(0, learning(100)), view(1, learning(140)), view(2, learning(200))]
    summary = SeedsSummary.of(runs)
    assert summary.reached == 2
    assert summary.near_optimal.estimate == (98 + 138) / 2
    assert summary.last_mean.estimate == pytest.approx((2 + 2 + 10) / 3)
    assert summary.solved.estimate == pytest.approx(2 / 3)
    assert (summary.solved.low, summary.solved.high) == (0.0, 1.0)


def test_intervals_leave_out_what_can_not_be():
    """Student's intervals of so few seeds would go below zero and beyond ten."""
    runs = [
        view(seed, np.concatenate([np.full(100, 2), learning(at)]), pretrain=100)
        for seed, at in enumerate((40, 140, 200))
    ]
    summary = SeedsSummary.of(runs)
    assert (summary.last_mean.low, summary.last_mean.high) == (2, 10)
    # From the first trial after the pretraining to the last with 49 behind it.
    assert (summary.near_optimal.low, summary.near_optimal.high) == (100, 250)


def test_text_and_page_have_the_same_figures():
    summary = SeedsSummary.of([view(0, learning(100)), view(1, learning(200))])
    for words in (str(summary), summary.markdown()):
        lines = [line.lstrip("| ") for line in words.splitlines()]
        rows = [line for line in lines if line.startswith(("0", "1"))]
        assert "98" in rows[0]
        assert " - " in f"{rows[1]} "
        assert "reached by 1 of 2 seeds" in words
    assert summary.markdown().startswith("# 2 seeds of 200 trials\n\n| seed |")


def test_one_seed_has_no_interval():
    words = str(SeedsSummary.of([view(0, learning(100))]))
    (row,) = (line for line in words.splitlines() if line.startswith("mean"))
    assert "(" not in row


def test_no_seed_may_reach_it():
    summary = SeedsSummary.of([view(0, np.full(60, 10)), view(1, np.full(60, 10))])
    assert summary.reached == 0
    assert np.isnan(summary.near_optimal.estimate)
    assert summary.solved.estimate == 0
