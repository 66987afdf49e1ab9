"""The compiled discovery learner against the readable one, to the last bit."""

import numpy as np
import pytest

from prospect_mj.agent import DiscoverySettings
from prospect_mj.experiment.populations.plain import learn_plainly
from prospect_mj.experiment.populations.population import learn
from prospect_mj.experiment.populations.programme import Programme
from prospect_mj.experiment.populations.scenario import (
    PopulationSettings,
    Scenario,
)
from prospect_mj.recording.recording import Recording

QUICK = {"least_rate": 0.05, "surprise": 0.3, "guard_probability": 0.2, "epsilon": 0.1}
"""Finds features within tens of trials, bad ones among them."""
SCENARIO = Scenario(150, pretrain=30)


@pytest.fixture(scope="module")
def shipped():
    return Recording.load()


def both(recording, scenario=SCENARIO, learner=QUICK, **settings):
    """One run by either."""
    settings = PopulationSettings(learner=DiscoverySettings(**learner), **settings)
    programme = Programme(recording, scenario, settings)
    return learn(programme, 0), learn_plainly(programme, 0)


def assert_equal(compiled, plain):
    for name in ("n_actions", "solved", "action", "executed", "inserted"):
        of_either = getattr(compiled, name), getattr(plain, name)
        np.testing.assert_array_equal(*of_either, name)
    first_split = plain.learner.contexts.first_split
    np.testing.assert_array_equal(compiled.splits, first_split)
    of_plain, of_compiled = plain.learner.state(), compiled.learner.state()
    assert of_plain.keys() == of_compiled.keys()
    for name, array in of_plain.items():
        assert array.tobytes() == of_compiled[name].tobytes(), name


@pytest.mark.parametrize(
    "ablation",
    [
        {},
        {"revalue": "stored"},
        {"revalue": "inherit"},
        {"labels": "return"},
        {"cache": "all"},
        {"labels": "return", "cache": "all", "memory": 10},
        {"share_first": True},
        {"share_first": True, "revalue": "inherit"},
        {"reuse": False, "candidates": 5},
        {"candidates": 100, "features_per_context": 1},
        {"features_per_context": 5, "memory": 15},
        {"search_after_first": False},
        {"expert_phase": True, "candidates": 3},
        {"expert_phase": True, "share_first": True, "features_per_context": 1},
    ],
    ids=lambda ablation: "-".join(ablation) or "none",
)
def test_every_ablation_is_the_same_to_the_last_bit(shipped, ablation):
    compiled, plain = both(shipped, learner=QUICK | ablation)
    assert_equal(compiled, plain)
    assert (compiled.splits >= 0).any()


def test_every_forced_split_is_the_same_to_the_last_bit(shipped):
    splits = (("insert", 60), ("grasp", 90), ("others", 60))
    for revalue in ("examples", "stored", "inherit"):
        learner = QUICK | {"forced_splits": splits, "revalue": revalue}
        compiled, plain = both(shipped, learner=learner)
        assert_equal(compiled, plain)
        assert compiled.splits[0].tolist() == [90, 90, 60, 60, 60, 60]


@pytest.mark.parametrize(
    "settings",
    [
        {"failed_actions": "suppressed"},
        {"bootstrap_at_truncation": False, "max_actions": 5},
        {"supervisor": "productive", "image_noise": 0.05},
    ],
    ids="-".join,
)
def test_every_kind_of_trial_is_the_same_to_the_last_bit(shipped, settings):
    compiled, plain = both(shipped, **settings)
    assert_equal(compiled, plain)
    assert (compiled.splits >= 0).any()


def test_the_learner_as_it_is_finds_its_features_in_this_order(shipped):
    compiled, plain = both(
        shipped, Scenario(640, pretrain=400), {}, failed_actions="suppressed"
    )
    assert_equal(compiled, plain)
    # The dominant hand's insertion, then its grasp, both after the change.
    insertion, grasp = compiled.splits[2, 5], compiled.splits[0, 1]
    assert 400 < insertion < grasp < 640
    assert compiled.learner.contexts.distance[2, 5, 0] > 0.9


def test_trials_and_actions_are_counted(shipped):
    compiled, plain = both(shipped)
    for one in (compiled, plain):
        assert one.learner.n_trials == 150
        assert one.learner.n_updates == one.n_actions.sum()
