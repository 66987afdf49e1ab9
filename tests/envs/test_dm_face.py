"""dm_env's own conformance tests, and what they do not ask."""

from typing import ClassVar

import dm_env
import numpy as np
import pytest
from absl.testing import absltest
from dm_env import specs, test_utils

from prospect_mj.envs.dm_face import PickPlaceDmEnv
from prospect_mj.envs.pick_place import PickPlaceEnv
from prospect_mj.errors import InvalidChoice, InvalidValue

GRASP_LEFT, INSERT_LEFT, INSERT_RIGHT = 0, 4, 5


class Conforms(test_utils.EnvironmentTestMixin):
    """Of an environment that `made` makes; trials are cut off after three actions."""

    made: ClassVar[dict[str, str]] = {}

    def make_object_under_test(self):
        return PickPlaceDmEnv(seed=0, max_actions=3, **self.made)

    def make_action_sequence(self):
        """Beyond an end, and with actions that may not run."""
        for action in (GRASP_LEFT, INSERT_RIGHT, INSERT_LEFT, 1, GRASP_LEFT):
            yield np.int32(action)


class TestRecorded(Conforms, absltest.TestCase):
    made: ClassVar[dict[str, str]] = {"physics": "recorded"}


@pytest.mark.gl
class TestLive(Conforms, absltest.TestCase):
    made: ClassVar[dict[str, str]] = {"gross_motion": "cartesian"}


@pytest.mark.gl
def test_images_are_as_their_specs_say():
    """The rest of conformance does not depend on what is observed."""
    env = PickPlaceDmEnv(seed=0, observation="images", max_actions=1)
    specified = env.observation_spec()
    assert {*specified} == {"features", "action_mask", "left_image", "right_image"}
    try:
        for step in (env.reset(), env.step(INSERT_LEFT), env.step(INSERT_LEFT)):
            assert {*step.observation} == {*specified}
            for name, spec in specified.items():
                spec.validate(step.observation[name])
        assert step.first()
    finally:
        env.close()


def recorded(**settings):
    return PickPlaceDmEnv(seed=3, physics="recorded", **settings)


@pytest.mark.parametrize("shaping", [5, None, "swap-left-to-right:200", {"a": 1}])
def test_a_schedule_that_is_no_list_is_named(shaping):
    with pytest.raises(InvalidValue, match=r"^shaping is .*a list of <action>"):
        recorded(shaping=shaping)


def test_specs_have_names_and_bounds():
    env = recorded()
    assert isinstance(env.action_spec(), specs.DiscreteArray)
    assert env.action_spec().num_values == 6
    seen = env.observation_spec()
    assert {name: spec.name for name, spec in seen.items()} == {
        "features": "features",
        "action_mask": "action_mask",
    }
    assert seen["features"].shape == (303,)
    assert seen["features"].maximum.max() < 2
    assert env.reward_spec().name == "reward"


def test_an_insertion_ends_it_with_no_future():
    env = recorded()
    env.reset()
    while env.info["orientation"] != "left":
        env.reset()
    step = env.step(GRASP_LEFT)
    assert (step.step_type, step.reward, step.discount) == (dm_env.StepType.MID, -1, 1)
    step = env.step(INSERT_LEFT)
    assert (step.step_type, step.reward, step.discount) == (dm_env.StepType.LAST, -1, 0)
    assert env.info["inserted"]
    assert env.step(GRASP_LEFT).first()


def test_a_trial_that_is_cut_off_has_one():
    env = recorded(max_actions=2)
    env.reset()
    env.step(INSERT_LEFT)
    step = env.step(INSERT_LEFT)
    assert (step.step_type, step.reward, step.discount) == (dm_env.StepType.LAST, -1, 1)


def test_it_is_the_same_environment_in_other_terms():
    face, env = (
        recorded(supervisor="productive"),
        PickPlaceEnv(physics="recorded", supervisor="productive"),
    )
    step = face.reset()
    features, info = env.reset(seed=3)
    for action in np.random.default_rng(0).integers(6, size=60):
        assert np.array_equal(step.observation["features"], features)
        assert np.array_equal(step.observation["action_mask"], info["action_mask"])
        assert repr(face.info) == repr(info)
        last, step = step.last(), face.step(action)
        if last:
            features, info = env.reset()
            assert step.first()
        else:
            features, reward, terminated, truncated, info = env.step(action)
            assert step.reward == reward
            assert step.last() == (terminated or truncated)


def test_bad_actions_are_refused_with_the_good_ones():
    env = recorded()
    env.reset()
    with pytest.raises(InvalidChoice, match="valid: 0, 1, 2, 3, 4, 5"):
        env.step(6)


def test_a_seed_that_is_none_is_refused_at_once():
    with pytest.raises(InvalidValue, match="seed is -1"):
        PickPlaceDmEnv(physics="recorded", seed=-1)
