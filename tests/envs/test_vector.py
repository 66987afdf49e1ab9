"""Many recorded environments at once are as many single ones, to the last bit."""

import time

import gymnasium
import numpy as np
import pytest
from felt_models import THREE
from gymnasium.vector import AutoresetMode, SyncVectorEnv

import prospect_mj  # noqa: F401  (registers the environment)
from prospect_mj.envs.pick_place import PickPlaceEnv
from prospect_mj.envs.settings import PickPlaceSettings
from prospect_mj.envs.vector import RecordedVectorEnv
from prospect_mj.errors import InvalidChoice, InvalidValue, RecordingError
from prospect_mj.recording.batch import RecordedBatch
from prospect_mj.recording.recording import Recording
from prospect_mj.supervisor.supervisor import Supervisor

ENV_ID = "prospect_mj/PickPlace-v0"
N = 5


def chosen(steps, n, seed=0):
    """Actions (steps, n) that end trials both ways, and stall them."""
    return np.random.default_rng(seed).integers(6, size=(steps, n))


def assert_same(found, expected, told=None):
    """Whether two observations or infos are equal where they mean anything."""
    if isinstance(expected, dict):
        assert set(found) == set(expected)
        for key, value in expected.items():
            assert_same(found[key], value, expected.get(f"_{key}"))
        return
    rows = np.ones(len(expected), bool) if told is None else told
    assert found.dtype == expected.dtype
    for one, other in zip(found[rows], expected[rows], strict=True):
        assert np.array_equal(one, other)


@pytest.mark.parametrize("models", [None, THREE])
def test_every_environment_steps_as_a_single_one_does(models):
    told = {"supervisor": "productive", "shaping": ("insert-left:2",)}
    envs = RecordedVectorEnv(N, haptic_models=models, **told)
    alone = [PickPlaceEnv(envs.settings) for _ in range(N)]
    observations, infos = envs.reset(seed=40)
    expected = [env.reset(seed=40 + i) for i, env in enumerate(alone)]
    ended, categories = [False] * N, set()
    for actions in [None, *chosen(80, N)]:
        if actions is not None:
            observations, *rest, infos = envs.step(actions)
            expected = []
            for i, env in enumerate(alone):
                if ended[i]:
                    expected.append(env.reset())
                    assert [part[i] for part in rest] == [0.0, False, False]
                else:
                    seen, *step, told = env.step(actions[i])
                    expected.append((seen, told))
                    assert [part[i] for part in rest] == step
            ended = rest[1] | rest[2]
        categories |= set(infos["category"])
        for i, (seen, told) in enumerate(expected):
            assert np.array_equal(observations[i], seen)
            assert {k for k in infos if not k.startswith("_")} == set(told)
            for key, value in told.items():
                assert infos[f"_{key}"][i]
                assert np.array_equal(infos[key][i], value), key
            assert np.array_equal(envs.action_masks()[i], alone[i].action_masks())
    assert categories == ({-1} if models is None else {-1, 0, 1, 2})


@pytest.mark.parametrize("mode", [AutoresetMode.NEXT_STEP, AutoresetMode.SAME_STEP])
def test_trials_are_reset_as_gymnasium_does_it(mode):
    envs = gymnasium.make_vec(
        ENV_ID, N, physics="recorded", autoreset_mode=mode, max_actions=4
    )
    others = gymnasium.make_vec(
        ENV_ID,
        N,
        vectorization_mode="sync",
        vector_kwargs={"autoreset_mode": mode},
        physics="recorded",
        max_actions=4,
    )
    assert isinstance(envs, RecordedVectorEnv)
    assert envs.metadata["autoreset_mode"] is mode
    assert envs.observation_space == others.observation_space
    assert envs.action_space == others.action_space
    options = {"orientation": "right"}
    seeds = [3, 1, 4, 1, 5]
    for found, expected in zip(
        envs.reset(seed=seeds, options=options),
        others.reset(seed=seeds, options=options),
        strict=True,
    ):
        assert_same(found, expected)
    ends = 0
    for actions in chosen(60, N, seed=1):
        found, expected = envs.step(actions), others.step(actions)
        for one, other in zip(found, expected, strict=True):
            assert_same(one, other)
        ends += (found[2] | found[3]).sum()
    assert ends > N


