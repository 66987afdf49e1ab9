"""The tree of everything that the executed actions of one presentation lead to.

A node is a situation of the robot between two actions. An edge is an action that the
supervisor lets run there; all others change nothing and are no edges.
"""

from collections.abc import Iterator
from dataclasses import dataclass, field, replace

from prospect_mj.actions.action import Action, ActionResult
from prospect_mj.supervisor.predicates import PredicateState
from prospect_mj.supervisor.supervisor import Supervisor
from prospect_mj.task.presentation import Orientation
from prospect_mj.task.trial_state import TrialState


@dataclass(frozen=True)
class Shown:
    """One presentation, and what the look made of it."""

    position: tuple[float, float, float]
    """Centre of the jar [m]."""
    yaw: float
    """Its turn about the vertical [rad]."""
    lamp_gain: float
    """Brightness of the lamp relative to its nominal."""
    look: str
    """Status of the look."""
    histogram: tuple[int, ...]
    """(100,) [pixels]."""


@dataclass(frozen=True)
class Node:
    """What an action led to, and from where; the root was led to by the look."""

    parent: int | None
    """Number of the node from which the action started."""
    action: Action | None
    executed: bool
    """False: it was started and found nothing to do, and the trial is where it was."""
    result: ActionResult | None
    sim_seconds: float
    """Simulated time of the action [s]."""
    predicates: PredicateState
    inserted: bool
    depth: int
    """Executed actions since the presentation."""
    state: TrialState | None
    """To grow on from; None where nothing grows any more, or it was left out."""
    felt: tuple[tuple[float, float], ...] = ()
    """(seconds [s], residual [1]), single precision: the trajectory of the action's
    last grasp (`GraspResult.trajectory`); empty without one."""


@dataclass(frozen=True)
class Edge:
    """An action to run from a node."""

    node: int
    action: Action


_SUPERVISOR = Supervisor()


@dataclass
class OutcomeTree:
    """A presentation with the nodes that are known; node 0 is the root."""

    orientation: Orientation
    number: int
    """Among the presentations of its orientation."""
    shown: Shown
    nodes: list[Node]
    children: dict[tuple[int, Action], int] = field(init=False)
    """Number of the node that an action leads to from a node."""

    def __post_init__(self) -> None:
        """Index the edges."""
        self.children = {
            (node.parent, node.action): number
            for number, node in enumerate(self.nodes)
            if node.parent is not None and node.action is not None
        }

    @property
    def name(self) -> tuple[Orientation, int]:
        """Of the presentation: its orientation and number."""
        return self.orientation, self.number

    @property
    def n_actions(self) -> int:
        """Actions that are recorded: all nodes but the root."""
        return len(self.nodes) - 1

    def add(self, node: Node) -> None:
        """Append what a new edge led to; a parent without further edges is done."""
        self.children[node.parent, node.action] = len(self.nodes)
        self.nodes.append(node)
        parent = self.nodes[node.parent]
        if not any(self._open_at(node.parent)):
            self.nodes[node.parent] = replace(parent, state=None)

    def open_edges(self, depth: int) -> Iterator[Edge]:
        """Edges that are not known yet, the shallow ones first.

        Args:
            depth: executed actions up to which the tree is wanted.
        """
        for number, node in enumerate(self.nodes):
            if node.depth < depth:
                yield from self._open_at(number)

    def is_complete(self, depth: int) -> bool:
        """Whether no edge is missing up to a depth [executed actions]."""
        return next(self.open_edges(depth), None) is None

    def _open_at(self, number: int) -> Iterator[Edge]:
        node = self.nodes[number]
        if node.inserted or (node.parent is not None and not node.executed):
            return
        for action in Action:
            known = (number, action) in self.children
            if not known and _SUPERVISOR.may_run(action, node.predicates):
                yield Edge(number, action)


def usual_actions(depth: int) -> int:
    """Edges of a complete tree in which every action does what it is named for.

    Then one hand holds the jar after the first action. From there on two actions can
    run: a swap changes the hand; an insertion jams and changes nothing if the jar is
    held the wrong way round, else it ends the trial. See docs/recording.md.

    Args:
        depth: executed actions up to which the tree is complete.
    """
    wrong, right, edges = 1, 1, 2
    for _ in range(depth - 1):
        edges += 2 * (wrong + right)
        wrong, right = wrong + right, wrong
    return edges
