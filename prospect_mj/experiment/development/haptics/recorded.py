"""Grasps of a recording, and the category of the grasp in each of its nodes."""

import numpy as np
from numpy.typing import NDArray

from prospect_mj.actions.action import ActionResult
from prospect_mj.errors import RecordingError
from prospect_mj.experiment.development.haptics.grasp import (
    CRADLE,
    HAND_OVER,
    Grasp,
)
from prospect_mj.haptics import TrajectoryModels, categories, phase_samples
from prospect_mj.recording.arrays import Nodes
from prospect_mj.recording.hands import NONE, hand_of
from prospect_mj.recording.recording import Recording

_NOWHERE = -1
_FIRST_TWO = 2


def grasps(recording: Recording) -> list[Grasp]:
    """The first grasps of every presentation, and the hand-overs right after them.

    As many of the one kind as of the other. Later hand-overs, of which a recording has
    ten times as many, are all but copies of these.

    Raises:
        RecordingError: if it has none.
    """
    nodes, shown = recording.nodes, recording.presentations
    parent = parents(nodes)
    chosen = np.flatnonzero(_grasped(nodes) & (nodes.depth <= _FIRST_TWO))
    tree = np.searchsorted(shown.root, chosen, side="right") - 1
    if not len(chosen):
        raise RecordingError(
            "the recording has no grasp of which it kept what was felt"
        )
    return [
        Grasp(
            hand_of(int(shown.lid[tree_of])),
            int(shown.number[tree_of]),
            hand_of(int(nodes.holding[node])),
            CRADLE if nodes.holding[parent[node]] == NONE else HAND_OVER,
            _known(nodes.felt[node]),
        )
        for node, tree_of in zip(chosen, tree, strict=True)
    ]


def category_of_nodes(
    recording: Recording, models: TrajectoryModels
) -> NDArray[np.int64]:
    """The category of the grasp in which each node of a recording has the jar.

    Args:
        recording: with what was felt.
        models: the categories.

    Returns:
        (n,), from 0; 0 where no hand holds the jar.
    """
    nodes = recording.nodes
    held = holding_since(nodes)
    made = np.unique(held[held != _NOWHERE])
    category = np.zeros(len(held), np.int64)
    if len(made):
        felt = [phase_samples(nodes.felt[node]) for node in made]
        category[made] = categories(felt, models)
    return np.where(held == _NOWHERE, 0, category[held])


def holding_since(nodes: Nodes) -> NDArray[np.int64]:
    """(n,): the node of the grasp in which the jar is held; -1 where no hand does."""
    parent, own = parents(nodes), np.arange(len(nodes.child))
    held = np.where(_grasped(nodes), own, parent)
    # Each round looks twice as far back, until all have come to a grasp or a root.
    while True:
        further = np.where(held == _NOWHERE, _NOWHERE, held[held])
        if np.array_equal(further, held):
            return np.where(nodes.holding == NONE, _NOWHERE, held)
        held = further


def parents(nodes: Nodes) -> NDArray[np.int64]:
    """(n,): the node before each; -1 at a root."""
    n = len(nodes.child)
    parent = np.full(n, _NOWHERE, np.int64)
    start, action = np.nonzero(
        (nodes.child >= 0) & (nodes.child != np.arange(n)[:, None])
    )
    parent[nodes.child[start, action]] = start
    return parent


def _grasped(nodes: Nodes) -> NDArray[np.bool_]:
    """(n,): whether the action that led to a node is a grasp that holds."""
    felt = ~np.isnan(nodes.felt).all(axis=(1, 2))
    return felt & (nodes.result == ActionResult.SUCCESS)


def _known(felt: NDArray[np.float32]) -> NDArray[np.float32]:
    return felt[~np.isnan(felt[:, 0])]
