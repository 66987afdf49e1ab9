"""The grasps of a recording from which haptic models are made."""

import numpy as np

from prospect_mj.agent.haptics import NONE
from prospect_mj.experiment.development.haptics.grasp import (
    CRADLE,
    HAND_OVER,
    Grasp,
)
from prospect_mj.recording.felt import check_felt, known_samples, parents, taken
from prospect_mj.recording.hands import hand_of
from prospect_mj.recording.recording import Recording

_FIRST_TWO = 2


def grasps(recording: Recording) -> list[Grasp]:
    """The first grasps of every presentation, and the hand-overs right after them.

    As many of the one kind as of the other. Later hand-overs, of which a recording has
    ten times as many, are all but copies of these.

    Raises:
        RecordingError: if it has none.
    """
    check_felt(recording)
    nodes, shown = recording.nodes, recording.presentations
    parent = parents(nodes)
    chosen = np.flatnonzero(taken(nodes) & (nodes.depth <= _FIRST_TWO))
    tree = recording.presentation_of(chosen)
    return [
        Grasp(
            hand_of(int(shown.lid[tree_of])),
            int(shown.number[tree_of]),
            hand_of(int(nodes.holding[node])),
            CRADLE if nodes.holding[parent[node]] == NONE else HAND_OVER,
            known_samples(nodes.felt[node]),
        )
        for node, tree_of in zip(chosen, tree, strict=True)
    ]
