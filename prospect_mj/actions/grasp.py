"""Grasp Left, Grasp Right: pick the jar off its cradle by the end on that side."""

import mink
import numpy as np

from prospect_mj.actions import plan, poses
from prospect_mj.actions.action import ActionResult
from prospect_mj.actions.belief import SeenJar
from prospect_mj.actions.held import jar_in_hand
from prospect_mj.actions.plan import Plan, Robot
from prospect_mj.control.fine_motion import FineMotion
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
    result = yield from close_on(robot, side, lying)
    if not result.converged:
        retreat = poses.backed_off(arm.grasp_pose(), work.stand_off)
        yield from plan.withdraw(robot, side, retreat)
        return ActionResult.NOT_GRASPED
    robot.belief.held[side] = jar_in_hand(arm, lying, robot.belief, side)
    return (yield from _lift(robot, side, seen))


def _lift(robot: Robot, side: Side, seen: SeenJar) -> Plan:
    arm, work = robot.arms[side], robot.workspace
    above = poses.raised(arm.grasp_pose(), work.lift)
    posture = plan.arm_posture(arm)
    lifted = yield from plan.run(FineMotion(arm, above, posture, carrying=True))
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


def close_on(robot: Robot, side: Side, jar: mink.SE3) -> plan.Step:
    """Bring an open hand round the jar's end on its side, and close it.

    Args:
        robot: what plans are written over.
        side: the hand.
        jar: pose of the jar in the world.
    """
    arm, work = robot.arms[side], robot.workspace
    axis = jar.rotation().as_matrix()[:, 2]
    point, palm = poses.end_of_jar(side, jar.translation(), axis, work.reach)
    posture = plan.arm_posture(arm)
    rotation = poses.turned_to(arm.grasp_pose().rotation(), palm)
    before = poses.pose(rotation, point - work.stand_off * palm)
    reach = GrossMotion(arm, before, posture)
    yield (reach, HandMotion(side))
    assert reach.result is not None
    if not reach.result.converged:
        return reach.result
    rotation = poses.turned_to(arm.grasp_pose().rotation(), palm)
    approach = FineMotion(arm, poses.pose(rotation, point), posture)
    approached = yield from plan.run(approach)
    if not approached.converged:
        return approached
    return (yield from plan.run(GraspController(arm, posture)))


def jar_rotation(axis: np.ndarray) -> mink.SO3:
    """Some rotation whose z axis is the jar's `axis` (3,)."""
    return poses.turned_to(mink.SO3.identity(), axis)
