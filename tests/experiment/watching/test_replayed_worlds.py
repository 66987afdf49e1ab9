"""A run of another world is evaluated, and simulated again, in that world."""

from contextlib import closing
from dataclasses import replace

import numpy as np
import pytest

from prospect_mj.agent.haptics import LEFT, RIGHT
from prospect_mj.envs.settings import PickPlaceSettings
from prospect_mj.errors import RunFolderError
from prospect_mj.experiment.run import fingerprint, session
from prospect_mj.experiment.run.config import TrainConfig
from prospect_mj.experiment.run.environment import make_environment
from prospect_mj.experiment.run.kept_episodes import Kept, path_of
from prospect_mj.experiment.run.run_folder import read_config
from prospect_mj.experiment.view.evaluation_settings import EvaluationSettings
from prospect_mj.experiment.view.run_view import RunView
from prospect_mj.experiment.watching import live_view, replayed
from prospect_mj.experiment.watching.presented_again import present_again
from prospect_mj.experiment.watching.replayed import Choice
from prospect_mj.experiment.watching.shown import Shown
from prospect_mj.recording import worlds
from prospect_mj.recording.hands import inserting_hand
from prospect_mj.recording.key import RecordingKey
from prospect_mj.recording.worlds import WORLDS, World

LIVE = TrainConfig(trials=1, seed=1, max_actions=2, world="post")


def quiet(words):
    pass


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    """One trial of live physics in the world with the post, kept."""
    folder = tmp_path_factory.mktemp("post") / "run"
    session.start(LIVE, folder, say=quiet, kept=Kept.parse("all"))
    return folder


def the_only(path):
    (fetch,) = replayed.of(path, Choice(0), quiet).values()
    return fetch().episode


@pytest.mark.gl
def test_a_run_is_simulated_again_in_its_world(run):
    assert read_config(run).world == "post"
    kept = the_only(run)
    assert kept.scene.props == WORLDS["post"].props
    path = path_of(run, 0)
    path.rename(path.with_suffix(".aside"))
    again = the_only(run)
    path.with_suffix(".aside").rename(path)
    assert again.scene == kept.scene
    np.testing.assert_array_equal(again.states.rows, kept.states.rows)


@pytest.mark.gl
def test_a_run_whose_world_was_changed_since_does_not_go_on(run, monkeypatch):
    changed = {**WORLDS, "post": World("moved", WORLDS["lamp-high"].props)}
    monkeypatch.setattr(fingerprint, "WORLDS", changed)
    with pytest.raises(RunFolderError, match="world has changed since the run began"):
        read_config(run)
    assert fingerprint.WORLD in RunView.read(run).outdated()


@pytest.mark.gl
def test_a_recorded_run_is_presented_again_in_the_world_of_its_recording(tmp_path):
    folder = str(tmp_path / "recording")
    config = replace(LIVE, physics="recorded", grow=True, recording=folder)
    session.start(config, tmp_path / "run", say=quiet)
    assert RecordingKey.read(tmp_path / "recording").config.world == "post"
    view = RunView.read(tmp_path / "run")
    orientation = view.trials["orientation"][0].as_py()
    with closing(present_again(view, 0, orientation)) as watched:
        assert watched.task.settings.scene.props == WORLDS["post"].props
    assert the_only(tmp_path / "run").scene.props == WORLDS["post"].props


@pytest.mark.parametrize("physics", ["live", "recorded"])
def test_an_evaluation_is_of_the_world_that_was_learned_in(physics):
    assert EvaluationSettings(physics=physics).config(LIVE).world == "post"


@pytest.mark.gl
def test_an_environment_and_a_window_show_the_world_that_is_asked_for():
    with closing(make_environment(replace(LIVE, world="noisy"))) as env:
        assert env.task.settings.eyes.noise_sd == WORLDS["noisy"].noise_sd
    shown = live_view._settings(Shown("left", (0,), world="wide-lid"))
    assert shown.scene.props == WORLDS["wide-lid"].props


def test_the_strategy_is_told_by_the_hand_that_inserts_there():
    """A grasp of the body and an insertion: late or optimal, as the world has it."""
    action = {"executed": True, "inserted": False}
    done = [action | {"action": 1}, action | {"action": 5, "inserted": True}]
    trial = {"orientation": "left", "solved": True}
    assert replayed.strategy(trial, done, "post") == "optimal"
    late = [action | {"action": n} for n in (0, 4, 2, 5)]
    late[-1]["inserted"] = True
    assert replayed.strategy(trial, late, "post") == "late correction"
    assert replayed.strategy(trial, late, "noisy") == "solved in another way"


def test_the_hand_that_inserts_is_the_lids_or_over_a_post_the_other_one():
    lid = np.array([LEFT, RIGHT, RIGHT], np.int8)
    for world in worlds.WORLDS:
        expected = [RIGHT, LEFT, LEFT] if world == "post" else lid.tolist()
        hand = inserting_hand(lid, world)
        assert hand.tolist() == expected
        assert hand.dtype == np.int8


def test_every_setting_that_is_handed_on_names_the_world():
    """What a recording is asked for decides whether it is the right one."""
    for world in worlds.WORLDS:
        assert PickPlaceSettings(world=world).recorded_as.world == world
