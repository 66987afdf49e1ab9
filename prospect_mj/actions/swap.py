"""Swap Left to Right, Swap Right to Left: hand the jar over in the air."""

from prospect_mj.actions import plan, poses
from prospect_mj.actions.action import ActionResult
from prospect_mj.actions.grasp import close_on
from prospect_mj.actions.held import jar_in_hand
from prospect_mj.actions.plan import Plan, Robot
from prospect_mj.control.fine_motion import FineMotion
from prospect_mj.control.gross_motion import GrossMotion
from prospect_mj.control.hand_motion import HandMotion
from prospect_mj.control.posture_motion import PostureMotion
from prospect_mj.robot import names, posture
from prospect_mj.robot.names import Side


def swap(robot: Robot, giver: Side) -> Plan:
    """Grasp the free end with the other hand, then let go with the first."""
    taker = names.other(giver)
    arm, work = robot.arms[taker], robot.workspace
    jar = robot.held_jar(giver)
    result = yield from close_on(robot, taker, jar)
    if not result.converged:
        retreat = poses.backed_off(arm.grasp_pose(), work.stand_off)
        yield from plan.withdraw(robot, taker, retreat)
        return ActionResult.NOT_GRASPED
    jar = robot.held_jar(giver)
    robot.belief.held[taker] = jar_in_hand(arm, jar, robot.belief, taker)
    return (yield from _let_go(robot, giver, taker))


def _let_go(robot: Robot, giver: Side, taker: Side) -> Plan:
    giving, taking = robot.arms[giver], robot.arms[taker]
    yield (HandMotion(giver),)
    del robot.belief.held[giver]
    back = poses.backed_off(giving.grasp_pose(), robot.workspace.stand_off)
    yield (FineMotion(giving, back, plan.arm_posture(giving)),)
    target = poses.jar_over(
        taker,
        taking.grasp_pose(),
        robot.belief.held[taker],
        robot.workspace.presentation,
        plan.outward(taker),
    )
    carry = GrossMotion(taking, target, posture.home(taker), carrying=True)
    yield (carry, PostureMotion(giving, posture.home(giver)))
    assert carry.result is not None
    if carry.result.converged:
        return ActionResult.SUCCESS
    ending = plan.failure(carry.result)
    if ending is ActionResult.LOST:
        yield from plan.drop(robot, taker)
    return ending
