"""Grasp Left, Grasp Right: pick the jar off its cradle by the end on that side."""

from collections.abc import Callable

import mink
import numpy as np

from prospect_mj.actions import plan, poses
from prospect_mj.actions.action import ActionResult
from prospect_mj.actions.belief import SeenJar
from prospect_mj.actions.plan import Plan, Robot
from prospect_mj.control.fine_motion import PASSING, FineMotion
from prospect_mj.control.grasp import GraspController
from prospect_mj.control.gross_motion import GrossMotion
from prospect_mj.control.hand_motion import HandMotion
from prospect_mj.control.result import ControlResult
from prospect_mj.control.weighing import Weighing
from prospect_mj.robot.names import Side


def grasp(robot: Robot, side: Side) -> Plan:
    """Reach for the jar where it was seen, grasp, lift, weigh and present it."""
    seen = robot.belief.seen
    if seen is None:
        return ActionResult.NOT_SEEN
    arm, work = robot.arms[side], robot.workspace
    lying = poses.pose(jar_rotation(seen.axis), seen.position)
    result = yield from close_on(robot, side, lambda: lying)
    if not result.converged:
        retreat = poses.backed_off(arm.grasp_pose(), work.stand_off)
        yield from plan.withdraw(robot, side, retreat)
        return ActionResult.NOT_GRASPED
    robot.belief.held[side] = arm.grasp_pose().inverse() @ lying
    return (yield from _lift(robot, side, seen))


def _lift(robot: Robot, side: Side, seen: SeenJar) -> Plan:
    arm, work = robot.arms[side], robot.workspace
    above = poses.raised(arm.grasp_pose(), work.lift)
    posture = plan.arm_posture(arm)
    lift = FineMotion(arm, above, posture, carrying=True, settings=PASSING)
    lifted = yield from plan.run(lift)
    if lifted.converged:
        lifted = yield from plan.run(Weighing(arm, work.jar_weight))
    if not lifted.converged:
        yield from plan.drop(robot, side)
        return ActionResult.LOST
    robot.belief.seen = None
    presented = yield from plan.present(robot, side)
    if presented.converged:
        return ActionResult.SUCCESS
    return (yield from _give_up(robot, side, presented))


def _give_up(robot: Robot, side: Side, result: ControlResult) -> Plan:
    ending = plan.failure(result)
    if ending is ActionResult.LOST:
        yield from plan.drop(robot, side)
    return ending


def close_on(robot: Robot, side: Side, jar: Callable[[], mink.SE3]) -> plan.Step:
    """Bring an open hand round the jar's end on its side, and close it.

    Args:
        robot: what plans are written over.
        side: the hand.
        jar: tells the pose of the jar in the world as it is known at that moment.
    """
    arm, work = robot.arms[side], robot.workspace
    posture = plan.arm_posture(arm)
    before = poses.backed_off(grip_pose(robot, side, jar()), work.stand_off)
    reach = GrossMotion(arm, before, posture)
    yield (reach, HandMotion(side))
    assert reach.result is not None
    if not reach.result.converged:
        return reach.result
    approach = FineMotion(arm, grip_pose(robot, side, jar()), posture)
    approached = yield from plan.run(approach)
    if not approached.converged:
        return approached
    return (yield from plan.run(GraspController(arm, posture)))


def grip_pose(robot: Robot, side: Side, jar: mink.SE3) -> mink.SE3:
    """Pose of a hand round its end of a jar, turned as little as possible."""
    axis = jar.rotation().as_matrix()[:, 2]
    reach = robot.workspace.reach
    point, palm = poses.end_of_jar(side, jar.translation(), axis, reach)
    rotation = poses.turned_to(robot.arms[side].grasp_pose().rotation(), palm)
    return poses.pose(rotation, point)


def jar_rotation(axis: np.ndarray) -> mink.SO3:
    """Some rotation whose z axis is the jar's `axis` (3,)."""
    return poses.turned_to(mink.SO3.identity(), axis)
