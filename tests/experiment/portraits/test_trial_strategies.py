"""Which strategy each trial of a run was, and its share in sets."""

import numpy as np
import pytest

from prospect_mj.actions.action import Action
from prospect_mj.agent.haptics import LEFT, RIGHT
from prospect_mj.experiment.populations.strategies import Strategy
from prospect_mj.experiment.portraits.trial_strategies import (
    SET,
    TrialStrategies,
    set_edges,
    set_size,
)
from prospect_mj.experiment.run.records import (
    ActionRecord,
    TrialRecord,
    action_table,
    trial_table,
)

GL, GR, LR, RL, IL, IR = Action
# What was done with the lid on one side, and what that is called. The jar is inserted
# by the last action unless the trial is another one.
TOLD = [
    ("left", (GL, IL), Strategy.OPTIMAL),
    ("right", (GL, LR, IR), Strategy.EARLY),
    ("right", (GL, IL, LR, IR), Strategy.LATE),
    ("left", (GR, RL, LR, RL, LR, RL, LR, RL, LR, RL), Strategy.OTHER),
    ("right", (GR, IR), Strategy.OPTIMAL),
]


def record(trial, step, action, inserted):
    return ActionRecord(
        trial=trial,
        step=step,
        action=int(action),
        action_name=action.label,
        explored=False,
        holding="none",
        q_values=(0.0,) * 6,
        executed=True,
        result="success",
        next_holding="none",
        reward=-1.0,
        sim_seconds=1.0,
        inserted=inserted,
    )


@pytest.fixture(scope="module")
def found():
    trials, actions = [], []
    for number, (lid, done, strategy) in enumerate(TOLD):
        solved = strategy is not Strategy.OTHER
        last = len(done) - 1
        trials.append(
            TrialRecord(number, lid, False, "found", len(done), solved, 1.0 * len(done))
        )
        actions += [
            record(number, step, action, solved and step == last)
            for step, action in enumerate(done)
        ]
    return TrialStrategies.of(trial_table(trials), action_table(actions))


def test_trials_of_different_length_are_classified_one_by_one(found):
    assert found.strategy.tolist() == [strategy for *_, strategy in TOLD]
    assert found.lid.tolist() == [LEFT, RIGHT, RIGHT, LEFT, RIGHT]


def test_shares_by_hand(found):
    everyone = np.ones(5, np.bool_)
    shares = found.shares(everyone, np.array([0, 2, 5]))
    assert shares[:, 0].tolist() == [0.5, 0.5, 0.0, 0.0]
    np.testing.assert_allclose(shares[:, 1], [1 / 3, 0, 1 / 3, 1 / 3])


def test_shares_of_a_kind_leave_the_others_out_and_a_set_without_it_empty(found):
    shares = found.shares(found.lid == LEFT, np.array([0, 1, 3, 5]))
    assert shares[:, 0].tolist() == [1, 0, 0, 0]
    assert np.isnan(shares[:, 1]).all()
    assert shares[:, 2].tolist() == [0, 0, 0, 1]


@pytest.mark.parametrize(
    ("n_trials", "pretrain"), [(1, 0), (7, 3), (230, 80), (1000, 420), (300, 300)]
)
def test_sets_cover_every_trial_once_and_mix_no_phases(n_trials, pretrain):
    edges = set_edges(n_trials, pretrain)
    assert (edges[0], edges[-1]) == (0, n_trials)
    assert (np.diff(edges) > 0).all()
    assert np.diff(edges).max() <= set_size(n_trials)
    assert pretrain in edges


def test_a_run_that_has_not_come_to_its_end_of_pretraining_has_sets():
    assert set_edges(12, 400).tolist() == [0, 10, 12]


def test_long_runs_have_sets_of_fifty():
    assert set_size(1000) == SET == 50
    assert set_size(20) == 10
