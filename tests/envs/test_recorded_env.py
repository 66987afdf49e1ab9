"""The environment on recorded physics: the same interface, at memory speed."""

import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import gymnasium
import numpy as np
import pytest
from ideal_grower import SECONDS, grown_tree

import prospect_mj  # noqa: F401  (registers the environment)
from prospect_mj import paths
from prospect_mj.agent.features import StateFeatureGenerator
from prospect_mj.agent.haptics import LEFT, RIGHT
from prospect_mj.envs.pick_place import PickPlaceEnv
from prospect_mj.envs.settings import PickPlaceSettings
from prospect_mj.errors import InvalidChoice, InvalidValue, RecordingError
from prospect_mj.recording import provenance
from prospect_mj.recording.config import RecordingConfig
from prospect_mj.recording.growing import GrowingRecording
from prospect_mj.recording.key import RecordingKey
from prospect_mj.recording.recording import Recording
from prospect_mj.task.presentation import ORIENTATIONS, PresentationSettings

ENV_ID = "prospect_mj/PickPlace-v0"
# Grasp left or right, swap, insert left or right, by the hand.
GRASP = {"left": 0, "right": 1}
SWAP_FROM = {"left": 2, "right": 3}
INSERT = {"left": 4, "right": 5}
OTHER = {"left": "right", "right": "left"}


@pytest.fixture(scope="module")
def recording():
    return Recording.load()


@pytest.fixture(scope="module")
def env():
    # Gymnasium's checker remembers the first calls: of one test, in the next one.
    env = gymnasium.make(ENV_ID, physics="recorded", disable_env_checker=True)
    yield env
    env.close()


def follow(env, lid, actions, seed=0):
    """The infos of a trial's steps; the features stay within their space."""
    observation, info = env.reset(seed=seed, options={"orientation": lid})
    infos = [info]
    for action in actions:
        observation, reward, terminated, truncated, info = env.step(action)
        assert env.observation_space.contains(observation)
        assert reward == -1.0
        infos.append({**info, "terminated": terminated, "truncated": truncated})
    return infos


def test_gymnasiums_own_check_finds_nothing(gymnasiums_check):
    gymnasiums_check(physics="recorded")


@pytest.mark.parametrize("lid", ORIENTATIONS)
def test_two_actions_solve_a_trial(env, lid):
    last = follow(env, lid, [GRASP[lid], INSERT[lid]])[-1]
    assert last["terminated"]
    assert last["inserted"]
    assert last["result"] == "success"
    assert last["holding"] == "none"


@pytest.mark.parametrize("lid", ORIENTATIONS)
def test_a_late_correction(env, lid):
    wrong = OTHER[lid]
    actions = [GRASP[wrong], INSERT[wrong], SWAP_FROM[wrong], INSERT[lid]]
    infos = follow(env, lid, actions)[1:]
    assert [i["result"] for i in infos] == ["success", "jammed", "success", "success"]
    assert [i["holding"] for i in infos] == [wrong, wrong, lid, "none"]
    assert all(i["executed"] and i["sim_seconds"] > 1 for i in infos)


def test_an_action_that_may_not_run_changes_nothing(env):
    infos = follow(env, "left", [4, 1, 0, 2, 5])[1:]
    assert [i["executed"] for i in infos] == [False, True, False, False, True]
    assert infos[0]["result"] == "not_allowed"
    assert infos[0]["sim_seconds"] == 0.0
    assert [i["holding"] for i in infos] == ["none", *["right"] * 4]


def test_ten_executed_actions_are_recorded_everywhere(env):
    """A random policy never leaves the recording, and is cut off after ten actions."""
    rng = np.random.default_rng(3)
    longest = 0
    for seed in range(200):
        env.reset(seed=seed)
        done, executed = False, 0
        while not done:
            action = int(rng.integers(6))
            _, _, terminated, truncated, info = env.step(action)
            executed += info["executed"]
            done = terminated or truncated
        longest = max(longest, executed)
    assert longest >= 7
    infos = follow(env, "left", [GRASP["right"], *[INSERT["right"]] * 9])
    assert infos[-1]["truncated"]
    assert sum(i["executed"] for i in infos) == 10


def test_the_features_are_those_of_the_recorded_picture(env, recording):
    shown = recording.presentations
    env.reset(seed=5, options={"orientation": "right"})
    root = env.unwrapped.task.node
    number = int(np.flatnonzero(shown.root == root)[0])
    assert shown.lid[number] == RIGHT
    observation, *_ = env.step(INSERT["left"])
    expected = StateFeatureGenerator().generate(shown.histogram[number], "none")
    np.testing.assert_array_equal(observation, expected)


def test_every_presentation_is_shown_and_none_more_often(env, recording):
    counts = np.zeros(len(recording.nodes.child), int)
    for seed in range(2000):
        env.reset(seed=seed, options={"orientation": "left"})
        counts[env.unwrapped.task.node] += 1
    left = recording.presentations.root[recording.presentations.lid == LEFT]
    assert counts[left].sum() == 2000
    expected = 2000 / len(left)
    assert abs(counts[left] - expected).max() < 5 * np.sqrt(expected)


