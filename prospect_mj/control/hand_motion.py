"""Hand motion: bring the fingers to an opening."""

import numpy as np

from prospect_mj.control.controller import CONTROL_PERIOD, Controller
from prospect_mj.control.result import Measured, Status, Targets
from prospect_mj.robot import posture
from prospect_mj.robot.names import Side
from prospect_mj.robot.torso import Reading

OPENING_SPEED = 1.5
"""Of the finger motors [rad/s]."""
TOLERANCE = 0.03
"""Largest finger error [rad]."""


class HandMotion(Controller):
    """Open (or close) the fingers to given motor angles.

    Args:
        side: which hand.
        angles: proximal angle of each finger to reach (3,) [rad].
        time_budget: after which it gives up [s].
    """

    def __init__(
        self,
        side: Side,
        angles: tuple[float, ...] = posture.OPEN,
        time_budget: float = 1.0,
    ) -> None:
        """Start from wherever the fingers are."""
        super().__init__(side, time_budget)
        self._angles = np.array(angles)

    def _law(self, reading: Reading) -> Targets:
        own = reading[self.side]
        error = float(np.abs(own.fingers - self._angles).max())
        self.measured = Measured(joint_error=error)
        if error < TOLERANCE:
            self._finish(Status.CONVERGED)
        step = OPENING_SPEED * CONTROL_PERIOD
        towards = np.clip(self._angles - own.finger_command, -step, step)
        return Targets(fingers=own.finger_command + towards)
