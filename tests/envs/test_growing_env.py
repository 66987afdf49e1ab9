"""The environment on a recording that grows with what the agent tries."""

from functools import partial

import gymnasium
import numpy as np
import pytest
from ideal_grower import IdealGrower

import prospect_mj  # noqa: F401  (registers the environment)
from prospect_mj.errors import FolderInUse, InvalidValue, RecordingError
from prospect_mj.recording.grower import Grower
from prospect_mj.recording.live_physics import LivePhysics
from prospect_mj.recording.recording import Recording

pytestmark = pytest.mark.gl
ENV_ID = "prospect_mj/PickPlace-v0"
TRIAL = (2, 1, 5, 3, 4)
"""Not allowed, then a late correction of a jar with its lid to the left."""


def make(folder, **settings):
    return gymnasium.make(
        ENV_ID, physics="recorded", recording=folder, grow=True, **settings
    )


def trial(env, seed):
    """What an agent sees of a trial."""
    seen = [env.reset(seed=seed, options={"orientation": "left"})]
    seen += [env.step(action) for action in TRIAL]
    return repr(seen)


@pytest.fixture(scope="module")
def grown(tmp_path_factory):
    """A folder in which one trial was tried, and what was seen."""
    folder = tmp_path_factory.mktemp("recording") / "new"
    env = make(folder)
    seen = trial(env, seed=1)
    env.close()
    return folder, seen


def test_only_what_was_tried_is_there(grown):
    folder, _ = grown
    recording = Recording.load(folder)
    assert len(recording.presentations.root) == 1
    assert recording.nodes.result.tolist() == [
        "",
        "success",
        "jammed",
        *["success"] * 2,
    ]
    assert recording.nodes.inserted.tolist() == [False] * 4 + [True]
    # The other grasp was never tried.
    assert recording.presentations.depth.tolist() == [0]


def test_what_was_tried_before_is_not_simulated_again(grown, monkeypatch):
    folder, seen = grown

    def no_physics(self, config):
        raise AssertionError("physics was made")

    monkeypatch.setattr(Grower, "__init__", no_physics)
    env = make(folder)
    assert trial(env, seed=1) == seen
    env.reset(seed=1, options={"orientation": "left"})
    with pytest.raises(AssertionError, match="physics was made"):
        env.step(0)
    env.close()


def test_it_grows_on_after_it_was_closed(grown):
    folder, _ = grown
    env = make(folder)
    env.reset(seed=1, options={"orientation": "left"})
    *_, info = env.step(0)
    assert info["executed"]
    env.close()
    recording = Recording.load(folder)
    assert recording.presentations.depth.tolist() == [1]


def test_two_environments_do_not_grow_one_folder(grown):
    folder, _ = grown
    first = make(folder)
    with pytest.raises(FolderInUse):
        make(folder)
    first.close()


def test_other_physics_does_not_grow_it(grown):
    folder, _ = grown
    with pytest.raises(RecordingError, match="gross motion harmonic, not cartesian"):
        make(folder, gross_motion="cartesian")


def test_live_and_grown_outcomes_are_the_same(grown):
    """Live physics, shown the same presentation, does the same bit by bit."""
    folder, _ = grown
    grower = Grower(Recording.load(folder).key.config)
    recording = Recording.load(folder)
    number = int(recording.presentations.number[0])
    tree = grower.plant("left", number)
    task = grower.task
    for action, node in zip(TRIAL[1:], range(1, 5), strict=True):
        outcome = task.execute(action)
        assert outcome.result == recording.nodes.result[node]
        assert outcome.sim_seconds == recording.nodes.sim_seconds[node]
        assert task.inserted == recording.nodes.inserted[node]
    np.testing.assert_array_equal(
        tree.shown.histogram, recording.presentations.histogram[0]
    )
    grower.close()


def test_it_begins_where_another_was_killed_at_its_birth(tmp_path):
    (tmp_path / ".recording.yaml.tmp").write_text("half of it")
    env = make(tmp_path)
    env.close()
    assert (tmp_path / "recording.yaml").exists()


def test_settings_that_can_not_be_simulated_leave_nothing(tmp_path):
    with pytest.raises(InvalidValue, match="bytes"):
        make(tmp_path / "new", grid_cells=1000)
    assert not list(tmp_path.iterdir())


def test_a_trial_may_have_more_actions_than_are_shipped(tmp_path, monkeypatch):
    physics = partial(LivePhysics, make=IdealGrower)
    monkeypatch.setattr("prospect_mj.recording.lazy_task.LivePhysics", physics)
    env = make(tmp_path, max_actions=12)
    env.reset(seed=1, options={"orientation": "left"})
    ends = [env.step(action)[3] for action in (1, *[5] * 11)]
    assert ends == [False] * 11 + [True]
    env.close()
    assert Recording.load(tmp_path).nodes.depth.max() == 12


def test_a_file_in_the_folders_place_is_told_of(tmp_path):
    (tmp_path / "file").write_text("mine")
    with pytest.raises(RecordingError, match="file is not a folder"):
        make(tmp_path / "file")