def test_without_autoreset_a_mask_says_which_are_reset():
    envs = RecordedVectorEnv(3, autoreset_mode="Disabled", max_actions=2)
    first, _ = envs.reset(seed=0)
    for _ in range(2):
        after, _, _, truncated, _ = envs.step([0, 1, 4])
    assert truncated.all()
    with pytest.raises(gymnasium.error.ResetNeeded):
        envs.step([0, 0, 0])
    mask = np.array([True, False, True])
    options = {"reset_mask": mask, "orientation": "left"}
    anew, infos = envs.reset(seed=0, options=options)
    assert "reset_mask" in options
    assert infos["_orientation"].tolist() == mask.tolist()
    assert set(infos["orientation"][mask]) == {"left"}
    assert np.array_equal(anew[1], after[1])
    assert not np.array_equal(anew[0], after[0])
    with pytest.raises(gymnasium.error.ResetNeeded):
        envs.step([0, 0, 0])
    envs.reset(options={"reset_mask": ~mask})
    assert np.array_equal(envs.step([4, 4, 4])[1], [-1.0] * 3)
    assert first.shape == (3, 303)


def test_nothing_that_is_returned_is_used_again():
    envs = RecordedVectorEnv(3)
    kept = [envs.reset(seed=0), *(envs.step(a) for a in chosen(5, 3))]
    copies = [[np.copy(part) for part in arrays(result)] for result in kept]
    for result in kept:
        for array in arrays(result):
            array[...] = array[::-1].copy()
    again = RecordedVectorEnv(3)
    fresh = [again.reset(seed=0), *(again.step(a) for a in chosen(5, 3))]
    for before, result in zip(copies, fresh, strict=True):
        for one, other in zip(before, arrays(result), strict=True):
            assert np.array_equal(one, other)


def arrays(result):
    *plain, infos = result
    return [*plain, *infos.values()]


def test_seeds_spread_and_generators_go_on():
    envs = RecordedVectorEnv(4)
    counted, _ = envs.reset(seed=10)
    listed, _ = envs.reset(seed=[10, 11, 12, 13])
    assert np.array_equal(counted, listed)
    stacked, _ = envs.reset(seed=np.arange(10, 14))
    assert np.array_equal(counted, stacked)
    assert envs.np_random_seed == (10, 11, 12, 13)
    on, _ = envs.reset()
    assert not np.array_equal(on, listed)
    some, _ = envs.reset(seed=[10, None, None, None])
    assert np.array_equal(some[0], listed[0])
    assert not np.array_equal(some[1:], listed[1:])


def test_live_physics_is_stepped_one_after_the_other(monkeypatch):
    made = []

    class Single(gymnasium.Env):
        observation_space = gymnasium.spaces.Box(0, 1)
        action_space = gymnasium.spaces.Discrete(6)

        def __init__(self, settings, render_mode):
            made.append((settings, render_mode))

    monkeypatch.setattr("prospect_mj.envs.vector.PickPlaceEnv", Single)
    settings = PickPlaceSettings(max_actions=4)
    asked = {"settings": settings, "supervisor": "safe", "render_mode": "rgb_array"}
    envs = gymnasium.make_vec(ENV_ID, num_envs=2, **asked)
    assert isinstance(envs, SyncVectorEnv)
    wanted = PickPlaceSettings(max_actions=4, supervisor="safe")
    assert made == [(wanted, "rgb_array")] * 2


def test_only_one_may_grow_a_recording(tmp_path):
    with pytest.raises(InvalidValue, match="num_envs is 2; expected 1"):
        gymnasium.make_vec(
            ENV_ID, num_envs=2, physics="recorded", recording=tmp_path, grow=True
        )


