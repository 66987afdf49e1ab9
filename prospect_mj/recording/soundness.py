"""Whether a table of nodes is one that recording could have made.

Files carry checksums; this is for tables that are whole, and make no sense.
"""

from collections.abc import Iterator
from enum import StrEnum
from typing import Any

import numpy as np
import pyarrow as pa
import pyarrow.compute as pc
from numpy.typing import NDArray

from prospect_mj.actions.action import Action, ActionResult
from prospect_mj.agent.features import N_BINS
from prospect_mj.errors import RecordingError
from prospect_mj.recording.schema import NOT_AT_ROOTS, ROOTS_ONLY, SCHEMA
from prospect_mj.supervisor.predicates import Jar, Place
from prospect_mj.task.presentation import ORIENTATIONS

_WORDS: dict[str, type[StrEnum] | tuple[str, ...]] = {
    "orientation": ORIENTATIONS,
    "result": ActionResult,
    "left_place": Place,
    "right_place": Place,
    "jar": Jar,
}
_RANGES = {
    "presentation": (0, np.inf),
    "parent": (0, np.inf),
    "action": (0, len(Action) - 1),
    "sim_seconds": (0, np.finfo(float).max),
    "depth": (0, np.inf),
}


def check(table: pa.Table) -> None:
    """Refuse a table that makes no sense.

    Args:
        table: under `schema.SCHEMA` but for the states, trees one after the other.

    Raises:
        RecordingError: with what is wrong.
    """
    for wrong, is_so in _faults(table):
        if is_so:
            raise RecordingError(f"the recording is damaged: {wrong}")


def _faults(table: pa.Table) -> Iterator[tuple[str, bool]]:
    """What may be wrong, and whether it is; each may rely on those before it."""
    is_root = pc.fill_null(pc.equal(table["node"], 0), False).to_numpy()
    for name in SCHEMA.names:
        if name != "state":
            missing = table[name].is_null().to_numpy()
            expected = is_root if name in NOT_AT_ROOTS else np.zeros_like(is_root)
            expected = ~is_root if name in ROOTS_ONLY else expected
            wrong = (missing != expected).any()
            yield f"{name} is missing, or where it can't be", wrong
    for name, words in _WORDS.items():
        strange = set(table[name].drop_null().unique().to_pylist()) - set(words)
        yield f"{name} is {', '.join(map(repr, strange))}", bool(strange)
    for name, (low, high) in _RANGES.items():
        values = table[name].drop_null().to_numpy()
        inside = ((values >= low) & (values <= high)).all()
        yield f"{name} is out of its range", not inside
    yield "its first node is no root", not is_root[:1].all()
    yield from _faults_of_trees(table, is_root)


def _faults_of_trees(
    table: pa.Table, is_root: NDArray[np.bool_]
) -> Iterator[tuple[str, bool]]:
    tree = np.cumsum(is_root) - 1
    root = np.flatnonzero(is_root)
    for name in ("orientation", "presentation"):
        own = table[name].to_numpy()
        yield f"{name} changes within a tree", (own != own[root][tree]).any()
    names = table.take(root).group_by(["orientation", "presentation"]).aggregate([])
    yield "a presentation is there twice", names.num_rows != len(root)
    edges = np.stack([tree, *(_filled(table, n) for n in ("parent", "action"))])
    edges = edges[:, ~is_root]
    twice = np.unique(edges, axis=1).shape != edges.shape
    yield "an action leads from a node to two others", twice
    shown = table.take(root)["shown"].to_pylist()
    yield "a histogram is not whole", not all(map(_is_histogram, shown))


def _is_histogram(shown: dict[str, Any]) -> bool:
    counts = shown["histogram"]
    whole = counts is not None and len(counts) == N_BINS and None not in counts
    return whole and min(counts) >= 0


def _filled(table: pa.Table, name: str) -> NDArray[np.int64]:
    return table[name].fill_null(0).to_numpy().astype(np.int64)
