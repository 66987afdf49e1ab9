"""A trial on recorded physics, with the interface of `task.PickPlaceTask`."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from prospect_mj.actions.action import Action, ActionOutcome, ActionResult
from prospect_mj.closing import Closing
from prospect_mj.errors import RecordingError
from prospect_mj.recording.arrays import LEFT, UNKNOWN
from prospect_mj.recording.recording import Recording
from prospect_mj.robot.names import SIDES, Side
from prospect_mj.supervisor.predicates import PredicateState
from prospect_mj.supervisor.supervisor import Supervisor
from prospect_mj.task.presentation import ORIENTATIONS, Orientation


class RecordedLook(NamedTuple):
    """What is recorded of a look."""

    status: str
    histogram: NDArray[np.int64]
    """(100,) [pixels]."""


class RecordedTask(Closing):
    """Presents what was recorded and steps from node to node.

    Args:
        recording: where the outcomes come from.
        supervisor: decides what the learner may choose from.
        depth: executed actions that a trial may have; presentations with less than
            that recorded are not shown.

    Attributes:
        recording: as given.
        supervisor: as given.
    """

    def __init__(
        self, recording: Recording, supervisor: Supervisor, depth: int
    ) -> None:
        """Find the presentations that are complete.

        Raises:
            RecordingError: if there is none for a side of the lid.
        """
        self.recording, self.supervisor = recording, supervisor
        self._node: int | None = None
        complete = recording.complete(depth)
        lids = recording.presentations.lid[complete]
        self._complete = {
            orientation: complete[lids == lid]
            for lid, orientation in enumerate(ORIENTATIONS, LEFT)
        }

    def reset(self, orientation: Orientation, rng: np.random.Generator) -> RecordedLook:
        """Present the jar as in one of the recorded presentations.

        Args:
            orientation: the side on which the lid lies.
            rng: draws the presentation.
        """
        shown = self.recording.presentations
        number = rng.choice(self._complete[orientation])
        self.begin(int(shown.root[number]))
        return RecordedLook(str(shown.look[number]), shown.histogram[number])

    def begin(self, node: int) -> None:
        """Put the trial at a node of the recording."""
        self._node = node

    @property
    def node(self) -> int:
        """Where the trial is.

        Raises:
            RecordingError: before the first.
        """
        if self._node is None:
            raise RecordingError("no trial is under way: call reset")
        return self._node

    @property
    def predicates(self) -> PredicateState:
        """The predicates where the trial is."""
        number = self.recording.nodes.predicates[self.node]
        return self.recording.predicates.states[number]

    @property
    def holder(self) -> Side | None:
        """The hand whose grasp predicate is on."""
        hand = self.recording.nodes.holding[self.node]
        return SIDES[hand - LEFT] if hand else None

    @property
    def inserted(self) -> bool:
        """Whether the jar stands in the receptacle and no hand holds it."""
        return bool(self.recording.nodes.inserted[self.node])

    def execute(self, action: Action) -> ActionOutcome:
        """Take over what an action led to, or do nothing if it may not run.

        Raises:
            RecordingError: if that was not recorded.
        """
        nodes = self.recording.nodes
        led_to = int(nodes.child[self.node, action])
        if led_to == UNKNOWN:
            raise RecordingError(
                f"{action.label} from here was not recorded: the trial has more than "
                f"{nodes.depth[self.node]} executed actions"
            )
        if led_to == self.node:
            return ActionOutcome(action, False, ActionResult.NOT_ALLOWED, 0.0)
        self._node = int(nodes.situation[led_to])
        result = ActionResult(nodes.result[led_to])
        executed = bool(nodes.executed[led_to])
        return ActionOutcome(action, executed, result, float(nodes.sim_seconds[led_to]))

    def close(self) -> None:
        """Nothing is held."""
