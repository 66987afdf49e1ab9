"""A trial on a recording in memory."""

import numpy as np

from prospect_mj.actions.action import Action, ActionResult
from prospect_mj.recording.arrays import UNKNOWN
from prospect_mj.recording.felt import known_samples
from prospect_mj.recording.hands import hand_of
from prospect_mj.recording.presenter import Presenter
from prospect_mj.recording.recording import Recording
from prospect_mj.recording.trial import (
    RecordedLook,
    RecordedStep,
    RecordedTrial,
    not_recorded,
)
from prospect_mj.robot.names import Side
from prospect_mj.supervisor.predicates import PredicateState
from prospect_mj.supervisor.supervisor import Supervisor
from prospect_mj.task.presentation import Orientation


class RecordedTask(RecordedTrial):
    """Presents what was recorded and steps from node to node.

    Args:
        recording: where the outcomes come from.
        supervisor: decides what the learner may choose from.
        depth: executed actions that a trial may have; presentations with less than
            that recorded are not shown.

    Attributes:
        recording: as given.
    """

    def __init__(
        self, recording: Recording, supervisor: Supervisor, depth: int
    ) -> None:
        """Find the presentations that are complete.

        Raises:
            RecordingError: if there is none for a side of the lid.
        """
        super().__init__(supervisor)
        self.recording = recording
        self._presenter = Presenter(recording, depth)

    def reset(self, orientation: Orientation, rng: np.random.Generator) -> RecordedLook:
        """Present the jar as in one of the recorded presentations.

        Args:
            orientation: the side on which the lid lies.
            rng: draws the presentation.
        """
        shown = self.recording.presentations
        number = self._presenter.draw(orientation, rng)
        self.begin(int(shown.root[number]))
        return RecordedLook(str(shown.look[number]), shown.histogram[number])

    def begin(self, node: int) -> None:
        """Put the trial at a node of the recording."""
        self._node = node

    @property
    def predicates(self) -> PredicateState:
        """The predicates where the trial is."""
        number = self.recording.nodes.predicates[self.node]
        return self.recording.predicates.states[number]

    @property
    def holder(self) -> Side | None:
        """The hand whose grasp predicate is on."""
        return hand_of(int(self.recording.nodes.holding[self.node]))

    @property
    def inserted(self) -> bool:
        """Whether the jar stands in the receptacle and no hand holds it."""
        return bool(self.recording.nodes.inserted[self.node])

    def _step(self, action: Action) -> RecordedStep | None:
        nodes = self.recording.nodes
        led_to = int(nodes.child[self.node, action])
        if led_to == UNKNOWN:
            raise not_recorded(action, nodes.depth[self.node])
        if led_to == self.node:
            return None
        return RecordedStep(
            int(nodes.situation[led_to]),
            bool(nodes.executed[led_to]),
            ActionResult(nodes.result[led_to]),
            float(nodes.sim_seconds[led_to]),
            known_samples(nodes.felt[led_to]),
        )

    def close(self) -> None:
        """Nothing is held."""
