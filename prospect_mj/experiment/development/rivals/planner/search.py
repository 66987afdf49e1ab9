"""Search for a shortest sequence of actions in an exact model.

Two ways of using it. *Blind*: breadth first from the start, every action that could
change anything. *Backward*: the outcome tree's goals taken back to its root, for which
all of the tree must be known beforehand.
"""

from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from prospect_mj.actions.action import Action
from prospect_mj.experiment.development.rivals.planner.simulators import (
    Ran,
    Simulator,
)
from prospect_mj.recording.arrays import Nodes
from prospect_mj.recording.felt import parents
from prospect_mj.recording.recording import Recording


@dataclass(frozen=True)
class SearchResult:
    """What a search came to, and what it took."""

    actions: tuple[Action, ...] | None
    """A shortest sequence; None if there is none so short."""
    expanded: int
    """Situations of which successors, or predecessors, were asked for."""
    simulated: int
    """Actions that were run in the model."""
    sim_seconds: float
    """Simulated time of these [s]."""


def breadth_first(simulator: Simulator, start: object, depth: int) -> SearchResult:
    """The blind search.

    Args:
        simulator: the exact model.
        start: the state when the trial begins.
        depth: longest sequence that is tried [actions].
    """
    waiting: deque[tuple[object, tuple[Action, ...]]] = deque([(start, ())])
    expanded, simulated, seconds = 0, 0, 0.0
    while waiting and len(waiting[0][1]) < depth:
        state, before = waiting.popleft()
        expanded += 1
        for action in simulator.open_actions(state):
            ran = simulator.run(state, action)
            simulated, seconds = simulated + 1, seconds + ran.sim_seconds
            if ran.inserted:
                return SearchResult((*before, action), expanded, simulated, seconds)
            waiting.append((ran.state, (*before, action)))
    return SearchResult(None, expanded, simulated, seconds)


def tried_out(
    simulator: Simulator, start: object, actions: Sequence[Action]
) -> SearchResult:
    """Run a plan in the exact model, to see whether it is right before acting.

    Returns:
        The actions as far as they go if they insert the jar, None if they don't.
    """
    seconds, ran = 0.0, Ran(start, False, 0.0)
    for number, action in enumerate(actions, 1):
        ran = simulator.run(ran.state, action)
        seconds += ran.sim_seconds
        if ran.inserted:
            return SearchResult(tuple(actions[:number]), 0, number, seconds)
    return SearchResult(None, 0, len(actions), seconds)


def backward(recording: Recording, number: int) -> SearchResult:
    """Goals of a presentation's recorded tree taken back until the root is among them.

    Args:
        recording: the outcomes.
        number: of the presentation.
    """
    nodes, root = recording.nodes, int(recording.presentations.root[number])
    parent = parents(nodes)
    tree = np.flatnonzero(recording.presentation_of(np.arange(len(parent))) == number)
    # Every action of the tree but for its root was simulated, whatever the plan is.
    simulated, seconds = len(tree) - 1, float(nodes.sim_seconds[tree].sum())
    layer = {int(goal): () for goal in tree[nodes.inserted[tree]]}
    expanded = 0
    while layer:
        expanded += len(layer)
        if root in layer:
            return SearchResult(layer[root], expanded, simulated, seconds)
        layer = {
            int(parent[node]): (_action(nodes, int(parent[node]), node), *rest)
            for node, rest in layer.items()
            if node != root
        }
    return SearchResult(None, expanded, simulated, seconds)


def _action(nodes: Nodes, before: int, node: int) -> Action:
    """What led from a node to another."""
    return Action(int(np.flatnonzero(nodes.child[before] == node)[0]))
