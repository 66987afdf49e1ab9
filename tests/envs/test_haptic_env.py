"""The category of a grasp as a feature of the state, recorded and live."""

from contextlib import closing

import gymnasium
import numpy as np
import pytest
from felt_models import THREE, models
from gymnasium.utils.env_checker import check_env
from ideal_grower import IdealGrower, key
from ideal_recording import ideal
from ideal_recording import recording as made_recording

import prospect_mj  # noqa: F401  (registers the environment)
from prospect_mj.actions.action import Action, ActionOutcome, ActionResult
from prospect_mj.agent import Observation, StateFeatureGenerator
from prospect_mj.agent.features import HOLDINGS
from prospect_mj.agent.haptics import haptic_state
from prospect_mj.envs.dm_face import PickPlaceDmEnv
from prospect_mj.envs.pick_place import PickPlaceEnv
from prospect_mj.envs.settings import PickPlaceSettings
from prospect_mj.envs.touch import NO_CATEGORY, Touch
from prospect_mj.errors import InvalidValue, RecordingError
from prospect_mj.haptics import TrajectoryModels, categories, phase_samples
from prospect_mj.recording.config import RecordingConfig
from prospect_mj.recording.felt import category_of_nodes, known_samples
from prospect_mj.recording.growing import GrowingRecording
from prospect_mj.recording.lazy_task import LazyTask
from prospect_mj.recording.live_physics import LivePhysics
from prospect_mj.recording.recording import Recording
from prospect_mj.supervisor.supervisor import Supervisor

TRIAL = (Action.GRASP_RIGHT, Action.INSERT_RIGHT, Action.SWAP_RIGHT_TO_LEFT)
"""Of a jar with its lid to the left: the wrong end, a jam, and a hand-over."""


@pytest.fixture(scope="module")
def recorded():
    return PickPlaceEnv(physics="recorded", haptic_models=THREE)


def test_a_recorded_trial_has_the_categories_of_its_nodes(recorded):
    recording = recorded.task.recording
    expected = category_of_nodes(recording, THREE)
    holding = recording.nodes.holding
    generator = StateFeatureGenerator(categories=3)
    rng, found = np.random.default_rng(0), set()
    for seed in range(40):
        features, info = recorded.reset(seed=seed)
        (shown,) = np.flatnonzero(recording.presentations.root == recorded.task.node)
        histogram = recording.presentations.histogram[shown]
        ended = False
        while not ended:
            node = recorded.task.node
            held, category = HOLDINGS[holding[node]], int(expected[node])
            assert info["category"] == (NO_CATEGORY if held == "none" else category)
            phi = generator.generate(histogram, held, category)
            np.testing.assert_array_equal(features, phi)
            haptic = haptic_state(holding[node], category, 3)
            assert Observation.of(features).haptic == haptic
            found.add(haptic)
            features, _, *ends, info = recorded.step(int(rng.integers(6)))
            ended = any(ends)
    assert found == set(range(7))


def test_without_models_nothing_is_told():
    env = PickPlaceEnv(physics="recorded")
    features, info = env.reset(seed=0)
    assert (features.shape, info["category"]) == ((303,), NO_CATEGORY)
    features, *_, info = env.step(Action.GRASP_LEFT)
    assert (info["holding"], info["category"]) == ("left", NO_CATEGORY)
    assert features.shape == (303,)


def test_the_spaces_are_those_of_the_features(recorded):
    check_env(recorded, skip_render_check=True)
    assert recorded.observation_space.shape == (606,)
    face = PickPlaceDmEnv(seed=0, physics="recorded", haptic_models=THREE)
    spec = face.observation_spec()["features"]
    spec.validate(face.reset().observation["features"])
    assert spec.shape == (606,)


class Felt:
    """Touch of a recorded task that felt what it is told to."""

    def __init__(self, recorded):
        self.touch, self.task = Touch(THREE), recorded.task

    def after(self, result, *residuals, monkeypatch):
        felt = [(0.3 + 0.02 * i, eps) for i, eps in enumerate(residuals)]
        monkeypatch.setattr(
            self.task, "_felt", np.array(felt, np.float32).reshape(-1, 2)
        )
        outcome = ActionOutcome(Action.GRASP_LEFT, True, result, 1.0)
        self.touch.feel(self.task, outcome)
        return self.touch.category


def test_only_what_takes_the_jar_changes_the_category(recorded, monkeypatch):
    one = Felt(recorded)
    took, failed = ActionResult.SUCCESS, ActionResult.NOT_GRASPED
    assert one.after(failed, 0.013, monkeypatch=monkeypatch) == 0
    assert one.after(took, 0.013, 0.0131, monkeypatch=monkeypatch) == 2
    # A giver that still holds, an insertion, and a grasp that holds again.
    assert one.after(failed, 0.005, monkeypatch=monkeypatch) == 2
    assert one.after(took, monkeypatch=monkeypatch) == 2
    assert one.touch.told("left") == 2
    assert one.touch.told("none") == NO_CATEGORY
    assert one.after(took, 0.005, monkeypatch=monkeypatch) == 0
    assert one.after(took, 0.013, 0.0131, monkeypatch=monkeypatch) == 2
    one.touch.begin()
    assert one.touch.category == 0


