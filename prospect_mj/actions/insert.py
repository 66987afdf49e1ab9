"""Insert Left, Insert Right: lower the jar into the receptacle, free end first."""

import mink
import numpy as np

from prospect_mj.actions import plan, poses
from prospect_mj.actions.action import ActionResult
from prospect_mj.actions.plan import Plan, Robot, Step
from prospect_mj.control.fine_motion import PASSING, FineMotion
from prospect_mj.control.hand_motion import HandMotion
from prospect_mj.control.insertion import InsertionController
from prospect_mj.control.insertion_settings import InsertionResult
from prospect_mj.control.result import ControlResult, Status
from prospect_mj.robot import names, posture
from prospect_mj.robot.names import Side

_UP = np.array([0.0, 0.0, 1.0])
_VIA_OFFSET = np.array([0.03, 0.08, 0.0])
"""To the holding hand's side of the receptacle [m]: room to turn the jar upright."""

_MOST_CREEP = 0.012
"""A larger discrepancy is not creep but something else that was hit [m]."""


def insert(robot: Robot, side: Side) -> Plan:
    """Turn the jar upright over the receptacle, lower it by feel, let go if it fits."""
    aligned = yield from _align(robot, side)
    if not aligned.converged:
        return (yield from _abandon(robot, side, aligned))
    arm, work = robot.arms[side], robot.workspace
    bottom = robot.held_jar(side).translation()[2] - work.jar_length / 2
    free = bottom - work.well[2]
    lowering = InsertionController(
        arm,
        arm.grasp_pose(),
        free,
        free + work.well_depth,
        posture.over_well(side),
    )
    result = yield from plan.run(lowering)
    if result.converged:
        yield from _release(robot, side)
        return ActionResult.SUCCESS
    if isinstance(result, InsertionResult) and result.jammed:
        _learn_height(robot, side, bottom - result.depth)
    return (yield from _abandon(robot, side, result))


def _learn_height(robot: Robot, side: Side, bottom: float) -> None:
    """Take the rim as a ruler: a jammed jar's lower end is where the lid wedges.

    It is the only measure of how far the jar has crept along its axis in the hand.
    """
    work = robot.workspace
    lower = work.well[2] + work.wedge - bottom
    if abs(lower) < _MOST_CREEP:
        up = names.sign(side) * lower
        shift = mink.SE3.from_translation(np.array([0.0, 0.0, up]))
        robot.belief.held[side] = robot.belief.held[side] @ shift


def _align(robot: Robot, side: Side) -> Step:
    """Upright beside the receptacle first, then exactly above its centre."""
    arm, work = robot.arms[side], robot.workspace
    held, reference = robot.belief.held[side], posture.over_well(side)
    offset = _VIA_OFFSET * [1, names.sign(side), 1]
    beside = work.over_well(work.via_height) + offset
    target = poses.jar_over(side, arm.grasp_pose(), held, beside, _UP)
    reached = yield from plan.run(robot.reach(side, target, reference, carrying=True))
    if not reached.converged:
        return reached
    above = work.over_well(work.rim_clearance)
    target = poses.jar_over(side, arm.grasp_pose(), held, above, _UP)
    return (yield from plan.run(FineMotion(arm, target, reference, carrying=True)))


def _release(robot: Robot, side: Side) -> plan.Steps:
    arm = robot.arms[side]
    standing = robot.held_jar(side)
    yield (HandMotion(side),)
    del robot.belief.held[side]
    robot.belief.inserted = standing
    above = poses.raised(arm.grasp_pose(), robot.workspace.stand_off)
    yield (FineMotion(arm, above, posture.over_well(side), settings=PASSING),)
    yield (robot.assume(side, posture.home(side)),)


def _abandon(robot: Robot, side: Side, result: ControlResult) -> Plan:
    """Back to where a held jar is kept, if it is still held."""
    if result.status is not Status.LOST:
        jammed = isinstance(result, InsertionResult) and result.jammed
        result = yield from plan.present(robot, side)
        if result.converged:
            return ActionResult.JAMMED if jammed else ActionResult.NOT_REACHED
    return (yield from plan.conclude(robot, side, result))
