"""Grasp Left, Grasp Right: pick the jar off its cradle by the end on that side."""

from prospect_mj.actions import plan, poses
from prospect_mj.actions.action import ActionResult
from prospect_mj.actions.plan import Plan, Robot, Step
from prospect_mj.actions.take_hold import take_hold
from prospect_mj.control.fine_motion import PASSING, FineMotion
from prospect_mj.control.weighing import Weighing
from prospect_mj.robot.names import Side


def grasp(robot: Robot, side: Side) -> Plan:
    """Reach for the jar where it was seen, grasp, lift, weigh and present it."""
    seen = robot.belief.seen
    if seen is None:
        return ActionResult.NOT_SEEN
    lying = poses.lying(seen.position, seen.axis)
    taken = yield from take_hold(robot, side, lambda: lying)
    if taken is not ActionResult.SUCCESS:
        return taken
    lifted = yield from _lift(robot, side)
    if not lifted.converged:
        # Whatever went wrong, the jar does not hang safely in this hand.
        yield from plan.drop(robot, side)
        return ActionResult.LOST
    robot.belief.seen = None
    presented = yield from plan.present(robot, side)
    return (yield from plan.conclude(robot, side, presented))


def _lift(robot: Robot, side: Side) -> Step:
    """Straight up out of the cradle, and feel whether the jar came along."""
    arm, work = robot.arms[side], robot.workspace
    above = poses.raised(arm.grasp_pose(), work.lift)
    posture = plan.arm_posture(arm)
    motion = FineMotion(arm, above, posture, carrying=True, settings=PASSING)
    lifted = yield from plan.run(motion)
    if not lifted.converged:
        return lifted
    return (yield from plan.run(Weighing(arm, work.jar_weight)))