@pytest.mark.parametrize(
    ("made", "error", "words"),
    [
        ({"num_envs": 0}, InvalidValue, "num_envs is 0"),
        ({"num_envs": 2, "autoreset_mode": "x"}, InvalidChoice, "NextStep, SameStep"),
        ({"num_envs": 2, "render_mode": "rgb_array"}, InvalidValue, "render_mode"),
        ({"num_envs": 2, "physics": "live"}, InvalidValue, "physics is 'live'"),
        (
            {"num_envs": 2, "recording": "new", "grow": True},
            InvalidValue,
            "grow is True; expected False",
        ),
        ({"num_envs": 2, "colour": "red"}, InvalidChoice, "valid: physics"),
        ({"num_envs": 2, "max_actions": 11}, RecordingError, "complete to 11"),
    ],
)
def test_what_can_not_be_made_is_refused(made, error, words):
    with pytest.raises(error, match=words):
        RecordedVectorEnv(**made)


@pytest.mark.parametrize(
    ("actions", "error", "words"),
    [
        ([0, 1, 6], InvalidChoice, "action is 6; valid: 0, 1, 2"),
        ([0, -1, 1], InvalidChoice, "action is -1"),
        ([0, 1], InvalidValue, r"\(3,\) of integers"),
        ([0.0, 1.0, 2.0], InvalidValue, r"\(3,\) of integers"),
        ([True, True, True], InvalidValue, r"\(3,\) of integers"),
    ],
)
def test_bad_actions_are_refused_and_move_nothing(actions, error, words):
    envs = RecordedVectorEnv(3)
    before, _ = envs.reset(seed=0)
    with pytest.raises(error, match=words):
        envs.step(actions)
    assert np.array_equal(envs.step([4, 4, 4])[0], before)


@pytest.mark.parametrize(
    "reset",
    [
        {"seed": [1, 2]},
        {"seed": [1, -2, 3]},
        {"seed": "123"},
        {"seed": 1.5},
        {"seed": True},
        {"options": 5},
        {"options": {"reset_mask": [True]}},
        {"options": {"reset_mask": np.zeros(3, bool)}},
        {"options": {"lid": "left"}},
    ],
)
def test_bad_resets_are_refused(reset):
    envs = RecordedVectorEnv(3)
    envs.reset(seed=0)
    with pytest.raises((InvalidValue, InvalidChoice)):
        envs.reset(**reset)
    assert envs.np_random_seed == (0, 1, 2)


def test_a_step_before_the_reset_is_an_error():
    with pytest.raises(gymnasium.error.ResetNeeded):
        RecordedVectorEnv(2).step([0, 0])


def test_closed_ones_say_so():
    envs = RecordedVectorEnv(2)
    envs.reset(seed=0)
    envs.close()
    for use in (envs.reset, lambda: envs.step([0, 0])):
        with pytest.raises(gymnasium.error.ClosedEnvironmentError):
            use()
    envs.close()


def test_what_is_not_recorded_is_said_and_no_trial_moves():
    recording = Recording.load()
    batch = RecordedBatch(recording, Supervisor(), 2)
    deepest = int(np.flatnonzero((recording.nodes.child < 0).any(axis=1))[0])
    missing = int(np.flatnonzero(recording.nodes.child[deepest] < 0)[0])
    batch.node[1] = deepest
    before = batch.node.copy()
    with pytest.raises(RecordingError, match="was not recorded: the trial has more"):
        batch.execute(np.arange(2), np.array([0, missing]))
    assert np.array_equal(batch.node, before)


def test_many_at_once_are_faster():
    """Some twenty times; a quarter of that is asked, as machines are busy."""
    n, steps = 1000, 20
    envs, actions = RecordedVectorEnv(n), chosen(steps, n)
    envs.reset(seed=0)
    start = time.process_time()
    for each in actions:
        envs.step(each)
    at_once = n * steps / (time.process_time() - start)
    env = PickPlaceEnv(PickPlaceSettings(physics="recorded"))
    env.reset(seed=0)
    start = time.process_time()
    for action in actions.ravel()[:2000]:
        _, _, terminated, truncated, _ = env.step(action)
        if terminated or truncated:
            env.reset()
    single = 2000 / (time.process_time() - start)
    assert at_once > 5 * single
