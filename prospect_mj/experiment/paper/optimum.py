"""The fewest actions that a trial can take on average, exactly, from the outcome tree.

Dynamic programming (Bellman 1957) for an agent that knows the presentation, hence every
outcome. With k actions left in node s, where the jar is not inserted yet,

    V_0(s) = 0,    V_k(s) = 1 + min_a V_(k-1)(s'(s, a)),

and V_k = 0 where it is. A trial that can't be solved so takes all actions that it has.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from prospect_mj.experiment.paper.kernel import Graph
from prospect_mj.experiment.paper.outcome_graph import HANDS, recorded_graph
from prospect_mj.recording.recording import Recording
from prospect_mj.supervisor.supervisor import Supervisor


@dataclass(frozen=True)
class Optimum:
    """The best expected numbers of actions."""

    left: float
    """[actions] with the lid to the left, mean over presentations."""
    right: float
    """[actions] with the lid to the right."""

    @property
    def mean(self) -> float:
        """[actions] over trials in which either side is as likely."""
        return (self.left + self.right) / 2


def optimum(
    recording: Recording, supervisor: Supervisor | None = None, max_actions: int = 10
) -> Optimum:
    """The optimum over all presentations of a recording that are complete.

    Args:
        recording: the outcomes.
        supervisor: decides what may be chosen, its shaping lifted; None offers all.
        max_actions: a trial is cut off after this many.

    Raises:
        RecordingError: if no presentation of a side is complete.
    """
    shown = recording.complete(max_actions)
    graph = recorded_graph(recording, supervisor or Supervisor())
    fewest = fewest_actions(graph, max_actions)
    actions = fewest[recording.presentations.root[shown]]
    lid = recording.presentations.lid[shown]
    left, right = (float(actions[lid == side].mean()) for side in HANDS)
    return Optimum(left, right)


def fewest_actions(graph: Graph, max_actions: int) -> NDArray[np.float64]:
    """V_k of every node, with k = `max_actions`.

    Args:
        graph: the outcomes; the choices of its last phase count.
        max_actions: actions that are left.

    Returns:
        (n,) [actions], infinite where too few outcomes are known to tell.
    """
    known = graph.child >= 0
    after = graph.situation[np.where(known, graph.child, 0)]
    open_to_choice = known & graph.choices[-1][graph.state]
    fewest = np.zeros(len(graph.child))
    for _ in range(max_actions):
        best = np.where(open_to_choice, fewest[after], np.inf).min(axis=1)
        fewest = np.where(graph.inserted, 0.0, 1.0 + best)
    return fewest
