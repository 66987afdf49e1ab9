"""Tables of trees as arrays."""

from dataclasses import dataclass

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from prospect_mj.actions.action import Action
from prospect_mj.errors import RecordingError
from prospect_mj.supervisor.predicates import ArmState, Jar, Place, PredicateState
from prospect_mj.supervisor.supervisor import Supervisor

UNKNOWN = -1
"""In place of a node that was not recorded."""
NONE, LEFT, RIGHT = 0, 1, 2
"""Hands by number; the same numbers stand for the lid's side."""
_SIDES = {"left": LEFT, "right": RIGHT}
_STATE_COLUMNS = ("left_holds", "left_place", "right_holds", "right_place", "jar")


@dataclass(frozen=True)
class Nodes:
    """Every node of every tree; n is their number."""

    child: NDArray[np.int32]
    """(n, 6): the node that an action leads to, the node itself where the supervisor
    does not let it run, or UNKNOWN."""
    situation: NDArray[np.int32]
    """(n,): the node in which the trial is after this one: itself, or its parent where
    an action was started and found nothing to do."""
    executed: NDArray[np.bool_]
    """(n,): whether the action that led here was run."""
    result: NDArray[np.str_]
    """(n,): what came of it; empty at a root."""
    sim_seconds: NDArray[np.float64]
    """(n,): simulated time of it [s]."""
    inserted: NDArray[np.bool_]
    """(n,): whether the jar stands in the receptacle."""
    holding: NDArray[np.int8]
    """(n,): NONE, LEFT or RIGHT."""
    depth: NDArray[np.int8]
    """(n,): executed actions since the presentation."""
    predicates: NDArray[np.int64]
    """(n,): number of the supervisor's state."""


@dataclass(frozen=True)
class Presentations:
    """The roots of the trees; p is their number."""

    root: NDArray[np.int32]
    """(p,): node."""
    lid: NDArray[np.int8]
    """(p,): side of the lid, LEFT or RIGHT."""
    number: NDArray[np.int32]
    """(p,): among those of the same side."""
    histogram: NDArray[np.int64]
    """(p, 100) [pixels]."""
    look: NDArray[np.str_]
    """(p,): status of the look."""
    depth: NDArray[np.int64]
    """(p,): executed actions up to which no outcome is missing."""


@dataclass(frozen=True)
class PredicateStates:
    """The supervisor's states that occur; s is their number."""

    states: tuple[PredicateState, ...]
    may_run: NDArray[np.bool_]
    """(s, 6): whether the supervisor lets an action run."""


def predicate_states(table: pa.Table) -> tuple[PredicateStates, NDArray[np.int64]]:
    """The states that occur in a table of nodes, and the number of each node's."""
    columns = [
        table[name].combine_chunks().dictionary_encode() for name in _STATE_COLUMNS
    ]
    codes = np.stack([column.indices.to_numpy() for column in columns])
    kinds, number = np.unique(codes, axis=1, return_inverse=True)
    words = [column.dictionary.to_pylist() for column in columns]
    states = tuple(
        _state(*(word[code] for word, code in zip(words, kind, strict=True)))
        for kind in kinds.T
    )
    supervisor = Supervisor()
    may_run = [
        [supervisor.may_run(action, state) for action in Action] for state in states
    ]
    return PredicateStates(states, np.array(may_run)), number.ravel()


def _state(
    left_holds: bool, left_place: str, right_holds: bool, right_place: str, jar: str
) -> PredicateState:
    left = ArmState(left_holds, Place(left_place))
    right = ArmState(right_holds, Place(right_place))
    return PredicateState(left, right, Jar(jar))


def nodes(table: pa.Table, states: PredicateStates, number: NDArray[np.int64]) -> Nodes:
    """The nodes of a table.

    Args:
        table: under `schema.SCHEMA`, trees one after the other.
        states: those that occur.
        number: (n,), the state of each node.

    Raises:
        RecordingError: if a node's parent does not come right before it, or a depth
            does not fit.
    """
    parent = _global_parents(table)
    executed = _column(table, "executed")
    own = np.arange(table.num_rows)
    inserted = _column(table, "inserted")
    refused = ~states.may_run[number] & ~inserted[:, None] & executed[:, None]
    child = np.where(refused, own[:, None], UNKNOWN)
    led = parent >= 0
    action = table["action"].fill_null(0).to_numpy()
    child[parent[led], action[led]] = own[led]
    depth = _column(table, "depth")
    if (depth[led] != depth[parent[led]] + executed[led]).any():
        raise RecordingError("the recording is damaged: a depth does not fit")
    holds = np.array([_holding(state) for state in states.states])
    return Nodes(
        child=child.astype(np.int32),
        situation=np.where(executed, own, parent).astype(np.int32),
        executed=executed,
        result=table["result"].fill_null("").to_numpy().astype(str),
        sim_seconds=_column(table, "sim_seconds"),
        inserted=inserted,
        holding=holds[number].astype(np.int8),
        depth=depth,
        predicates=number,
    )


def _global_parents(table: pa.Table) -> NDArray[np.int64]:
    """The row of every node's parent; -1 at a root."""
    own, node = np.arange(table.num_rows), _column(table, "node")
    first = np.maximum.accumulate(np.where(node == 0, own, 0))
    parent = table["parent"].fill_null(UNKNOWN).to_numpy()
    if (node != own - first).any() or (parent >= node).any():
        raise RecordingError("the recording is damaged: a tree is not whole")
    return np.where(parent < 0, UNKNOWN, first + parent)


def _holding(state: PredicateState) -> int:
    return _SIDES[state.holders[0]] if state.holders else NONE


def presentations(table: pa.Table, nodes: Nodes) -> Presentations:
    """The roots of a table of nodes."""
    is_root = _column(table, "node") == 0
    root = np.flatnonzero(is_root)
    shown = table.take(root)["shown"].combine_chunks()
    lids = _column(table, "orientation")[root]
    return Presentations(
        root=root.astype(np.int32),
        lid=np.array([_SIDES[lid] for lid in lids], np.int8),
        number=_column(table, "presentation")[root],
        histogram=np.array(shown.field("histogram").to_pylist(), np.int64),
        look=np.array(shown.field("look").to_pylist()),
        depth=_complete_depths(nodes, np.cumsum(is_root) - 1),
    )


def _complete_depths(nodes: Nodes, tree: NDArray[np.int64]) -> NDArray[np.int64]:
    """Executed actions up to which each tree is complete; `tree` (n,) of each node."""
    depths = np.full(tree[-1] + 1, np.iinfo(np.int64).max)
    missing = (nodes.child == UNKNOWN).any(axis=1)
    is_open = missing & nodes.executed & ~nodes.inserted
    np.minimum.at(depths, tree[is_open], nodes.depth[is_open])
    return depths


def _column(table: pa.Table, name: str) -> NDArray[np.generic]:
    return table[name].to_numpy()
