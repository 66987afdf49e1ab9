"""A trial on recorded physics that simulates what was not recorded yet."""

from functools import cached_property

import numpy as np

from prospect_mj.actions.action import Action, ActionOutcome, ActionResult
from prospect_mj.closing import Closing
from prospect_mj.errors import RecordingError
from prospect_mj.recording.config import Extent
from prospect_mj.recording.grower import Grower
from prospect_mj.recording.growing import GrowingRecording
from prospect_mj.recording.task import RecordedLook
from prospect_mj.recording.tree import Edge, OutcomeTree
from prospect_mj.robot.names import Side
from prospect_mj.supervisor.predicates import PredicateState
from prospect_mj.supervisor.supervisor import Supervisor
from prospect_mj.task.presentation import Orientation


class LazyTask(Closing):
    """Steps through trees and grows them where a trial leaves what is known.

    Args:
        recording: the folder that grows; closed with the task.
        supervisor: decides what the learner may choose from.
        presentations: of each orientation, that trials draw from.

    Attributes:
        supervisor: as given.
    """

    def __init__(
        self,
        recording: GrowingRecording,
        supervisor: Supervisor,
        presentations: int = Extent.presentations,
    ) -> None:
        """Start with what the folder holds; physics is made when it is needed."""
        self.supervisor = supervisor
        self._recording, self._presentations = recording, presentations
        self._trees: dict[tuple[Orientation, int], OutcomeTree] = {}
        self._tree: OutcomeTree | None = None
        self._node = 0

    @cached_property
    def _grower(self) -> Grower:
        return Grower(self._recording.key.config)

    def reset(self, orientation: Orientation, rng: np.random.Generator) -> RecordedLook:
        """Present the jar as in one of the presentations.

        Args:
            orientation: the side on which the lid lies.
            rng: draws the presentation.
        """
        name = orientation, int(rng.integers(self._presentations))
        if name not in self._trees:
            self._trees[name] = self._recording.tree(*name) or self._planted(*name)
        self._tree, self._node = self._trees[name], 0
        shown = self._tree.shown
        return RecordedLook(shown.look, np.array(shown.histogram))

    def _planted(self, orientation: Orientation, number: int) -> OutcomeTree:
        tree = self._grower.plant(orientation, number)
        self._recording.keep(tree)
        return tree

    @property
    def _tree_now(self) -> OutcomeTree:
        if self._tree is None:
            raise RecordingError("no trial is under way: call reset")
        return self._tree

    @property
    def predicates(self) -> PredicateState:
        """The predicates where the trial is."""
        return self._tree_now.nodes[self._node].predicates

    @property
    def holder(self) -> Side | None:
        """The hand whose grasp predicate is on."""
        holders = self.predicates.holders
        return holders[0] if holders else None

    @property
    def inserted(self) -> bool:
        """Whether the jar stands in the receptacle and no hand holds it."""
        return self._tree_now.nodes[self._node].inserted

    def execute(self, action: Action) -> ActionOutcome:
        """Take over what an action led to; simulate it if that is not known.

        Raises:
            RecordingError: if it is not known and the tree was stored without states.
        """
        if not self.supervisor.may_run(action, self.predicates):
            return ActionOutcome(action, False, ActionResult.NOT_ALLOWED, 0.0)
        tree, edge = self._tree_now, Edge(self._node, action)
        if (self._node, action) not in tree.children:
            self._grower.extend(tree, edge)
            self._recording.keep(tree)
        number = tree.children[self._node, action]
        led_to = tree.nodes[number]
        if led_to.executed:
            self._node = number
        return ActionOutcome(action, led_to.executed, led_to.result, led_to.sim_seconds)

    def close(self) -> None:
        """Close the folder, and the physics if there is any."""
        self._recording.close()
        if "_grower" in vars(self):
            self._grower.close()
