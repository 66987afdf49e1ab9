"""Whether nodes form trees that a trial could have gone through."""

from collections.abc import Iterator

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from prospect_mj.actions.action import Action, ActionResult
from prospect_mj.recording import arrays
from prospect_mj.supervisor import effects
from prospect_mj.supervisor.plant import End
from prospect_mj.supervisor.predicates import (
    NOTHING_SEEN,
    PRESENTED,
    PredicateState,
)
from prospect_mj.supervisor.supervisor import Supervisor

_SUPERVISOR = Supervisor()


def faults(table: pa.Table, is_root: NDArray[np.bool_]) -> Iterator[tuple[str, bool]]:
    """What may be wrong, and whether it is; each relies on those before it.

    Args:
        table: its columns are sound, each for itself.
        is_root: (n,), whether a node is one; the first is.
    """
    first = np.flatnonzero(is_root)
    tree = np.cumsum(is_root) - 1
    for name in ("orientation", "presentation"):
        own = table[name].to_numpy()
        yield f"{name} changes within a tree", (own != own[first][tree]).any()
    names = table.take(first).group_by(["orientation", "presentation"]).aggregate([])
    yield "a presentation is there twice", names.num_rows != len(first)
    node, parent = (_filled(table, name) for name in ("node", "parent"))
    whole = (node == np.arange(len(node)) - first[tree]) & (is_root | (parent < node))
    yield "a tree is not whole", not whole.all()
    # A root counts as its own parent.
    before = first[tree] + parent
    edges = (before * len(Action) + _filled(table, "action"))[~is_root]
    twice = np.unique(edges).size != edges.size
    yield "an action leads from a node to two others", twice
    yield from _faults_of_nodes(table, is_root, before)
    yield from _faults_of_outcomes(table, is_root, before)


def _faults_of_nodes(
    table: pa.Table, is_root: NDArray[np.bool_], before: NDArray[np.int64]
) -> Iterator[tuple[str, bool]]:
    """Faults of each node and the one `before` it (n,), as far as numbers tell."""
    executed, inserted, depth, seconds = (
        table[name].to_numpy()
        for name in ("executed", "inserted", "depth", "sim_seconds")
    )
    begun = executed & ~inserted & (depth == 0) & (seconds == 0)
    yield "a root is more than a presentation", not begun[is_root].all()
    expected = depth.astype(np.int64)[before] + (executed & ~is_root)
    yield "a depth does not fit", (depth != expected).any()
    ended = inserted | ~executed
    yield "a node follows one where nothing grows", ended[before][~is_root].any()
    result = table["result"].fill_null("").to_numpy()
    still = (result == ActionResult.NOT_SEEN) & (seconds == 0) & ~inserted
    ran = is_root | (result != ActionResult.NOT_SEEN)
    yield "executed does not fit the result", not np.where(executed, ran, still).all()
    held = table["left_holds"].to_numpy() | table["right_holds"].to_numpy()
    yield "a jar is inserted and held", (inserted & held).any()


def _faults_of_outcomes(
    table: pa.Table, is_root: NDArray[np.bool_], before: NDArray[np.int64]
) -> Iterator[tuple[str, bool]]:
    """Faults of what led to each node, by the supervisor's model."""
    found, number = arrays.predicate_states(table)
    begun = {found.states[state] for state in number[is_root]}
    for state in begun - {PRESENTED, NOTHING_SEEN}:
        yield f"no trial begins with {state}", True
    results = table["result"].combine_chunks().dictionary_encode()
    of_result = results.indices.fill_null(0).to_numpy()
    columns = number[before], _filled(table, "action"), of_result, number
    led = tuple(column[~is_root] for column in columns)
    sizes = len(found.states), len(Action), len(ActionResult), len(found.states)
    kinds = np.unique(np.ravel_multi_index(led, sizes))
    for start, action, result, end in np.transpose(np.unravel_index(kinds, sizes)):
        word = results.dictionary[result].as_py()
        outcome = End(ActionResult(word), found.states[end])
        wrong = _refusal(found.states[start], Action(action), outcome)
        yield wrong, bool(wrong)


def _refusal(state: PredicateState, action: Action, end: End) -> str:
    """Why an outcome can't be; empty if it can."""
    if not _SUPERVISOR.may_run(action, state):
        return f"{action.label} may not run from: {state}"
    if tuple(end) not in effects.outcomes(action, state):
        return f"{action.label} can't end in {end} from: {state}"
    return ""


def _filled(table: pa.Table, name: str) -> NDArray[np.int64]:
    return table[name].fill_null(0).to_numpy().astype(np.int64)
