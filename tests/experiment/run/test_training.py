import itertools

import numpy as np
import pytest
from ideal_env import IdealEnv
from scipy.stats import binomtest

from prospect_mj.agent import LinearSettings
from prospect_mj.errors import InvalidValue
from prospect_mj.experiment.run.config import TrainConfig
from prospect_mj.experiment.run.records import ACTION_NAMES
from prospect_mj.experiment.run.training import (
    Stream,
    new_learner,
    presented_orientation,
    run_trial,
    train,
    trial_seed,
)


def run(config, **env):
    learner = new_learner(config)
    return list(train(config, IdealEnv(config, **env), learner)), learner


def test_learning_falls_to_near_two_actions():
    finished, _ = run(TrainConfig(trials=850, seed=1))
    n_actions = np.array([trial.trial.n_actions for trial in finished])
    assert n_actions[:50].mean() > 7
    assert n_actions[-100:].mean() < 2.4


def test_pretraining_shows_the_dominant_side_then_both():
    config = TrainConfig(trials=1000, pretrain=400, dominant="left")
    shown = [presented_orientation(config, trial) for trial in range(1000)]
    assert set(shown[:400]) == {"left"}
    assert binomtest(shown[400:].count("left"), 600).pvalue > 0.01
    assert shown != [
        presented_orientation(TrainConfig(seed=1, pretrain=400), trial)
        for trial in range(1000)
    ]


def test_pretraining_does_not_change_what_follows_it():
    plain, pretrained = TrainConfig(), TrainConfig(pretrain=400)
    assert [presented_orientation(plain, trial) for trial in range(400, 600)] == [
        presented_orientation(pretrained, trial) for trial in range(400, 600)
    ]


@pytest.mark.filterwarnings("ignore:(overflow|invalid value) encountered")
@pytest.mark.parametrize("step_size", [8.0, 10.0])
def test_a_learner_that_diverges_is_told_of_and_leaves_numbers_behind(step_size):
    learning = LinearSettings(step_size=step_size, discount=1.0)
    config = TrainConfig(trials=3000, learner=learning)
    learner = new_learner(config)
    after = []

    def keep_all():
        for _ in train(config, IdealEnv(config), learner):
            after.append(learner.weights.copy())

    with pytest.raises(InvalidValue, match="must stay below 2"):
        keep_all()
    assert np.isfinite(after).all()
    assert np.abs(after[-1]).max() > 1e100


def test_streams_are_independent():
    states = {
        tuple(trial_seed(seed, trial, stream).generate_state(4))
        for seed in range(5)
        for trial in range(20)
        for stream in Stream
    }
    assert len(states) == 5 * 20 * len(Stream)


def test_a_trial_depends_on_nothing_but_config_number_and_learner():
    config = TrainConfig(trials=8, seed=3)
    finished, _ = run(config, noise=0.1)
    learner = new_learner(config)
    for trial in range(8):
        alone = run_trial(config, IdealEnv(config, noise=0.1), learner, trial)
        assert alone == finished[trial]


def test_records_tell_the_trial():
    config = TrainConfig(trials=60, seed=2, pretrain=20, dominant="left")
    finished, learner = run(config)
    for number, (trial, actions) in enumerate(finished):
        assert trial.trial == number
        assert trial.pretraining == (number < 20)
        assert [action.step for action in actions] == list(range(trial.n_actions))
        assert actions[0].holding == "none"
        for before, after in itertools.pairwise(actions):
            assert before.next_holding == after.holding
            assert not before.inserted
        assert trial.solved == actions[-1].inserted
        assert trial.solved or trial.n_actions == 10
        assert trial.look == "seen"
        assert trial.sim_seconds == pytest.approx(1.5 * trial.n_actions)
        assert all(
            action.action_name == ACTION_NAMES[action.action] for action in actions
        )
    assert learner.n_updates == sum(trial.n_actions for trial, _ in finished)
    assert any(trial.solved for trial, _ in finished)
    assert any(not trial.solved for trial, _ in finished)


def test_recorded_values_explain_the_choices():
    finished, _ = run(TrainConfig(trials=100, seed=5))
    actions = [action for trial in finished for action in trial.actions]
    greedy = [action for action in actions if not action.explored]
    assert all(a.q_values[a.action] == max(a.q_values) for a in greedy)
    assert 0 < len(greedy) < len(actions)


@pytest.mark.parametrize("bootstrap", [True, False])
def test_cut_off_trial_bootstraps_only_if_asked(bootstrap):
    config = TrainConfig(trials=1, max_actions=2, bootstrap_at_truncation=bootstrap)
    learner = new_learner(config)
    learner.weights[:, -1] = -5.0
    (finished,) = train(config, IdealEnv(config), learner)
    assert not finished.trial.solved
    last = finished.actions[-1]
    learner.weights[:] = np.nan  # the recorded values must be copies
    assert np.isfinite(last.q_values).all()

    again = new_learner(config)
    again.weights[:, -1] = -5.0
    errors = []
    update = again.update
    again.update = lambda *arguments: errors.append(update(*arguments))
    list(train(config, IdealEnv(config), again))
    value = last.q_values[last.action]
    assert errors[-1] == pytest.approx(-1 - value, abs=0.2) or bootstrap
    assert (errors[-1] < 2) == bootstrap


class MaskedEnv(IdealEnv):
    """Offers only grasps while nothing is held, and only insertions else."""

    def _info(self, *given):
        info = super()._info(*given)
        free = self.holding == "none"
        info["action_mask"] = np.array([free, free, 0, 0, not free, not free], np.int8)
        return info


def test_choice_set_of_the_state_is_kept():
    config = TrainConfig(trials=80)
    learner = new_learner(config)
    allowed_next = []
    update = learner.update

    def spy(*arguments):
        allowed_next.append(arguments[0].allowed.astype(int))
        return update(*arguments)

    learner.update = spy
    for finished in train(config, MaskedEnv(config), learner):
        for action in finished.actions:
            assert action.action in ((0, 1) if action.holding == "none" else (4, 5))
    assert {tuple(mask) for mask in allowed_next} == {(0, 0, 0, 0, 1, 1)}


def test_a_mode_keeps_the_learner_to_its_choice_set():
    finished, _ = run(TrainConfig(trials=60, supervisor="productive"))
    offered = {"none": (0, 1), "left": (2, 4), "right": (3, 5)}
    for trial in finished:
        for action in trial.actions:
            assert action.action in offered[action.holding]


def test_shaping_is_lifted_at_its_trial():
    """Without the right hand's actions there is no jar in it; afterwards there is."""
    shaping = ("grasp-right:40", "swap-left-to-right:25")
    config = TrainConfig(trials=80, seed=4, shaping=shaping)
    finished, _ = run(config)
    chosen = [
        (trial.trial.trial, action.action_name)
        for trial in finished
        for action in trial.actions
    ]
    assert min(n for n, name in chosen if name == "grasp-right") == 40
    assert 25 <= min(n for n, name in chosen if name == "swap-left-to-right") < 30
    assert {name for n, name in chosen if n < 25} == set(ACTION_NAMES) - {
        "grasp-right",
        "swap-left-to-right",
    }


def test_a_shaped_trial_depends_on_its_number_and_not_on_those_before():
    config = TrainConfig(trials=8, seed=3, shaping=("grasp-left:4", "insert-left:6"))
    finished, _ = run(config, noise=0.1)
    learner = new_learner(config)
    for trial in range(8):
        alone = run_trial(config, IdealEnv(config, noise=0.1), learner, trial)
        assert alone == finished[trial]
