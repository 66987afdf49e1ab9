"""Plans: actions as sequences of controllers, written as generators.

A plan yields controllers that run at the same time until all have a result, goes on
from their results, and returns how the action ended. It neither steps physics nor
sees the simulator.
"""

from collections.abc import Generator
from dataclasses import dataclass

import mink
import numpy as np

from prospect_mj.actions import poses
from prospect_mj.actions.action import ActionResult
from prospect_mj.actions.belief import Belief
from prospect_mj.actions.workspace import Workspace
from prospect_mj.control import gross_motion
from prospect_mj.control.arm_control import ArmControl
from prospect_mj.control.controller import Controller
from prospect_mj.control.fine_motion import PASSING, FineMotion
from prospect_mj.control.hand_motion import HandMotion
from prospect_mj.control.result import ControlResult, Status
from prospect_mj.errors import InvalidValue
from prospect_mj.planning.surroundings import JarShape, KnownJars
from prospect_mj.robot import posture
from prospect_mj.robot.names import Side

Plan = Generator[tuple[Controller, ...], None, ActionResult]
Step = Generator[tuple[Controller, ...], None, ControlResult]
Steps = Generator[tuple[Controller, ...], None, None]


@dataclass(frozen=True)
class Robot:
    """What plans are written over."""

    arms: dict[Side, ArmControl]
    belief: Belief
    workspace: Workspace

    def held_jar(self, side: Side) -> mink.SE3:
        """Pose in the world of the jar that a hand holds."""
        return self.arms[side].grasp_pose() @ self.belief.held[side]

    def reach(
        self,
        side: Side,
        target: mink.SE3,
        reference: np.ndarray,
        carrying: bool = False,
    ) -> Controller:
        """Gross motion of a hand to a pose; `reference` (7,) [rad] as in `reach`."""
        arm, jars = self.arms[side], self._jars()
        return gross_motion.reach(arm, target, reference, jars, carrying)

    def assume(
        self, side: Side, reference: np.ndarray, carrying: bool = False
    ) -> Controller:
        """Gross motion of an arm to a posture (7,) [rad]."""
        return gross_motion.assume(self.arms[side], reference, self._jars(), carrying)

    def _jars(self) -> KnownJars:
        """Where planning must expect the jar."""
        work, belief = self.workspace, self.belief
        placed = belief.inserted
        if belief.seen is not None and not belief.held:
            placed = poses.lying(belief.seen.position, belief.seen.axis)
        shape = JarShape(work.jar_radius, work.jar_length)
        return KnownJars(shape, dict(belief.held), placed)


def run(controller: Controller) -> Step:
    """Run one controller alone."""
    yield (controller,)
    return ended(controller)


def ended(controller: Controller) -> ControlResult:
    """The result of a controller that has run, which it then has."""
    if controller.result is None:
        name = type(controller).__name__
        raise InvalidValue("controller", name, "one that has run to its end")
    return controller.result


def conclude(robot: Robot, side: Side, result: ControlResult) -> Plan:
    """End an action by the result of the motion that carries the jar away."""
    if result.converged:
        return ActionResult.SUCCESS
    if result.status is Status.LOST:
        yield from drop(robot, side)
        return ActionResult.LOST
    return ActionResult.NOT_REACHED


def withdraw(robot: Robot, side: Side, target: mink.SE3) -> Steps:
    """Open a hand, back it out to `target` and bring its arm home."""
    arm = robot.arms[side]
    yield (HandMotion(side),)
    yield (FineMotion(arm, target, arm_posture(arm), settings=PASSING),)
    yield (robot.assume(side, posture.home(side)),)


def arm_posture(arm: ArmControl) -> np.ndarray:
    """The reference posture (7,) [rad] of an arm at work in front of the chest."""
    return posture.home(arm.side)


def present(robot: Robot, side: Side) -> Step:
    """Bring a held jar to where it is kept between actions, lying along y."""
    arm = robot.arms[side]
    held, place = robot.belief.held[side], robot.workspace.presentation
    target = poses.jar_over(side, arm.grasp_pose(), held, place, outward(side))
    reference = posture.presenting(side)
    reached = yield from run(robot.reach(side, target, reference, carrying=True))
    if reached.status is Status.LOST:
        return reached
    # However far that came: it is the posture that the next action starts from.
    return (yield from run(robot.assume(side, reference, carrying=True)))


def outward(side: Side) -> np.ndarray:
    """Unit vector (3,) from the midline to a side."""
    return np.array([0.0, 1.0 if side == "left" else -1.0, 0.0])


def drop(robot: Robot, side: Side) -> Steps:
    """Give up a jar that has left the hand: forget it and bring the arm home."""
    robot.belief.held.pop(side, None)
    robot.belief.seen = None
    yield (HandMotion(side),)
    yield (robot.assume(side, posture.home(side)),)
