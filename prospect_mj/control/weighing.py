"""Weighing: feel with the wrist whether something hangs in the hand."""

from dataclasses import dataclass

import numpy as np

from prospect_mj.control.arm_control import ArmControl
from prospect_mj.control.controller import CONTROL_PERIOD, Controller
from prospect_mj.control.result import ControlResult, Measured, Status, Targets
from prospect_mj.robot import barrett_hand
from prospect_mj.robot.torso import Reading

GRAVITY = 9.81
"""[m/s^2]"""


@dataclass(frozen=True)
class WeighingResult(ControlResult):
    """The end of a weighing."""

    load: float = 0.0
    """Weight beyond the hand's own [N]."""


class Weighing(Controller):
    """Average the wrist's vertical force for a moment and compare it with a load.

    Args:
        arm: which arm, and its kinematics.
        expected: weight that should hang in the hand [N].
        share: how much of it must at least be felt.
        duration: of the averaging [s].
        rest: before it, for the arm to come to rest [s].
    """

    def __init__(
        self,
        arm: ArmControl,
        expected: float,
        share: float = 0.4,
        duration: float = 0.1,
        rest: float = 0.16,
    ) -> None:
        """Start with an empty average."""
        super().__init__(arm.side, time_budget=1.0)
        self._arm, self._least = arm, share * expected
        self._samples: list[float] = []
        self._n = round(duration / CONTROL_PERIOD)
        self._rest = rest

    def _law(self, reading: Reading) -> Targets:
        if self.seconds < self._rest:
            return Targets()
        own = reading[self.side]
        force = self._arm.twin.wrist_rotation(self.side) @ own.wrist_force
        self._samples.append(float(force[2]))
        self.measured = Measured(load=self._samples[-1])
        if len(self._samples) >= self._n:
            self._conclude(bool(own.touch.found.all()))
        return Targets()

    def _conclude(self, touching: bool) -> None:
        load = float(np.mean(self._samples)) - barrett_hand.MASS * GRAVITY
        held = touching and load > self._least
        status = Status.CONVERGED if held else Status.LOST
        self.result = WeighingResult(
            status, f"{load:.1f} N hang in the hand", self.seconds, load
        )
