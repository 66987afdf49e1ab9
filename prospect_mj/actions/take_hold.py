"""Taking hold of a jar's end: the part that grasping and swapping have in common."""

from collections.abc import Callable

import mink

from prospect_mj.actions import plan, poses
from prospect_mj.actions.action import ActionResult
from prospect_mj.actions.plan import Plan, Robot, Step
from prospect_mj.control.fine_motion import FineMotion
from prospect_mj.control.grasp import GraspController
from prospect_mj.control.grasp_settings import GraspResult
from prospect_mj.control.hand_motion import HandMotion
from prospect_mj.control.result import Status
from prospect_mj.robot.names import Side

WhereIsJar = Callable[[], mink.SE3]
"""Tells the pose of the jar in the world as it is known at that moment."""


def take_hold(robot: Robot, side: Side, jar: WhereIsJar) -> Plan:
    """Close an open hand round the jar's end on its side; withdraw it if that fails.

    Args:
        robot: what plans are written over.
        side: the hand.
        jar: where the jar is.

    Returns:
        SUCCESS if the hand holds the jar, which the robot then believes; NOT_GRASPED
        if the fingers found no stable grasp, NOT_REACHED if they did not get there.
    """
    arm = robot.arms[side]
    grasped = yield from _close_on(robot, side, jar)
    if grasped.converged:
        robot.belief.held[side] = arm.grasp_pose().inverse() @ jar()
        return ActionResult.SUCCESS
    if grasped.status is Status.UNREACHABLE:
        return ActionResult.NOT_REACHED
    retreat = poses.backed_off(arm.grasp_pose(), robot.workspace.stand_off)
    yield from plan.withdraw(robot, side, retreat)
    tried = isinstance(grasped, GraspResult)
    return ActionResult.NOT_GRASPED if tried else ActionResult.NOT_REACHED


def _close_on(robot: Robot, side: Side, jar: WhereIsJar) -> Step:
    arm, posture = robot.arms[side], plan.arm_posture(robot.arms[side])
    before = poses.backed_off(_grip_pose(robot, side, jar()), robot.workspace.stand_off)
    reach = robot.reach(side, before, posture)
    yield (reach, HandMotion(side))
    reached = plan.ended(reach)
    if not reached.converged:
        return reached
    approach = FineMotion(arm, _grip_pose(robot, side, jar()), posture)
    approached = yield from plan.run(approach)
    if not approached.converged:
        return approached
    return (yield from plan.run(GraspController(arm, posture)))


def _grip_pose(robot: Robot, side: Side, jar: mink.SE3) -> mink.SE3:
    """Pose of a hand round its end of a jar, turned as little as possible."""
    axis = jar.rotation().as_matrix()[:, 2]
    reach = robot.workspace.reach
    point, palm = poses.end_of_jar(side, jar.translation(), axis, reach)
    rotation = poses.turned_to(robot.arms[side].grasp_pose().rotation(), palm)
    return poses.pose(rotation, point)
