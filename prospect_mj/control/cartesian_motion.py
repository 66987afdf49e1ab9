"""Closed-loop Cartesian motion of one hand: what gross and fine motion share."""

from typing import ClassVar

import mink
import numpy as np

from prospect_mj.control.arm_control import ArmControl
from prospect_mj.control.controller import CONTROL_PERIOD, Controller
from prospect_mj.control.grip_watch import GripWatch
from prospect_mj.control.hand_servo import HandServo, MotionSettings, PoseError
from prospect_mj.control.result import Measured, Status, Targets
from prospect_mj.robot.torso import ArmReading, Reading

_LEVER = 0.1
"""Weighs an angle against a distance when progress is judged [m/rad]."""


class CartesianMotion(Controller):
    """Move a hand to a pose, empty or with an object in it.

    Converges when the pose error is within tolerance; stalls when the error stops
    falling; loses the object when the fingertips stop feeling it.

    Args:
        arm: which arm, and its kinematics.
        target: pose of the grasp site in the world.
        posture: joint angles (7,) [rad] that resolve the redundancy.
        carrying: whether an object must stay in the hand.
        settings: speed, tolerances and time budget; None = this kind's own.
    """

    DEFAULTS: ClassVar[MotionSettings]

    def __init__(
        self,
        arm: ArmControl,
        target: mink.SE3,
        posture: np.ndarray,
        carrying: bool = False,
        settings: MotionSettings | None = None,
    ) -> None:
        """Start towards `target`."""
        settings = self.DEFAULTS if settings is None else settings
        super().__init__(arm.side, settings.time_budget)
        self._arm = arm
        self._servo = HandServo(arm, posture, settings)
        self._target, self._settings = target, settings
        self._grip = GripWatch(carrying)
        self._best, self._idle = np.inf, 0.0
        self._place = arm.grasp_pose().translation()

    def _law(self, reading: Reading) -> Targets:
        own = reading[self.side]
        error = self._servo.error(self._target)
        self.measured = Measured(position_error=error.position, angle_error=error.angle)
        self._judge(error, self._speed(), own)
        if self.result is not None:
            return Targets()
        return Targets(joints=self._servo.step(own, self._target))

    def _speed(self) -> float:
        """Of the hand over the last control period [m/s]."""
        before, self._place = self._place, self._arm.grasp_pose().translation()
        return float(np.linalg.norm(self._place - before)) / CONTROL_PERIOD

    def _judge(self, error: PoseError, speed: float, own: ArmReading) -> None:
        settings = self._settings
        self._watch(error)
        if self._grip.lost(own.touch):
            self._finish(Status.LOST, GripWatch.REASON)
        elif self._within(error) and speed < settings.rest_speed:
            self._finish(Status.CONVERGED)
        elif self._idle > settings.stall_time:
            millimetres, degrees = error.position * 1e3, np.rad2deg(error.angle)
            reason = f"{millimetres:.1f} mm and {degrees:.1f} deg short of the target"
            self._finish(Status.STALLED, reason)

    def _within(self, error: PoseError) -> bool:
        """Whether the hand is as near to its target as it has to be."""
        tolerance = self._settings
        return (
            error.position < tolerance.position_tolerance
            and error.angle < tolerance.angle_tolerance
        )

    def _watch(self, error: PoseError) -> None:
        """Time since the last progress."""
        length = error.position + _LEVER * error.angle
        progress = length < 0.99 * self._best - 1e-5
        self._best = min(self._best, length) if progress else self._best
        self._idle = 0.0 if progress else self._idle + CONTROL_PERIOD
