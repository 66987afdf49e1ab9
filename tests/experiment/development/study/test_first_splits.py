"""When contexts first split: medians over runs of trials made by hand."""

from dataclasses import replace

import numpy as np
import pytest
from hand_made_runs import B, population

from prospect_mj.actions.action import Action
from prospect_mj.agent.haptics import NONE, RIGHT, haptic_state, n_haptic
from prospect_mj.experiment.development.study.splits import Splits

PRETRAIN = 10


def split(insertions, grasps):
    """Runs whose dominant hand's contexts first split in these trials."""
    made = population([[[B] * 5] * 60] * len(insertions), pretrain=PRETRAIN)
    splits = np.full_like(made.splits, -1)
    splits[:, RIGHT, Action.INSERT_RIGHT] = insertions
    splits[:, NONE, Action.GRASP_RIGHT] = grasps
    found = replace(made, splits=splits)
    return Splits.of(found, np.random.default_rng(0))


def test_trials_count_from_the_end_of_the_pretraining():
    found = split([60, 70, 80], [110, 110, 110])
    assert found.insertion.estimate == 60
    assert found.grasp == pytest.approx((100, 100, 100, 0))


def test_the_median_is_the_trial_of_a_run_even_of_an_even_number():
    assert split([20, 40], [20, 40]).insertion.estimate == 10


def test_what_fewer_than_half_of_the_runs_split_never_splits():
    found = split([-1, -1, 40], [-1, 40, 40])
    assert found.insertion.estimate == np.inf
    assert found.grasp.estimate == 30


def test_other_contexts_don_t_count():
    made = split([50] * 4, [90] * 4)
    population_ = population([[[B] * 5] * 60] * 4, pretrain=PRETRAIN)
    splits = np.full_like(population_.splits, 12)
    splits[:, RIGHT, Action.INSERT_RIGHT] = 50
    splits[:, NONE, Action.GRASP_RIGHT] = 90
    rng = np.random.default_rng(0)
    assert Splits.of(replace(population_, splits=splits), rng) == made


def test_of_the_categories_of_a_grasp_the_first_split_counts():
    made = population([[[B] * 5] * 60] * 4, pretrain=PRETRAIN)
    splits = np.full((4, n_haptic(2), 6), 12, np.int32)
    splits[:, NONE, Action.GRASP_RIGHT] = 90
    for category, trial in enumerate((70, 50)):
        state = haptic_state(RIGHT, category, 2)
        splits[:, state, Action.INSERT_RIGHT] = trial
    found = Splits.of(replace(made, splits=splits), np.random.default_rng(0))
    assert (found.insertion.estimate, found.grasp.estimate) == (40, 80)
    splits[:, haptic_state(RIGHT, 1, 2), Action.INSERT_RIGHT] = -1
    found = Splits.of(replace(made, splits=splits), np.random.default_rng(0))
    assert found.insertion.estimate == 60


def test_the_interval_holds_the_median_of_most_resamples():
    found = split(list(range(20, 120)), [90] * 100).insertion
    assert found.low < found.estimate < found.high
    # A median of 100 of 0 to 99 has a standard error of 5.
    assert 12 < found.high - found.low < 30
