"""What was felt in a recording: the grasp in which each node has the jar, and its kind.

A grasp or a hand-over that succeeds takes hold; what it felt like is that of the hold
until the jar changes hands. What a taker felt in vain doesn't count.
"""

import numpy as np
from numpy.typing import NDArray

from prospect_mj.actions.action import ActionResult
from prospect_mj.agent.haptics import NONE
from prospect_mj.errors import RecordingError
from prospect_mj.haptics import TrajectoryModels, categories, phase_samples
from prospect_mj.recording.arrays import Nodes
from prospect_mj.recording.recording import Recording

_NOWHERE = -1


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


def check_felt(recording: Recording) -> None:
    """Refuse a recording of which no grasp was kept.

    Raises:
        RecordingError: if nothing was felt in it.
    """
    if not taken(recording.nodes).any():
        raise RecordingError(
            "the recording has no grasp of which it kept what was felt"
        )


def holding_since(nodes: Nodes) -> NDArray[np.int64]:
    """(n,): the node of the grasp in which the jar is held; -1 where no hand does."""
    parent, own = parents(nodes), np.arange(len(nodes.child))
    held = np.where(taken(nodes), own, parent)
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


def taken(nodes: Nodes) -> NDArray[np.bool_]:
    """(n,): whether the action that led to a node is a grasp that holds."""
    felt = ~np.isnan(nodes.felt).all(axis=(1, 2))
    return felt & (nodes.result == ActionResult.SUCCESS)


def known_samples(felt: NDArray[np.float32]) -> NDArray[np.float32]:
    """The samples (k, 2) of a grasp (m, 2) in which those after its last are NaN."""
    return felt[~np.isnan(felt[:, 0])]
