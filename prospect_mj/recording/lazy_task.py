"""A trial on recorded physics that simulates what was not recorded yet."""

import numpy as np

from prospect_mj.actions.action import Action
from prospect_mj.recording.growing import GrowingRecording
from prospect_mj.recording.live_physics import LivePhysics
from prospect_mj.recording.presenter import GrowingPresenter
from prospect_mj.recording.tree import Edge, Node, OutcomeTree
from prospect_mj.recording.trial import RecordedLook, RecordedStep, RecordedTrial
from prospect_mj.supervisor.predicates import PredicateState
from prospect_mj.supervisor.supervisor import Supervisor
from prospect_mj.task.presentation import Orientation


class LazyTask(RecordedTrial):
    """Steps through trees and grows them where a trial leaves what is known.

    Args:
        recording: the folder that grows; closed with the task.
        supervisor: decides what the learner may choose from.
        physics: makes what is missing; closed with the task.

    Attributes:
        presenter: draws presentations.
    """

    def __init__(
        self,
        recording: GrowingRecording,
        supervisor: Supervisor,
        physics: LivePhysics | None = None,
    ) -> None:
        """Start with what the folder holds; physics is made when it is needed."""
        super().__init__(supervisor)
        self._recording = recording
        config = recording.key.config
        self._physics = LivePhysics(config) if physics is None else physics
        self.presenter = GrowingPresenter(recording.path)
        self._trees: dict[tuple[Orientation, int], OutcomeTree] = {}
        self._tree: OutcomeTree | None = None

    def reset(self, orientation: Orientation, rng: np.random.Generator) -> RecordedLook:
        """Present the jar as in one of the presentations.

        Args:
            orientation: the side on which the lid lies.
            rng: draws the presentation.

        Raises:
            FolderInUse: if the folder was closed.
        """
        self._recording.check_open()
        name = orientation, self.presenter.draw(rng)
        if name not in self._trees:
            self._trees[name] = self._recording.tree(*name) or self._planted(*name)
        self._tree, self._node = self._trees[name], 0
        shown = self._tree.shown
        return RecordedLook(shown.look, np.array(shown.histogram))

    def _planted(self, orientation: Orientation, number: int) -> OutcomeTree:
        tree = self._physics.plant(orientation, number)
        self._recording.keep(tree)
        return tree

    @property
    def _at(self) -> Node:
        number = self.node
        return self._tree.nodes[number]

    @property
    def predicates(self) -> PredicateState:
        """The predicates where the trial is."""
        return self._at.predicates

    @property
    def inserted(self) -> bool:
        """Whether the jar stands in the receptacle and no hand holds it."""
        return self._at.inserted

    def _step(self, action: Action) -> RecordedStep | None:
        self._recording.check_open()
        if not self.supervisor.may_run(action, self.predicates):
            return None
        tree, edge = self._tree, Edge(self.node, action)
        if (self.node, action) not in tree.children:
            self._physics.extend(tree, edge)
            self._recording.keep(tree)
        number = tree.children[self.node, action]
        led_to = tree.nodes[number]
        return RecordedStep(
            number if led_to.executed else self.node,
            led_to.executed,
            led_to.result,
            led_to.sim_seconds,
            np.array(led_to.felt, np.float32).reshape(-1, 2),
        )

    def close(self) -> None:
        """Close the folder, and the physics if there is any."""
        self._recording.close()
        self._physics.close()
