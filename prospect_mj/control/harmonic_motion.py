"""Harmonic motion: streamlines in configuration space, then mink for the last bit."""

from dataclasses import replace
from functools import cache, partial

import mink
import numpy as np

from prospect_mj.control.arm_control import ArmControl
from prospect_mj.control.cartesian_motion import CartesianMotion
from prospect_mj.control.controller import Controller
from prospect_mj.control.grip_watch import GripWatch
from prospect_mj.control.hand_servo import HandServo, MotionSettings
from prospect_mj.control.posture_motion import PostureMotion, PostureSettings
from prospect_mj.control.result import Measured, Status, Targets
from prospect_mj.control.straight_reach import GROSS
from prospect_mj.control.transit import Transit
from prospect_mj.planning.goals import NATURAL, THOROUGH, GoalSearch, GoalSet, goals
from prospect_mj.planning.surroundings import KnownJars
from prospect_mj.robot.torso import ArmReading, Reading

TIME_BUDGET = 10.0
"""A way round things may be several times as long as the straight one [s]."""


class _AlongStreamline(Controller):
    """The part along the streamline, which a reach and a posture have in common."""

    transit: Transit
    _grip: GripWatch

    @property
    def planned_path(self) -> np.ndarray | None:
        """Joint angles (n, 7) [rad] of the streamline, until the goal is near."""
        following = self.transit.plan is not None and not self.transit.arrived
        return self.transit.plan.path if following else None

    def _travel(self, own: ArmReading) -> Targets:
        """One control period of the transit; ends the controller if that fails."""
        targets = self.transit.step(own)
        self.measured = Measured(way_left=self.transit.way_left)
        if self._grip.lost(own.touch):
            self._finish(Status.LOST, GripWatch.REASON)
        elif self.transit.failure is not None:
            self._finish(*self.transit.failure)
        return Targets(joints=targets)


class HarmonicReach(_AlongStreamline, CartesianMotion):
    """Bring a hand to a pose along a streamline, then straight within tolerance.

    Args:
        arm: which arm, its kinematics and its planner.
        target: pose of the grasp site in the world.
        posture: joint angles (7,) [rad]; the goals near to it come first.
        jars: where the jar is believed to be.
        carrying: whether an object must stay in the hand.
        settings: of the last bit; None = those of gross motion.

    Attributes:
        transit: the part along the streamline.
    """

    DEFAULTS = replace(GROSS, time_budget=TIME_BUDGET)

    def __init__(
        self,
        arm: ArmControl,
        target: mink.SE3,
        posture: np.ndarray,
        jars: KnownJars,
        carrying: bool = False,
        settings: MotionSettings | None = None,
    ) -> None:
        """Start towards `target`."""
        super().__init__(arm, target, posture, carrying, settings)
        self._posture = posture
        # Found when they are first needed, as some seldom are; then kept.
        sets = [
            GoalSet(cache(partial(self._goals, how)), how.most, how.spread)
            for how in (NATURAL, THOROUGH)
        ]
        self.transit = Transit(arm, sets, jars, carrying)

    def _goals(self, how: GoalSearch) -> np.ndarray:
        here, free_roll = self._arm.joints(), self._settings.free_roll
        return goals(self.side, self._target, here, self._posture, free_roll, how)

    def _law(self, reading: Reading) -> Targets:
        own = reading[self.side]
        if self.transit.arrived:
            return super()._law(reading)
        targets = self._travel(own)
        error = self._servo.error(self._target)
        self.measured = replace(
            self.measured, position_error=error.position, angle_error=error.angle
        )
        if self.result is None and self._within(error):
            self._finish(Status.CONVERGED)
        if self.transit.arrived:
            # The straight law goes on from here, towards the same configuration.
            self._servo = HandServo(self._arm, self.transit.goal, self._settings)
            self._place = self._arm.grasp_pose().translation()
        return targets


class HarmonicPosture(_AlongStreamline, PostureMotion):
    """Bring an arm's joints to a known posture along a streamline.

    Args:
        arm: which arm, its kinematics and its planner.
        posture: joint angles (7,) [rad].
        jars: where the jar is believed to be.
        carrying: whether an object must stay in the hand.
        settings: of the last bit.

    Attributes:
        transit: the part along the streamline.
    """

    def __init__(
        self,
        arm: ArmControl,
        posture: np.ndarray,
        jars: KnownJars,
        carrying: bool = False,
        settings: PostureSettings | None = None,
    ) -> None:
        """Start towards `posture`."""
        if settings is None:
            settings = PostureSettings(time_budget=TIME_BUDGET)
        super().__init__(arm, posture, carrying, settings)
        self.transit = Transit(arm, [GoalSet(lambda: posture[None])], jars, carrying)

    def _law(self, reading: Reading) -> Targets:
        own = reading[self.side]
        if self.transit.arrived:
            return super()._law(reading)
        return self._travel(own)
