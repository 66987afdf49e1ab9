"""What the learner may choose from, as the environment says; on recorded physics."""

import gymnasium
import numpy as np
import pytest

import prospect_mj  # noqa: F401  (registers the environment)
from prospect_mj.envs.settings import PickPlaceSettings

ENV_ID = "prospect_mj/PickPlace-v0"


@pytest.mark.parametrize(
    ("mode", "mask"),
    [("none", (1,) * 6), ("safe", (1,) * 6), ("productive", (1, 1, 0, 0, 0, 0))],
)
def test_the_action_mask_is_the_choice_set_of_the_mode(mode, mask):
    settings = PickPlaceSettings(physics="recorded", supervisor=mode)
    env = gymnasium.make(ENV_ID, settings=settings)
    try:
        _, info = env.reset(seed=0)
        assert info["action_mask"].dtype == np.int8
        assert tuple(info["action_mask"]) == mask
        booleans = env.get_wrapper_attr("action_masks")()
        assert booleans.dtype == bool
        assert np.array_equal(booleans, info["action_mask"])
        with pytest.raises(AttributeError):
            env.action_masks()  # Gymnasium's wrappers hand nothing through.
        env.action_space.seed(0)
        assert mask[env.action_space.sample(mask=info["action_mask"])]
    finally:
        env.close()


def test_the_choice_set_follows_the_state_and_is_the_supervisors():
    settings = PickPlaceSettings(physics="recorded", supervisor="safe")
    env = gymnasium.make(ENV_ID, settings=settings).unwrapped
    try:
        _, info = env.reset(seed=1, options={"orientation": "left"})
        for action in (0, 2, 5):
            expected = env.task.supervisor.choice_set(env.task.predicates, 0)
            assert np.array_equal(info["action_mask"], expected)
            assert np.array_equal(env.action_masks(), expected.astype(bool))
            *_, info = env.step(action)
            if action == 0:
                assert tuple(info["action_mask"]) == (0, 0, 1, 1, 1, 1)
    finally:
        env.close()


def test_shaping_is_lifted_by_the_trials_number_told_or_counted():
    settings = PickPlaceSettings(physics="recorded", shaping=("insert-left:2",))
    env = gymnasium.make(ENV_ID, settings=settings).unwrapped

    def offered(**options):
        _, info = env.reset(seed=0, options=options)
        return bool(info["action_mask"][4])

    try:
        assert [offered() for _ in range(4)] == [False, False, True, True]
        assert not offered(trial=1)
        assert offered()  # one more than the trial before
        assert not offered(trial=np.int64(0), orientation="left")
        *_, info = env.step(0)
        assert tuple(info["action_mask"]) == (1, 1, 1, 1, 0, 1)
    finally:
        env.close()