def test_a_growing_recording_feels_what_it_grew(tmp_path):
    """Every third grasp of the ideal physics is felt longer, and told by that."""
    path = ((2.0, 0.0), (0.125, 0.0)), ((2.0, 0.0), (0.05, 0.0))
    wide = ((0.02, 20.0), (0.02, 20.0)), ((0.02, 20.0), (0.05, 20.0))
    by_length = TrajectoryModels((0.5, 0.5), path, wide)
    physics = LivePhysics(key().config, IdealGrower)
    folder = GrowingRecording.open(tmp_path, key())
    actions = (*TRIAL, Action.SWAP_LEFT_TO_RIGHT, Action.SWAP_RIGHT_TO_LEFT)
    found, touch = [], Touch(by_length)
    with LazyTask(folder, Supervisor(), physics) as task:
        task.reset("left", np.random.default_rng(0))
        for action in actions:
            touch.feel(task, task.execute(action))
            found.append((task.node, touch.category))
    expected = category_of_nodes(Recording.load(tmp_path), by_length)
    assert found == [(node, expected[node]) for node, _ in found]
    assert {category for _, category in found} == {0, 1}


def test_a_recording_in_which_nothing_was_felt_is_refused(monkeypatch):
    silent = made_recording(left=(ideal,), right=(ideal,))
    monkeypatch.setattr(Recording, "load", lambda _: silent)
    words = "no grasp of which it kept what was felt"
    with pytest.raises(RecordingError, match=words):
        PickPlaceEnv(physics="recorded", haptic_models=THREE)
    with pytest.raises(RecordingError, match=words):
        gymnasium.make_vec(
            "prospect_mj/PickPlace-v0", 2, physics="recorded", haptic_models=THREE
        )


@pytest.mark.parametrize("bad", [3, "models.json", {"weight": (1.0,)}])
def test_other_things_are_no_models(bad):
    with pytest.raises(InvalidValue, match=r"haptic_models is .* TrajectoryModels"):
        PickPlaceSettings(haptic_models=bad)


def test_more_categories_than_features_may_have_are_refused():
    with pytest.raises(InvalidValue, match="haptic categories is 101"):
        PickPlaceEnv(physics="recorded", haptic_models=models(*np.arange(101.0)))


@pytest.mark.gl
def test_live_grasps_are_told_as_recorded_ones_are(recorded):
    """The same presentation, live and recorded."""
    from prospect_mj.episodes.recorder import WatchedTask
    from prospect_mj.recording.grower import presentation_rng, task_settings
    from prospect_mj.recording.last_grasp import last_grasp
    from prospect_mj.task.pick_place import PickPlaceTask

    recording = recorded.task.recording
    nodes, expected = recording.nodes, category_of_nodes(recording, THREE)
    node, config = int(recording.presentations.root[0]), RecordingConfig()
    touch = Touch(THREE)
    with closing(WatchedTask(PickPlaceTask(task_settings(config)))) as task:
        task.reset("left", presentation_rng(config, "left", 0))
        for action in TRIAL:
            outcome = task.execute(action)
            touch.feel(task, outcome)
            node = int(nodes.situation[nodes.child[node, action]])
            assert touch.category == expected[node]
            felt = last_grasp(outcome)
            np.testing.assert_array_equal(felt, known_samples(nodes.felt[node]))
            assert len(felt) or action == Action.INSERT_RIGHT


@pytest.mark.gl
def test_the_environment_tells_them_in_live_physics(monkeypatch):
    from prospect_mj.recording.last_grasp import last_grasp

    env = PickPlaceEnv(haptic_models=THREE, observation="images", object_pose="truth")
    with closing(env):
        seen, info = env.reset(seed=3, options={"orientation": "left"})
        assert (seen["features"].shape, info["category"]) == ((606,), NO_CATEGORY)
        execute, felt = env.task.execute, []

        def spy(action):
            felt.append(last_grasp(outcome := execute(action)))
            return outcome

        monkeypatch.setattr(env.task, "execute", spy)
        told = []
        for action in (Action.GRASP_RIGHT, Action.SWAP_RIGHT_TO_LEFT):
            seen, *_, info = env.step(action)
            told.append(info["category"])
            hand = HOLDINGS.index(info["holding"])
            haptic = Observation.of(seen["features"]).haptic
            assert haptic == haptic_state(hand, info["category"], 3)
        assert told == list(categories(list(map(phase_samples, felt)), THREE))
        # The left hand has the lid, which feels like nothing else in a hand-over.
        assert told[1] == 2
