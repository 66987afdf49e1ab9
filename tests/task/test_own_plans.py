"""Plans that are none of the six actions, followed by the task."""

import numpy as np
import pytest

from prospect_mj.actions import plan
from prospect_mj.actions.action import Action, ActionResult
from prospect_mj.actions.grasp import grasp
from prospect_mj.control.hand_motion import HandMotion
from prospect_mj.control.result import Status
from prospect_mj.errors import InvalidValue
from prospect_mj.robot import posture
from prospect_mj.robot.names import SIDES
from prospect_mj.task.pick_place import PickPlaceTask, TaskSettings

pytestmark = pytest.mark.gl


def both_bow(robot):
    """Both hands open, and both wrists turn at the same time."""
    yield tuple(HandMotion(side) for side in SIDES)
    bent = {side: posture.home(side).copy() for side in SIDES}
    for joints in bent.values():
        joints[5] += 0.4
    motions = tuple(robot.assume(side, bent[side]) for side in SIDES)
    yield motions
    reached = all(plan.ended(motion).converged for motion in motions)
    return ActionResult.SUCCESS if reached else ActionResult.NOT_REACHED


def presented():
    task = PickPlaceTask(TaskSettings())
    task.reset("left", np.random.default_rng(5))
    return task


def test_a_plan_runs_as_the_action_does_that_is_made_of_it():
    with presented() as task, presented() as other:
        done = task.follow(grasp(task.runner.robot, "left"))
        action = other.execute(Action.GRASP_LEFT)
        assert (done.result, done.sim_seconds, done.runs) == (
            action.result,
            action.sim_seconds,
            action.runs,
        )
        np.testing.assert_array_equal(task.simulation.save(), other.simulation.save())
        assert task.predicates == other.predicates
        assert task.execute(Action.INSERT_LEFT).result is ActionResult.SUCCESS


def test_a_plan_of_ones_own_moves_both_arms_at_once():
    with presented() as task:
        done = task.follow(both_bow(task.runner.robot))
        assert done.result is ActionResult.SUCCESS
        assert [run.result.status for run in done.runs] == [Status.CONVERGED] * 4
        one_by_one = sum(run.result.seconds for run in done.runs)
        assert done.sim_seconds < 0.7 * one_by_one
        assert task.predicates.jar == "seen"


def test_a_plan_that_leaves_what_no_trial_knows_is_refused():
    def left_open(robot):
        yield (HandMotion("left"),)
        # As if it held what it does not.
        robot.belief.held["left"] = robot.arms["left"].grasp_pose()
        robot.belief.held["right"] = robot.arms["right"].grasp_pose()
        return ActionResult.SUCCESS

    with presented() as task, pytest.raises(InvalidValue, match="predicates"):
        task.follow(left_open(task.runner.robot))
