"""One trial with everything in it: presentation, eyes, supervisor, actions."""

import mujoco
import numpy as np
import pytest

from prospect_mj.actions.action import Action, ActionResult
from prospect_mj.errors import InvalidChoice, InvalidValue, UnforeseenEvent
from prospect_mj.task.pick_place import PickPlaceTask, TaskSettings
from prospect_mj.task.presentation import ORIENTATIONS

pytestmark = pytest.mark.gl
GRASP = {"left": Action.GRASP_LEFT, "right": Action.GRASP_RIGHT}
INSERT = {"left": Action.INSERT_LEFT, "right": Action.INSERT_RIGHT}


@pytest.fixture(scope="module")
def task():
    with PickPlaceTask() as task:
        yield task


def begin(task, orientation="left", seed=0):
    return task.reset(orientation, np.random.default_rng(seed))


@pytest.mark.parametrize("orientation", ORIENTATIONS)
def test_two_actions_solve_a_trial(task, orientation):
    """By sight, touch and joints alone: the hand on the lid's side, then insert."""
    look = begin(task, orientation, seed=5)
    assert look.status == "found"
    assert not task.inserted
    assert task.execute(GRASP[orientation]).result is ActionResult.SUCCESS
    assert task.holder == orientation
    assert not task.inserted
    assert task.execute(INSERT[orientation]).result is ActionResult.SUCCESS
    assert task.holder is None
    assert task.inserted


NOT_ALLOWED = {
    None: [2, 3, 4, 5],
    "left": [0, 1, 3, 5],
}


@pytest.mark.parametrize("holder", NOT_ALLOWED)
def test_an_action_that_may_not_run_changes_nothing(task, holder):
    """Not one bit of the physics, no time, no belief."""
    begin(task)
    if holder is not None:
        task.execute(GRASP[holder])
    assert task.holder == holder
    before = task.simulation.save()
    model = task.simulation.model.light_diffuse.copy()
    belief = repr(task.runner.belief)
    for action in NOT_ALLOWED[holder]:
        outcome = task.execute(Action(action))
        assert not outcome.executed
        assert outcome.result is ActionResult.NOT_ALLOWED
        assert outcome.sim_seconds == 0.0
        assert outcome.runs == ()
    assert np.array_equal(task.simulation.save(), before)
    assert np.array_equal(task.simulation.model.light_diffuse, model)
    assert repr(task.runner.belief) == belief


def test_the_controllers_get_what_the_eyes_saw_and_not_the_truth(task):
    look = begin(task, seed=3)
    seen = task.runner.belief.seen
    assert np.array_equal(seen.position, look.position)
    assert np.array_equal(seen.axis, look.axis)
    error = np.linalg.norm(seen.position - task.simulation.jar_position)
    assert 0 < error < 0.006


def test_truth_as_an_ablation_is_exact_and_must_be_asked_for():
    assert TaskSettings().object_pose == "vision"
    with PickPlaceTask(TaskSettings(object_pose="truth")) as task:
        for orientation in ORIENTATIONS:
            begin(task, orientation)
            seen = task.runner.belief.seen
            assert np.array_equal(seen.position, task.simulation.jar_position)
            assert seen.axis[1] > 0
            assert abs(seen.axis @ task.simulation.jar_axis) == pytest.approx(1.0)
    with pytest.raises(InvalidChoice, match="valid: vision, truth"):
        TaskSettings(object_pose="oracle")


def test_a_trial_without_a_jar_to_see_moves_nothing(task, monkeypatch):
    """The jar is taken away before the look: a result, and grasps that don't run."""
    reset = task.simulation.reset

    def take_away(*arguments):
        reset(*arguments)
        task.simulation.data.qpos[-7:-4] = [0.62, 0.0, -0.6]
        mujoco.mj_kinematics(task.simulation.model, task.simulation.data)

    monkeypatch.setattr(task.simulation, "reset", take_away)
    look = begin(task)
    assert look.status == "not_found"
    assert look.reason
    assert not look.histogram.any()
    before = task.simulation.save()
    for action in GRASP.values():
        outcome = task.execute(action)
        assert not outcome.executed
        assert outcome.result is ActionResult.NOT_SEEN
    assert np.array_equal(task.simulation.save(), before)


def test_what_the_model_does_not_foresee_is_raised(task, monkeypatch):
    """Both hands on the jar after a grasp: a surprise, and no state to go on from."""
    begin(task, seed=5)
    execute = task.runner.execute

    def surprising(action):
        outcome = execute(action)
        task.runner.belief.held["right"] = task.runner.belief.held["left"]
        return outcome

    monkeypatch.setattr(task.runner, "execute", surprising)
    with pytest.raises(UnforeseenEvent, match="success: left holds in front, right"):
        task.execute(Action.GRASP_LEFT)


def test_modes_and_schedules_that_cannot_be_are_refused():
    with pytest.raises(InvalidChoice, match="valid: none, safe, productive"):
        TaskSettings(supervisor="strict")
    with pytest.raises(InvalidValue, match="expected 0 or more"):
        TaskSettings(shaping=("insert-left:soon",))


def test_presentations_differ_and_repeat_by_seed(task):
    places = []
    for seed in (1, 2, 1):
        begin(task, seed=seed)
        places.append(task.simulation.save())
    assert np.array_equal(places[0], places[2])
    assert not np.array_equal(places[0], places[1])


@pytest.mark.parametrize("lid", ORIENTATIONS)
def test_the_true_lid_is_on_the_side_that_was_asked_for(task, lid):
    begin(task, lid, seed=4)
    assert task.presentation.orientation == lid
    assert (task.simulation.jar_axis[1] > 0) == (lid == "left")
