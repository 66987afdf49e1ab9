"""Whether a table of nodes is one that recording could have made.

Files carry checksums; this is for tables that are whole, and make no sense. Its columns
are held against the schema here, what they say of a trial in `soundness_of_trees`.
"""

from collections.abc import Iterator
from enum import StrEnum
from pathlib import Path
from typing import Any, get_args

import numpy as np
import pyarrow as pa
import pyarrow.compute as pc
from numpy.typing import NDArray

from prospect_mj.actions.action import Action, ActionResult
from prospect_mj.agent.features import N_BINS
from prospect_mj.errors import RecordingError
from prospect_mj.recording import soundness_of_trees
from prospect_mj.recording.schema import NOT_AT_ROOTS, ROOTS_ONLY, STATE
from prospect_mj.supervisor.predicates import Jar, Place
from prospect_mj.task.presentation import ORIENTATIONS
from prospect_mj.vision.look import Status

Faults = Iterator[tuple[str, bool]]
"""What may be wrong, and whether it is; each may rely on those before it."""

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
_LENGTHS = {"seen": 6, "cradle": 6, "inserted": 7, "held_left": 7, "held_right": 7}
"""Numbers in each part of a state but MuJoCo's own."""


def check(table: pa.Table, path: Path) -> None:
    """Refuse a table that makes no sense.

    Args:
        table: under `schema.SCHEMA`, with or without the states; trees one after the
            other.
        path: its file.

    Raises:
        RecordingError: with what is wrong.
    """
    for wrong, is_so in _faults(table):
        if is_so:
            raise RecordingError(f"{path} is damaged: {wrong}")


def _faults(table: pa.Table) -> Faults:
    yield "it holds no tree", not table.num_rows
    is_root = pc.fill_null(pc.equal(table["node"], 0), False).to_numpy()
    yield "its first node is no root", not is_root[0]
    for name in table.column_names:
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
    yield from _faults_of_shown(table["shown"].drop_null().to_pylist())
    yield from _faults_of_felt(table["felt"].combine_chunks().flatten())
    if "state" in table.column_names:
        yield from _faults_of_states(table["state"].drop_null().combine_chunks())
    yield from soundness_of_trees.faults(table, is_root)


def _faults_of_shown(shown: list[dict[str, Any]]) -> Faults:
    strange = {str(root["look"]) for root in shown} - set(get_args(Status))
    yield f"look is {', '.join(map(repr, strange))}", bool(strange)
    numbers = [[root["yaw"], root["lamp_gain"], root["position"]] for root in shown]
    whole = all(position is not None for *_, position in numbers)
    yield "a presentation is not whole", not whole
    flat = [[*row[:-1], *row[-1]] for row in numbers]
    yield "a presentation is not whole", not np.isfinite(np.array(flat, float)).all()
    whole = all(_is_histogram(root["histogram"]) for root in shown)
    yield "a histogram is not whole", not whole


def _is_histogram(counts: list[int | None] | None) -> bool:
    whole = counts is not None and len(counts) == N_BINS and None not in counts
    return whole and min(counts) >= 0


def _faults_of_felt(samples: pa.StructArray) -> Faults:
    whole = not samples.null_count
    yield "a grasp's trajectory is not whole", not whole
    for field in samples.flatten():
        sound = not field.null_count and (field.to_numpy() >= 0).all()
        yield "a grasp's trajectory is not one of numbers", not sound


def _faults_of_states(states: pa.StructArray) -> Faults:
    lengths = {field.name: _lengths(states.field(field.name)) for field in STATE}
    physics = lengths.pop("physics")
    whole = len(physics) == len(states) and len(set(physics)) <= 1 and all(physics)
    yield "the physics of a state is not whole", not whole
    for name, found in lengths.items():
        yield f"{name} of a state is not whole", bool(set(found) - {_LENGTHS[name]})
    for field in STATE:
        numbers = states.field(field.name).flatten()
        finite = not numbers.null_count and np.isfinite(numbers.to_numpy()).all()
        yield f"{field.name} of a state is not finite", not finite


def _lengths(lists: pa.ListArray) -> NDArray[np.int64]:
    """Of those that are there."""
    return pc.list_value_length(lists).drop_null().to_numpy()
