"""Graphs of outcomes that the compiled learner walks on: recorded ones, ideal ones."""

import numpy as np

from prospect_mj.actions.action import Action
from prospect_mj.agent.haptics import LEFT, NONE, RIGHT, haptic_states
from prospect_mj.experiment.populations.kernels.graph import Graph
from prospect_mj.experiment.populations.recorded_world import RecordedWorld
from prospect_mj.recording.choices import choice_sets
from prospect_mj.recording.hands import GRASPS, INSERTIONS, SWAPS
from prospect_mj.recording.recording import Recording
from prospect_mj.supervisor.supervisor import Supervisor

HANDS = (LEFT, RIGHT)

_NODES_PER_LID = 4
_INSERTED = 3


def recorded_graph(
    recording: Recording | RecordedWorld, supervisor: Supervisor
) -> Graph:
    """What really happened, with the choices that a supervisor offers.

    Args:
        recording: the outcomes of physics, with categories of grasps or without.
        supervisor: its mode and its shaping schedule decide on the choices.
    """
    world = RecordedWorld.of(recording)
    nodes, predicates = world.recording.nodes, world.recording.predicates
    category = 0 if world.category is None else world.category
    # Copies: numba compiles anew for arrays that are read-only or not contiguous.
    return Graph(
        child=np.array(nodes.child, np.int32),
        situation=np.array(nodes.situation, np.int32),
        inserted=np.array(nodes.inserted, np.bool_),
        holding=np.array(nodes.holding, np.int64),
        haptic=haptic_states(nodes.holding, category, world.categories),
        state=np.array(nodes.predicates, np.int32),
        choices=choice_sets(supervisor, predicates.states).astype(bool),
    )


def joined(first: Graph, second: Graph) -> Graph:
    """Two graphs as one: nodes and states of the second follow those of the first."""
    n, n_states = len(first.child), first.choices.shape[1]
    child = np.where(second.child < 0, second.child, second.child + n)
    moved = second._replace(
        child=child.astype(np.int32),
        situation=second.situation + np.int32(n),
        state=second.state + np.int32(n_states),
    )
    parts = zip(first[:-1], moved[:-1], strict=True)
    choices = np.concatenate([first.choices, second.choices], axis=1)
    return Graph(*map(np.concatenate, parts), choices)


def ideal_graph() -> Graph:
    """Every action that can succeed does, and the learner may choose all.

    The jar is taken by either hand when none holds it, passed on by the hand that holds
    it, and inserted by the hand on the lid's side; all else changes nothing.
    """
    n = _NODES_PER_LID * len(HANDS)
    holding = np.array([NONE, LEFT, RIGHT, NONE] * len(HANDS), np.int64)
    child = np.repeat(np.arange(n, dtype=np.int32)[:, None], len(Action), axis=1)
    for lid in HANDS:
        root = ideal_root(lid)
        for hand, other in zip(HANDS, reversed(HANDS), strict=True):
            child[root, GRASPS[hand]] = root + hand
            child[root + hand, SWAPS[hand]] = root + other
        child[root + lid, INSERTIONS[lid]] = root + _INSERTED
    return Graph(
        child=child,
        situation=np.arange(n, dtype=np.int32),
        inserted=np.arange(n) % _NODES_PER_LID == _INSERTED,
        holding=holding,
        haptic=holding.copy(),
        state=np.zeros(n, np.int32),
        choices=np.ones((1, 1, len(Action)), np.bool_),
    )


def ideal_root(lid: int) -> int:
    """The node of the ideal graph where a trial begins; `lid` is LEFT or RIGHT."""
    return _NODES_PER_LID * (lid - LEFT)
