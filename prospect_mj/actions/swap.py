"""Swap Left to Right, Swap Right to Left: hand the jar over in the air."""

from prospect_mj.actions import plan, poses
from prospect_mj.actions.action import ActionResult
from prospect_mj.actions.plan import Plan, Robot, Step
from prospect_mj.actions.take_hold import take_hold
from prospect_mj.control.fine_motion import PASSING, FineMotion
from prospect_mj.control.hand_motion import HandMotion
from prospect_mj.robot import names, posture
from prospect_mj.robot.names import Side


def swap(robot: Robot, giver: Side) -> Plan:
    """Grasp the free end with the other hand, then let go with the first."""
    taker = names.other(giver)
    taken = yield from take_hold(robot, taker, lambda: robot.held_jar(giver))
    if taken is not ActionResult.SUCCESS:
        return taken
    carried = yield from _let_go(robot, giver, taker)
    return (yield from plan.conclude(robot, taker, carried))


def _let_go(robot: Robot, giver: Side, taker: Side) -> Step:
    """Open the giver's hand and back it out; both arms go to where they belong."""
    giving = robot.arms[giver]
    yield (HandMotion(giver),)
    del robot.belief.held[giver]
    back = poses.backed_off(giving.grasp_pose(), robot.workspace.stand_off)
    yield (FineMotion(giving, back, plan.arm_posture(giving), settings=PASSING),)
    carry = robot.assume(taker, posture.presenting(taker), carrying=True)
    yield (carry, robot.assume(giver, posture.home(giver)))
    return plan.ended(carry)
