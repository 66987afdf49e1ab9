"""Posture motion: bring an arm's joints to a known posture, clear of everything."""

from dataclasses import dataclass

import numpy as np

from prospect_mj.control.arm_control import ArmControl
from prospect_mj.control.controller import CONTROL_PERIOD, Controller
from prospect_mj.control.result import Status, Targets
from prospect_mj.robot.torso import Reading


@dataclass(frozen=True)
class PostureSettings:
    """When a posture counts as reached."""

    tolerance: float = 0.02
    """Largest joint error [rad]."""
    windup: float = 0.15
    """Most that a servo target may lead the measured angle [rad]."""
    time_budget: float = 4.0
    """[s]"""


class PostureMotion(Controller):
    """Drive the joints to a posture under the same limits as hand motions.

    Args:
        arm: which arm, and its kinematics.
        posture: joint angles (7,) [rad].
        settings: tolerance and time budget.
    """

    def __init__(
        self,
        arm: ArmControl,
        posture: np.ndarray,
        settings: PostureSettings | None = None,
    ) -> None:
        """Start towards `posture`."""
        self._settings = PostureSettings() if settings is None else settings
        super().__init__(arm.side, self._settings.time_budget)
        self._arm, self._posture = arm, posture

    def _law(self, reading: Reading) -> Targets:
        own = reading[self.side]
        error = np.abs(own.joints - self._posture).max()
        if error < self._settings.tolerance:
            self._finish(Status.CONVERGED)
            # The exact posture, so that every action starts from the same commands.
            return Targets(joints=self._posture)
        velocity = self._arm.ik.solve_posture(self._posture)
        ahead = own.joint_command + velocity * CONTROL_PERIOD
        windup = self._settings.windup
        return Targets(joints=np.clip(ahead, own.joints - windup, own.joints + windup))
