"""Outcome trees as tables: one row per node, in the order in which nodes were found."""

from collections.abc import Mapping
from typing import Any

import pyarrow as pa

from prospect_mj.actions.action import Action, ActionResult
from prospect_mj.recording.node_predicates import COLUMNS, predicates_of, words_of
from prospect_mj.recording.schema import SCHEMA
from prospect_mj.recording.state_codec import state_of_row, state_row
from prospect_mj.recording.tree import Node, OutcomeTree, Shown


def tabulated(tree: OutcomeTree, states: bool = True) -> pa.Table:
    """A tree's nodes under `SCHEMA`.

    Args:
        tree: the tree.
        states: whether to keep what is needed to grow it further.
    """
    rows = [_row(tree, n, node, states) for n, node in enumerate(tree.nodes)]
    return pa.Table.from_pylist(rows, schema=SCHEMA)


def _row(tree: OutcomeTree, number: int, node: Node, states: bool) -> dict[str, Any]:
    kept = node.state if states else None
    return {
        "orientation": tree.orientation,
        "presentation": tree.number,
        "node": number,
        "parent": node.parent,
        "action": node.action,
        "executed": node.executed,
        "result": node.result,
        "sim_seconds": node.sim_seconds,
        "inserted": node.inserted,
        "depth": node.depth,
        **words_of(node.predicates),
        "shown": vars(tree.shown) if node.parent is None else None,
        "felt": [{"seconds": s, "residual": eps} for s, eps in node.felt],
        "state": None if kept is None else state_row(kept),
    }


def tree_of(table: pa.Table) -> OutcomeTree:
    """The tree that `tabulated` has made a table of."""
    rows = table.to_pylist()
    root = rows[0]
    shown = root["shown"]
    vectors = {name: tuple(shown[name]) for name in ("position", "histogram")}
    nodes = [_node(row) for row in rows]
    number = root["presentation"]
    return OutcomeTree(root["orientation"], number, Shown(**shown | vectors), nodes)


def _node(row: Mapping[str, Any]) -> Node:
    predicates = predicates_of(*(row[name] for name in COLUMNS))
    action, result, state = row["action"], row["result"], row["state"]
    return Node(
        parent=row["parent"],
        action=None if action is None else Action(action),
        executed=row["executed"],
        result=None if result is None else ActionResult(result),
        sim_seconds=row["sim_seconds"],
        predicates=predicates,
        inserted=row["inserted"],
        depth=row["depth"],
        state=None if state is None else state_of_row(state, predicates),
        felt=tuple((sample["seconds"], sample["residual"]) for sample in row["felt"]),
    )
