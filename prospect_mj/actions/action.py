"""The six high-level actions, in the paper's order, and how they can end."""

from dataclasses import dataclass, field
from enum import IntEnum, StrEnum

from prospect_mj.control.result import ControlResult
from prospect_mj.robot.names import Side


class Action(IntEnum):
    """What the learner chooses from (Wheeler, Fagg & Grupen 2002, section 3.1)."""

    GRASP_LEFT = 0
    GRASP_RIGHT = 1
    SWAP_LEFT_TO_RIGHT = 2
    SWAP_RIGHT_TO_LEFT = 3
    INSERT_LEFT = 4
    INSERT_RIGHT = 5

    @property
    def label(self) -> str:
        """Name for tables and command lines, such as `grasp-left`."""
        return self.name.lower().replace("_", "-")


class ActionResult(StrEnum):
    """How an action ended, as the robot itself judges."""

    SUCCESS = "success"
    """It did what it is named for."""
    JAMMED = "jammed"
    """The insertion met the rim and backed out; the jar is still in the hand."""
    NOT_ALLOWED = "not_allowed"
    """It may not run in this predicate state: nothing moved."""
    NOT_SEEN = "not_seen"
    """Vision did not find the jar, or was unsure: nothing moved."""
    NOT_REACHED = "not_reached"
    """A motion stalled or ran out of time; whatever was held still is."""
    NOT_GRASPED = "not_grasped"
    """The fingers found no stable grasp; a swap's giver still holds the jar."""
    LOST = "lost"
    """The jar slipped out of the hand."""


@dataclass(frozen=True)
class ControllerRun:
    """One controller's part in an action."""

    name: str
    side: Side
    result: ControlResult


@dataclass(frozen=True)
class PlanOutcome:
    """What a plan did that was run to its end."""

    result: ActionResult
    sim_seconds: float
    """Simulated time that it took [s]."""
    runs: tuple[ControllerRun, ...] = field(default=())
    """The controllers it ran, in order."""


@dataclass(frozen=True)
class ActionOutcome:
    """What an action did."""

    action: Action
    executed: bool
    """Whether it was run: not where it may not, nor when the jar was not seen."""
    result: ActionResult
    sim_seconds: float
    """Simulated time that it took [s]."""
    runs: tuple[ControllerRun, ...] = field(default=())
    """The controllers it ran, in order."""