def test_the_same_seed_gives_the_same_trials(env):
    one = follow(env, "left", [1, 5, 3, 4], seed=7)
    other = follow(env, "left", [1, 5, 3, 4], seed=7)
    assert repr(one) == repr(other)
    first, _ = env.reset(seed=7)
    again, _ = env.reset(seed=7)
    np.testing.assert_array_equal(first, again)
    assert (env.reset(seed=8)[0] != first).any()


def test_a_closed_environment_says_so():
    env = PickPlaceEnv(physics="recorded")
    env.reset(seed=0)
    env.close()
    for use in (env.reset, env.render, lambda: env.step(0)):
        with pytest.raises(gymnasium.error.ClosedEnvironmentError):
            use()
    env.close()


def test_it_needs_neither_mujoco_nor_opengl():
    code = (
        "import sys, gymnasium, prospect_mj\n"
        "env = gymnasium.make('prospect_mj/PickPlace-v0', physics='recorded')\n"
        "env.reset(seed=0); env.step(0)\n"
        "assert not {'mujoco', 'mink', 'dm_control'} & set(sys.modules)"
    )
    subprocess.run([sys.executable, "-c", code], check=True)


def test_there_is_nothing_to_render():
    with pytest.raises(InvalidValue, match="'human'; expected None on recorded"):
        PickPlaceEnv(physics="recorded", render_mode="human")
    # Asked for by Stable-Baselines3's make_vec_env, and then never called.
    env = PickPlaceEnv(physics="recorded", render_mode="rgb_array")
    assert env.metadata["render_modes"] == []
    with pytest.raises(InvalidValue, match=r"'rgb_array'; .* nothing is simulated"):
        env.render()


def test_it_has_no_live_scene(env):
    with pytest.raises(RecordingError, match="no model and data"):
        _ = env.unwrapped.model


def test_other_sources_or_versions_are_warned_of_and_stepped(monkeypatch):
    monkeypatch.setattr(provenance, "source_digest", lambda: "changed")
    monkeypatch.setattr(provenance, "PACKAGES", ("numpy", "mujoco"))
    monkeypatch.setattr(provenance, "_version", lambda package: "0.0")
    with pytest.warns(UserWarning, match=r"mujoco 3\.\S+, not 0\.0.*sources changed"):
        env = PickPlaceEnv(physics="recorded")
    env.reset(seed=0, options={"orientation": "left"})
    assert env.step(0)[4]["executed"]


@pytest.mark.parametrize(
    ("changes", "error", "words"),
    [
        ({"physics": "memory"}, InvalidChoice, "live, recorded"),
        ({"recording": Path("x")}, InvalidValue, "'x'; expected none in live physics"),
        ({"grow": True}, InvalidValue, "expected False in live physics"),
        ({"physics": "recorded", "grow": True}, InvalidValue, "a folder that may grow"),
        ({"colour": "red"}, InvalidChoice, "physics, recording, grow"),
        (
            {"physics": "recorded", "presentation": PresentationSettings(yaw=0.0)},
            InvalidValue,
            "that of the recording",
        ),
        (
            {"physics": "recorded", "gross_motion": "cartesian"},
            RecordingError,
            "recorded with gross motion harmonic, not cartesian",
        ),
        (
            {"physics": "recorded", "object_pose": "truth"},
            RecordingError,
            "recorded with object pose vision, not truth",
        ),
        (
            {"physics": "recorded", "max_actions": 11},
            RecordingError,
            "no presentation with the lid to the left that is complete to 11 .*"
            "both sides have one complete to 10: max_actions=10 steps it",
        ),
        (
            {"physics": "recorded", "max_actions": 128},
            InvalidValue,
            "an integer from 1 to 127",
        ),
        ({"max_actions": "ten"}, InvalidValue, "'ten'; expected an integer"),
        ({"max_actions": 2.5}, InvalidValue, "2.5; expected an integer"),
        ({"max_actions": True}, InvalidValue, "True; expected an integer"),
        ({"max_actions": 0}, InvalidValue, "from 1 to 1000"),
        ({"physics": "recorded", "recording": 5}, InvalidValue, "the path of a folder"),
        ({"physics": "recorded", "recording": ""}, InvalidValue, "path of a folder"),
        ({"grow": "no"}, InvalidChoice, "'no'; valid: False, True"),
        ({"settings": {"max_actions": 9}}, InvalidValue, "a PickPlaceSettings"),
        ({"features": None}, InvalidValue, "features is None; expected a Feat"),
        ({"presentation": 3}, InvalidValue, "presentation is 3; expected a Pres"),
        ({"gross_motion": "fly"}, InvalidChoice, "valid: harmonic, cartesian"),
        ({"object_pose": "guess"}, InvalidChoice, "valid: vision, truth"),
        ({"grid_cells": "x"}, InvalidValue, "grid_cells is 'x'"),
        ({"grid_cells": 1}, InvalidValue, "from 2 to"),
        ({"observation": "pixels"}, InvalidChoice, "valid: features, images"),
        (
            {"physics": "recorded", "observation": "images"},
            InvalidValue,
            "'features' on recorded physics, which holds histograms and no images",
        ),
        ({"width": 0}, InvalidValue, "width is 0; expected an integer from 32"),
        ({"height": 480.0}, InvalidValue, "height is 480.0; expected an integer"),
        (
            {"physics": "recorded", "recording": paths.ASSETS},
            RecordingError,
            "is not a recording",
        ),
    ],
)
def test_what_can_not_be_is_refused(changes, error, words):
    with pytest.raises(error, match=words):
        PickPlaceEnv(**changes)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"orientation": "up"}, "orientation is 'up'; valid: left, right"),
        ({"orientation": None}, "orientation is None; valid: left, right"),
        ({"lid": "left"}, "reset option is 'lid'; valid: orientation, trial"),
        ({"trial": -1}, "trial is -1; expected a whole number from 0"),
        ({"trial": 1.0}, "trial is 1.0; expected a whole number from 0"),
        ({"trial": True}, "trial is True"),
        (["orientation"], "options is .'orientation'.; expected a dictionary"),
    ],
)
def test_bad_reset_options_are_refused_with_the_good_ones(env, options, message):
    with pytest.raises((InvalidChoice, InvalidValue), match=message):
        env.reset(options=options)


