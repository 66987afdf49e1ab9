"""The life of a closed-loop controller: update until it has a result."""

from abc import ABC, abstractmethod
from collections.abc import Generator

import numpy as np

from prospect_mj.control.result import ControlResult, Measured, Status, Targets
from prospect_mj.robot.names import Side
from prospect_mj.robot.torso import ArmReading, Reading

CONTROL_PERIOD = 0.02
"""Between two updates of every controller [s]."""


class Controller(ABC):
    """A control law with a convergence predicate, a time budget and a result.

    A controller reads sensors and returns servo targets; it never steps physics.

    Args:
        side: the arm it moves.
        time_budget: after which it gives up [s].

    Attributes:
        result: None while it runs.
        measured: what its law measured in the last control period.
    """

    def __init__(self, side: Side, time_budget: float) -> None:
        """Start with a full time budget."""
        self.side: Side = side
        self.time_budget = time_budget
        self.result: ControlResult | None = None
        self.measured = Measured()
        self._ticks = 0

    @property
    def seconds(self) -> float:
        """How long it has run [s]."""
        return self._ticks * CONTROL_PERIOD

    @property
    def planned_path(self) -> np.ndarray | None:
        """Joint angles (n, 7) [rad] that it plans to go through, if it plans."""
        return None

    def update(self, reading: Reading) -> Targets:
        """One control period: sense, and either finish or ask for servo targets."""
        self.measured = Measured()
        targets = self._law(reading)
        self._ticks += 1
        if self.result is None and self.seconds >= self.time_budget:
            self._finish(Status.OUT_OF_TIME, f"after {self.time_budget:g} s")
        return targets

    def _finish(self, status: Status, reason: str = "") -> None:
        self.result = ControlResult(status, reason, self.seconds)

    @abstractmethod
    def _law(self, reading: Reading) -> Targets:
        """The control law; calls `_finish` when its predicate holds or it must stop."""


Procedure = Generator[Targets, ArmReading, None]
"""A control law in several stages: yields targets, receives what the arm senses."""


class ProceduralController(Controller):
    """A controller whose law is a procedure that calls `_finish` before it ends."""

    def __init__(self, side: Side, time_budget: float) -> None:
        """Start at the beginning of the procedure."""
        super().__init__(side, time_budget)
        self._running = self._procedure()
        next(self._running)

    @abstractmethod
    def _procedure(self) -> Procedure:
        """The stages; the first yield only waits for the first reading."""

    def _law(self, reading: Reading) -> Targets:
        try:
            return self._running.send(reading[self.side])
        except StopIteration:
            return Targets()
