"""The fewest actions that a trial can take on average, exactly, from the outcome tree.

Dynamic programming (Bellman 1957) for an agent that knows the presentation, hence every
outcome. With k actions left in node s, where the jar is not inserted yet,

    V_0(s) = 0,    V_k(s) = 1 + min_a V_(k-1)(s'(s, a)),

and V_k = 0 where it is. A trial that can't be solved so takes all actions that it has.
The learner can't do as well, as with probability epsilon it takes any allowed action.
For the best of such policies (Sutton and Barto, Reinforcement Learning, 2018, section
5.4), with W_k(s, a) = V_(k-1)(s'(s, a)),

    V_k(s) = 1 + (1 - epsilon) min_a W_k(s, a) + epsilon mean_a W_k(s, a).
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from prospect_mj.agent.settings import LinearSettings
from prospect_mj.experiment.populations.kernels.graph import Graph
from prospect_mj.experiment.populations.outcome_graph import HANDS, recorded_graph
from prospect_mj.recording.hands import GRASPS, SWAPS
from prospect_mj.recording.recording import Recording
from prospect_mj.supervisor.supervisor import Supervisor


@dataclass(frozen=True)
class BySide:
    """Means over presentations."""

    left: float
    """With the lid to the left."""
    right: float
    """With the lid to the right."""

    @property
    def mean(self) -> float:
        """Over trials in which either side is as likely."""
        return (self.left + self.right) / 2


@dataclass(frozen=True)
class Optimum:
    """The best that can be done."""

    actions: BySide
    """Expected number of actions."""
    exploring: BySide
    """The same for who explores at the learner's rate; no learner comes below it."""
    optimal: BySide
    """Share of presentations in which the optimal strategy needs no more of them."""


def optimum(
    recording: Recording,
    supervisor: Supervisor | None = None,
    max_actions: int = 10,
    epsilon: float = LinearSettings.epsilon,
) -> Optimum:
    """The optimum over all presentations of a recording that are complete.

    Args:
        recording: the outcomes.
        supervisor: decides what may be chosen, its shaping lifted; None offers all.
        max_actions: a trial is cut off after this many.
        epsilon: the exploration rate [1].

    Raises:
        RecordingError: if no presentation of a side is complete.
    """
    shown = recording.complete(max_actions)
    lid = recording.presentations.lid[shown]
    root = recording.presentations.root[shown]
    graph = recorded_graph(recording, supervisor or Supervisor())
    actions = fewest_actions(graph, max_actions)[root]
    exploring = fewest_actions(graph, max_actions, epsilon=epsilon)[root]
    solved = fewest_actions(graph, max_actions, np.inf)[root]
    alone = optimal_strategy_alone(graph, root, lid)
    prospective = fewest_actions(alone, max_actions, np.inf)[root]
    # What can't be solved is infinite, and no strategy at all.
    is_optimal = np.isfinite(prospective) & (prospective == solved)
    return Optimum(*(_by_side(v, lid) for v in (actions, exploring, is_optimal)))


def fewest_actions(
    graph: Graph, max_actions: int, cut_off: float = 0.0, epsilon: float = 0.0
) -> NDArray[np.float64]:
    """V_k of every node, with k = `max_actions`.

    Args:
        graph: the outcomes; the choices of its last phase count.
        max_actions: actions that are left.
        cut_off: V_0 where the jar is not inserted; infinite, to tell what can't be
            solved from what is by the last action.
        epsilon: probability with which an action is any allowed one.

    Returns:
        (n,) [actions] expected, infinite where too few outcomes are known to tell.
    """
    known = graph.child >= 0
    after = graph.situation[np.where(known, graph.child, 0)]
    allowed = graph.choices[-1][graph.state]
    fewest = np.where(graph.inserted, 0.0, cut_off)
    for _ in range(max_actions):
        left = np.where(known, fewest[after], np.inf)
        follows = left.min(axis=1, where=allowed, initial=np.inf)
        if epsilon:
            explored = left.mean(axis=1, where=allowed)
            follows = (1.0 - epsilon) * follows + epsilon * explored
        fewest = np.where(graph.inserted, 0.0, 1.0 + follows)
    return fewest


def optimal_strategy_alone(
    graph: Graph, root: NDArray[np.int32], lid: NDArray[np.int8]
) -> Graph:
    """A graph on which trials can be solved by `Strategy.OPTIMAL` only.

    Args:
        graph: the outcomes.
        root: (p,), nodes in which nothing has been grasped yet.
        lid: (p,), the lid's side in each.

    Returns:
        The same without swaps and, in the roots, without the other hand's grasp: they
        change nothing there.
    """
    own = np.arange(len(graph.child))
    child = graph.child.copy()
    for hand in HANDS:
        child[:, SWAPS[hand]] = own
        others = root[lid != hand]
        child[others, GRASPS[hand]] = others
    return graph._replace(child=child)


def _by_side(values: NDArray[np.generic], lid: NDArray[np.int8]) -> BySide:
    return BySide(*(float(values[lid == side].mean()) for side in HANDS))
