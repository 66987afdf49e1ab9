"""How many recorded outcomes are those of the abstract task, by who holds the jar.

In the abstract task every action that can succeed does (`outcome_graph.ideal_graph`).
"""

from typing import NamedTuple

import numpy as np

from prospect_mj.agent.haptics import LEFT
from prospect_mj.experiment.populations.outcome_graph import (
    HANDS,
    ideal_graph,
    ideal_root,
)
from prospect_mj.recording.arrays import UNKNOWN
from prospect_mj.recording.recording import Recording


class IdealOutcomes(NamedTuple):
    """Counted over all actions in all nodes of the trees."""

    recorded: int
    """Outcomes that there are."""
    unlike: int
    """Of these, after which another hand holds the jar than in the abstract task, or
    only one of both has it inserted."""


def compare(recording: Recording) -> IdealOutcomes:
    """Count the outcomes of a recording."""
    nodes, shown, graph = recording.nodes, recording.presentations, ideal_graph()
    tree = np.searchsorted(shown.root, np.arange(len(nodes.child)), side="right") - 1
    roots = np.array([ideal_root(lid) for lid in HANDS])[shown.lid[tree] - LEFT]
    expected = graph.child[roots + nodes.holding]
    recorded = (nodes.child != UNKNOWN) & ~nodes.inserted[:, None]
    led_to = nodes.situation[np.where(recorded, nodes.child, 0)]
    same = nodes.holding[led_to] == graph.holding[expected]
    same &= nodes.inserted[led_to] == graph.inserted[expected]
    return IdealOutcomes(int(recorded.sum()), int((recorded & ~same).sum()))
