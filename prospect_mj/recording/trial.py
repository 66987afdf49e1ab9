"""A trial that steps through outcomes; it has the interface of `task.PickPlaceTask`."""

from abc import abstractmethod
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from prospect_mj.actions.action import Action, ActionOutcome, ActionResult
from prospect_mj.closing import Closing
from prospect_mj.errors import RecordingError
from prospect_mj.robot.names import Side
from prospect_mj.supervisor.predicates import PredicateState
from prospect_mj.supervisor.supervisor import Supervisor
from prospect_mj.task.presentation import Orientation


class RecordedLook(NamedTuple):
    """What is recorded of a look."""

    status: str
    histogram: NDArray[np.int64]
    """(100,) [pixels]."""


class RecordedStep(NamedTuple):
    """What is recorded of an action that the supervisor let run."""

    situation: int
    """The node in which the trial is after it."""
    executed: bool
    result: ActionResult
    sim_seconds: float
    """Simulated time of it [s]."""
    felt: NDArray[np.float32]
    """(m, 2): time since the hand closes [s] and residual [1] of every sample of its
    last grasp; m is 0 without one."""


def not_recorded(action: Action, depth: int) -> RecordingError:
    """The error that an outcome is missing.

    Args:
        action: that was to be run.
        depth: executed actions before it.
    """
    return RecordingError(
        f"{action.label} from here was not recorded: the trial has more than {depth} "
        "executed actions"
    )


_NOTHING = np.empty((0, 2), np.float32)


class RecordedTrial(Closing):
    """Steps from node to node.

    Args:
        supervisor: decides what the learner may choose from.

    Attributes:
        supervisor: as given.
    """

    def __init__(self, supervisor: Supervisor) -> None:
        """Begin no trial yet."""
        self.supervisor = supervisor
        self._node: int | None = None
        self._felt = _NOTHING

    @property
    def felt(self) -> NDArray[np.float32]:
        """What the last action felt like, as `RecordedStep` has it."""
        return self._felt

    @property
    def node(self) -> int:
        """Where the trial is.

        Raises:
            RecordingError: before the first.
        """
        if self._node is None:
            raise RecordingError("no trial is under way: call reset")
        return self._node

    @abstractmethod
    def reset(self, orientation: Orientation, rng: np.random.Generator) -> RecordedLook:
        """Present the jar as in one of the presentations.

        Args:
            orientation: the side on which the lid lies.
            rng: draws the presentation.
        """

    @property
    @abstractmethod
    def predicates(self) -> PredicateState:
        """The predicates where the trial is."""

    @property
    @abstractmethod
    def inserted(self) -> bool:
        """Whether the jar stands in the receptacle and no hand holds it."""

    @property
    def holder(self) -> Side | None:
        """The hand whose grasp predicate is on."""
        holders = self.predicates.holders
        return holders[0] if holders else None

    def execute(self, action: Action) -> ActionOutcome:
        """Take over what an action led to, or do nothing if it may not run.

        Raises:
            RecordingError: if that is not recorded, and can't be.
        """
        step = self._step(action)
        self._felt = _NOTHING if step is None else step.felt
        if step is None:
            return ActionOutcome(action, False, ActionResult.NOT_ALLOWED, 0.0)
        self._node = step.situation
        return ActionOutcome(action, step.executed, step.result, step.sim_seconds)

    @abstractmethod
    def _step(self, action: Action) -> RecordedStep | None:
        """What an action leads to from here; None if it may not run."""
