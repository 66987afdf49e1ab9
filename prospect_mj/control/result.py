"""What a controller returns: failure of control is a value, never an exception."""

from dataclasses import dataclass
from enum import StrEnum

import numpy as np


class Status(StrEnum):
    """How a controller ended."""

    CONVERGED = "converged"
    STALLED = "stalled"
    """The error stopped falling before it was small enough."""
    LOST = "lost"
    """The object is no longer in the hand."""
    UNREACHABLE = "unreachable"
    """No way leads to the goal: nothing moved."""
    OUT_OF_TIME = "out of time"
    """The time budget ran out."""


@dataclass(frozen=True)
class ControlResult:
    """The end of a controller's run."""

    status: Status
    reason: str = ""
    """One clause for people."""
    seconds: float = 0.0
    """Simulated time that it ran [s]."""

    @property
    def converged(self) -> bool:
        """Whether the controller reached its goal."""
        return self.status is Status.CONVERGED


@dataclass(frozen=True)
class Measured:
    """What a control law measured in one control period; None = not its affair."""

    position_error: float | None = None
    """From the hand to its target [m]."""
    angle_error: float | None = None
    """The same about any axis, roll left out where it is free [rad]."""
    joint_error: float | None = None
    """Of the joint, or finger, that is farthest from its target [rad]."""
    way_left: float | None = None
    """Arc length of the streamline that is left to the goal [rad]."""
    residual: float | None = None
    """eps of the contacts [1]."""
    contact_force: float | None = None
    """Of the surroundings on what the hand inserts [N]."""
    load: float | None = None
    """What hangs in the hand, its own weight included [N]."""


@dataclass(frozen=True)
class Targets:
    """What a controller asks of its arm in one control period; None = as before."""

    joints: np.ndarray | None = None
    """Joint servo targets (7,) [rad]."""
    fingers: np.ndarray | None = None
    """Finger motor targets (3,) [rad]."""
