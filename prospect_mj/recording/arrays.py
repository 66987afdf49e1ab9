"""Tables of trees as arrays."""

from dataclasses import dataclass

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from prospect_mj.actions.action import Action
from prospect_mj.recording.hands import NUMBERS, number_of
from prospect_mj.recording.node_predicates import COLUMNS, predicates_of
from prospect_mj.supervisor.predicates import PredicateState
from prospect_mj.supervisor.supervisor import Supervisor

UNKNOWN = -1
"""In place of a node that was not recorded."""


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
    felt: NDArray[np.float32]
    """(n, m, 2): time since the hand closes [s] and residual [1] of every sample of the
    grasp that led here; NaN after the last one."""


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
    columns = [table[name].combine_chunks().dictionary_encode() for name in COLUMNS]
    words = [column.dictionary.to_pylist() for column in columns]
    codes, sizes = [column.indices.to_numpy() for column in columns], [*map(len, words)]
    kinds, number = np.unique(np.ravel_multi_index(codes, sizes), return_inverse=True)
    states = tuple(
        predicates_of(*(word[code] for word, code in zip(words, kind, strict=True)))
        for kind in np.transpose(np.unravel_index(kinds, sizes))
    )
    supervisor = Supervisor()
    may_run = [
        [supervisor.may_run(action, state) for action in Action] for state in states
    ]
    return PredicateStates(states, np.array(may_run)), number.ravel()


def nodes(table: pa.Table, states: PredicateStates, number: NDArray[np.int64]) -> Nodes:
    """The nodes of a table.

    Args:
        table: under `schema.SCHEMA`, trees one after the other; `soundness.check` has
            passed it.
        states: those that occur.
        number: (n,), the state of each node.
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
    holds = np.array([number_of(next(iter(s.holders), None)) for s in states.states])
    return Nodes(
        child=child.astype(np.int32),
        situation=np.where(executed, own, parent).astype(np.int32),
        executed=executed,
        result=table["result"].fill_null("").to_numpy().astype(str),
        sim_seconds=_column(table, "sim_seconds"),
        inserted=inserted,
        holding=holds[number].astype(np.int8),
        depth=_column(table, "depth"),
        predicates=number,
        felt=_felt(table),
    )


def _felt(table: pa.Table) -> NDArray[np.float32]:
    """(n, m, 2): the trajectories of all grasps, as long as the longest, m."""
    lists = table["felt"].combine_chunks()
    lengths = lists.value_lengths().to_numpy()
    samples = lists.flatten()
    columns = [samples.field(name).to_numpy() for name in ("seconds", "residual")]
    felt = np.full((len(lists), lengths.max(initial=0), 2), np.nan, np.float32)
    felt[np.arange(felt.shape[1]) < lengths[:, None]] = np.column_stack(columns)
    return felt


def _global_parents(table: pa.Table) -> NDArray[np.int64]:
    """The row of every node's parent; UNKNOWN at a root."""
    root = np.arange(table.num_rows) - _column(table, "node")
    parent = table["parent"].fill_null(UNKNOWN).to_numpy()
    return np.where(parent == UNKNOWN, UNKNOWN, root + parent)


def presentations(table: pa.Table, nodes: Nodes) -> Presentations:
    """The roots of a table of nodes."""
    is_root = _column(table, "node") == 0
    root = np.flatnonzero(is_root)
    shown = table.take(root)["shown"].combine_chunks()
    lids = _column(table, "orientation")[root]
    return Presentations(
        root=root.astype(np.int32),
        lid=np.array([NUMBERS[lid] for lid in lids], np.int8),
        number=_column(table, "presentation")[root],
        histogram=np.array(shown.field("histogram").to_pylist(), np.int64),
        look=np.array(shown.field("look").to_pylist()),
        depth=_complete_depths(nodes, np.cumsum(is_root) - 1),
    )


def complete_depth(table: pa.Table) -> int:
    """Executed actions up to which the one tree in a table is complete."""
    found = nodes(table, *predicate_states(table))
    return int(_complete_depths(found, np.zeros(table.num_rows, np.int64))[0])


def _complete_depths(nodes: Nodes, tree: NDArray[np.int64]) -> NDArray[np.int64]:
    """Executed actions up to which each tree is complete; `tree` (n,) of each node."""
    depths = np.full(tree[-1] + 1, np.iinfo(np.int64).max)
    missing = (nodes.child == UNKNOWN).any(axis=1)
    is_open = missing & nodes.executed & ~nodes.inserted
    np.minimum.at(depths, tree[is_open], nodes.depth[is_open])
    return depths


def _column(table: pa.Table, name: str) -> NDArray[np.generic]:
    return table[name].to_numpy()
