"""Swap Left to Right, Swap Right to Left: hand the jar over in the air."""

from prospect_mj.actions import plan, poses
from prospect_mj.actions.action import ActionResult
from prospect_mj.actions.grasp import close_on
from prospect_mj.actions.plan import Plan, Robot
from prospect_mj.control.fine_motion import PASSING, FineMotion
from prospect_mj.control.hand_motion import HandMotion
from prospect_mj.control.posture_motion import PostureMotion
from prospect_mj.robot import names, posture
from prospect_mj.robot.names import Side


def swap(robot: Robot, giver: Side) -> Plan:
    """Grasp the free end with the other hand, then let go with the first."""
    taker = names.other(giver)
    arm, work = robot.arms[taker], robot.workspace
    result = yield from close_on(robot, taker, lambda: robot.held_jar(giver))
    if not result.converged:
        retreat = poses.backed_off(arm.grasp_pose(), work.stand_off)
        yield from plan.withdraw(robot, taker, retreat)
        return ActionResult.NOT_GRASPED
    jar = robot.held_jar(giver)
    robot.belief.held[taker] = arm.grasp_pose().inverse() @ jar
    return (yield from _let_go(robot, giver, taker))


def _let_go(robot: Robot, giver: Side, taker: Side) -> Plan:
    giving = robot.arms[giver]
    yield (HandMotion(giver),)
    del robot.belief.held[giver]
    back = poses.backed_off(giving.grasp_pose(), robot.workspace.stand_off)
    yield (FineMotion(giving, back, plan.arm_posture(giving), settings=PASSING),)
    carry = PostureMotion(robot.arms[taker], posture.presenting(taker), carrying=True)
    yield (carry, PostureMotion(giving, posture.home(giver)))
    assert carry.result is not None
    if carry.result.converged:
        return ActionResult.SUCCESS
    ending = plan.failure(carry.result)
    if ending is ActionResult.LOST:
        yield from plan.drop(robot, taker)
    return ending
