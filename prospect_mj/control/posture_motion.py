"""Posture motion: bring an arm's joints to a known posture, clear of everything."""

from dataclasses import dataclass

import numpy as np

from prospect_mj.control.arm_control import ArmControl
from prospect_mj.control.controller import CONTROL_PERIOD, Controller
from prospect_mj.control.grip_watch import GripWatch
from prospect_mj.control.result import Measured, Status, Targets
from prospect_mj.robot.torso import ArmReading, Reading


@dataclass(frozen=True)
class PostureSettings:
    """When a posture counts as reached."""

    tolerance: float = 0.02
    """Largest joint error [rad]."""
    rest_speed: float = 0.15
    """Largest joint speed [rad/s]; a command that stopped a moving arm at once would
    take most of a joint's torque."""
    windup: float = 0.15
    """Most that a servo target may lead the measured angle [rad]."""
    carrying_speed: float = 1.2
    """Of the fastest joint while an object is in the hand [rad/s]; see
    `MotionSettings.turn_speed`."""
    ramp_time: float = 0.2
    """From rest to full speed [s]."""
    time_budget: float = 4.0
    """[s]"""


class PostureMotion(Controller):
    """Drive the joints to a posture under the same limits as hand motions.

    Args:
        arm: which arm, and its kinematics.
        posture: joint angles (7,) [rad].
        carrying: whether an object must stay in the hand.
        settings: tolerance and time budget.
    """

    def __init__(
        self,
        arm: ArmControl,
        posture: np.ndarray,
        carrying: bool = False,
        settings: PostureSettings | None = None,
    ) -> None:
        """Start towards `posture`."""
        self._settings = PostureSettings() if settings is None else settings
        super().__init__(arm.side, self._settings.time_budget)
        self._arm, self._posture, self._carrying = arm, posture, carrying
        self._grip = GripWatch(carrying)

    def _law(self, reading: Reading) -> Targets:
        own = reading[self.side]
        error = float(np.abs(own.joints - self._posture).max())
        self.measured = Measured(joint_error=error)
        speed = np.abs(own.velocities).max()
        if error < self._settings.tolerance and speed < self._settings.rest_speed:
            self._finish(Status.CONVERGED)
            # The exact posture, so that every action starts from the same commands.
            return Targets(joints=self._posture)
        if self._grip.lost(own.touch):
            self._finish(Status.LOST, GripWatch.REASON)
        return Targets(joints=self._towards(own))

    def _towards(self, own: ArmReading) -> np.ndarray:
        """Joint servo targets (7,) [rad] for the next control period."""
        settings = self._settings
        velocity = self._arm.ik.solve_posture(self._posture)
        if self._carrying:
            fastest = float(np.abs(velocity).max())
            velocity *= min(1.0, settings.carrying_speed / max(fastest, 1e-9))
        ramp = min(1.0, (self.seconds + CONTROL_PERIOD) / settings.ramp_time)
        ahead = own.joint_command + ramp * velocity * CONTROL_PERIOD
        return np.clip(
            ahead, own.joints - settings.windup, own.joints + settings.windup
        )