def test_a_reset_that_is_refused_draws_nothing():
    refused, other = (PickPlaceEnv(physics="recorded") for _ in range(2))
    for env in (refused, other):
        env.reset(seed=1)
    with pytest.raises(InvalidChoice):
        refused.reset(seed=2, options={"lid": "left"})
    assert np.array_equal(refused.reset()[0], other.reset()[0])


@pytest.mark.parametrize("action", [-1, 6, 2.5, "grasp", None])
def test_bad_actions_are_refused_with_the_good_ones(env, action):
    env.reset(seed=0)
    with pytest.raises(InvalidChoice, match=r"valid: 0, 1, 2, 3, 4, 5"):
        env.unwrapped.step(action)


def test_step_before_reset_is_an_error():
    env = PickPlaceEnv(physics="recorded")
    try:
        with pytest.raises(gymnasium.error.ResetNeeded):
            env.step(0)
    finally:
        env.close()


def test_bad_modes_and_schedules_are_refused_before_anything_is_built():
    with pytest.raises(InvalidChoice, match="valid: none, safe, productive"):
        PickPlaceSettings(supervisor="strict")
    with pytest.raises(InvalidChoice, match="action in shaping is 'push'"):
        PickPlaceSettings(shaping=("push:3",))
    with pytest.raises(InvalidValue, match="something to choose"):
        PickPlaceSettings(
            supervisor="productive", shaping=("grasp-left:1", "grasp-right:1")
        )


@pytest.mark.parametrize("bad", [0, -1, 10**6])
def test_absurd_lengths_of_a_trial_are_refused(bad):
    with pytest.raises(InvalidValue, match="max_actions"):
        PickPlaceSettings(max_actions=bad)


def half_grown(folder, **settings):
    """One presentation of each side, complete to three and to two actions."""
    config = RecordingConfig(**settings)
    with GrowingRecording.open(folder, RecordingKey.present(config)) as recording:
        recording.keep(grown_tree(3, "left", 0))
        recording.keep(grown_tree(2, "right", 0))
    return folder


def test_the_recording_may_be_named_by_a_string(tmp_path):
    folder = half_grown(tmp_path)
    env = PickPlaceEnv(physics="recorded", recording=str(folder), max_actions=2)
    assert env.settings.recording == folder
    env.reset(seed=0, options={"orientation": "left"})
    # As no real one does: the ideal trees' outcomes take this long.
    assert env.step(0)[4]["sim_seconds"] == SECONDS


def test_what_is_half_grown_is_stepped_as_far_as_it_goes(tmp_path):
    half_grown(tmp_path)
    with pytest.raises(RecordingError, match=r"complete to 2: max_actions=2 steps it"):
        PickPlaceEnv(physics="recorded", recording=tmp_path)
    env = PickPlaceEnv(physics="recorded", recording=tmp_path, max_actions=2)
    for lid in ORIENTATIONS:
        assert follow(env, lid, [GRASP[OTHER[lid]], INSERT[OTHER[lid]]])[-1][
            "truncated"
        ]


def test_a_straight_recording_knows_no_grid(tmp_path):
    half_grown(tmp_path, gross_motion="cartesian", grid_cells=8)
    PickPlaceEnv(
        physics="recorded", recording=tmp_path, gross_motion="cartesian", max_actions=2
    )


def test_a_number_of_numpys_is_one():
    env = PickPlaceEnv(physics="recorded", max_actions=np.int32(7))
    assert type(env.settings.max_actions) is int


def test_settings_can_be_given_whole_and_by_name():
    settings = PickPlaceSettings(physics="recorded", supervisor="safe")
    env = PickPlaceEnv(settings, supervisor="productive")
    assert env.settings == replace(settings, supervisor="productive")
    _, info = env.reset(seed=0)
    assert info["action_mask"].tolist() == [1, 1, 0, 0, 0, 0]
