"""Trials that grow what they lack, on ideal outcomes."""

import numpy as np
import pytest
from ideal_grower import IdealGrower, content, grown_tree, key

from prospect_mj.actions.action import Action, ActionResult
from prospect_mj.errors import FolderInUse, RecordingError, SimulationDiverged
from prospect_mj.recording.growing import GrowingRecording
from prospect_mj.recording.lazy_task import LazyTask
from prospect_mj.recording.live_physics import LivePhysics
from prospect_mj.recording.recording import Recording
from prospect_mj.recording.task import RecordedTask
from prospect_mj.supervisor.supervisor import Supervisor

KEY = key()
TRIAL = (
    Action.SWAP_LEFT_TO_RIGHT,
    Action.GRASP_RIGHT,
    Action.GRASP_LEFT,
    Action.INSERT_RIGHT,
    Action.SWAP_RIGHT_TO_LEFT,
    Action.INSERT_LEFT,
)
"""Two that may not run, and a late correction of a jar with its lid to the left."""


class Diverging(IdealGrower):
    """Fails once, and everything after that: MuJoCo's warnings stay."""

    n_failures = 1
    is_broken = False

    def extend(self, tree, edge):
        if self.is_broken or Diverging.n_failures:
            self.is_broken = True
            Diverging.n_failures = 0
            raise SimulationDiverged("MuJoCo warned of mjWARN_BADQACC")
        super().extend(tree, edge)


def task_in(path, make=IdealGrower):
    recording = GrowingRecording.open(path, KEY)
    return LazyTask(recording, Supervisor(), LivePhysics(KEY.config, make))


def test_it_steps_what_it_grows_as_a_recording_would(tmp_path, monkeypatch):
    with task_in(tmp_path) as task:
        task.reset("left", np.random.default_rng(0))
        grown = [(task.execute(a), task.holder, task.inserted) for a in TRIAL]
    monkeypatch.setattr(Recording, "complete", lambda recording, depth: np.array([0]))
    recorded = RecordedTask(Recording.load(tmp_path), Supervisor(), 0)
    recorded.begin(0)
    for action, (outcome, holder, inserted) in zip(TRIAL, grown, strict=True):
        assert recorded.execute(action) == outcome
        assert (recorded.holder, recorded.inserted) == (holder, inserted)
    executed = [outcome.executed for outcome, *_ in grown]
    assert executed == [False, True, False, True, True, True]
    assert grown[-1][2]


def test_a_trial_may_be_longer_than_a_recording_is_deep(tmp_path):
    with task_in(tmp_path) as task:
        task.reset("left", np.random.default_rng(0))
        task.execute(Action.GRASP_RIGHT)
        for _ in range(14):
            assert task.execute(Action.INSERT_RIGHT).result is ActionResult.JAMMED
    assert Recording.load(tmp_path).nodes.depth.max() == 15


@pytest.mark.parametrize(("number", "expected"), [(3, 50), (79, 80)])
def test_trials_draw_from_all_that_is_there(tmp_path, number, expected):
    with GrowingRecording.open(tmp_path, KEY) as recording:
        recording.keep(grown_tree(1, "right", number))
    with task_in(tmp_path) as task:
        assert task.presenter.presentations == expected
        rng = np.random.default_rng(0)
        for _ in range(20 * expected):
            task.reset("left", rng)
    assert len(Recording.load(tmp_path).presentations.root) == expected + 1


def test_after_a_divergence_the_physics_is_made_anew(tmp_path, monkeypatch):
    monkeypatch.setattr(Diverging, "n_failures", 1)
    with task_in(tmp_path, Diverging) as task:
        task.reset("left", np.random.default_rng(0))
        with pytest.raises(SimulationDiverged, match=r"node 0, grasp-left: MuJoCo"):
            task.execute(Action.GRASP_LEFT)
        assert task.node == 0
        assert task.execute(Action.GRASP_LEFT).executed


def test_closed_it_steps_no_more_and_overwrites_nothing(tmp_path):
    task = task_in(tmp_path)
    task.reset("left", np.random.default_rng(0))
    task.close()
    task.close()
    before = content(tmp_path)
    for use in (
        lambda: task.execute(Action.GRASP_LEFT),
        lambda: task.reset("left", np.random.default_rng(0)),
    ):
        with pytest.raises(FolderInUse, match="was closed"):
            use()
    assert content(tmp_path) == before


def test_before_the_first_trial_there_is_nothing_to_step(tmp_path):
    with task_in(tmp_path) as task, pytest.raises(RecordingError, match="call reset"):
        task.execute(Action.GRASP_LEFT)
