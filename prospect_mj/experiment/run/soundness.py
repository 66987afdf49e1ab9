"""Whether the tables of a run can be true; a right mark alone doesn't make them so."""

from collections.abc import Iterator
from pathlib import Path
from typing import get_args

import numpy as np
import pyarrow as pa
import pyarrow.compute as pc

from prospect_mj.agent.features import Holding
from prospect_mj.errors import RunFolderError
from prospect_mj.experiment.run.records import ACTION_NAMES
from prospect_mj.task.presentation import ORIENTATIONS

_WORDS = {
    "orientation": ORIENTATIONS,
    "action_name": ACTION_NAMES,
    "holding": get_args(Holding),
    "next_holding": get_args(Holding),
}
"""Columns of words, and those that there are."""
_FINITE = ("q_values", "reward", "sim_seconds")


def check(path: Path, table: pa.Table) -> None:
    """Refuse a table of actions or trials that no run has.

    Args:
        path: its file, for the message.
        table: under one of the schemas of `records`.

    Raises:
        RunFolderError: with the first thing that can't be.
    """
    for wrong in _faults(table):
        raise RunFolderError(f"{path} is damaged: {wrong}")


def _faults(table: pa.Table) -> Iterator[str]:
    """What is wrong, in words; later ones rely on the earlier."""
    columns = {name: table[name].combine_chunks() for name in table.column_names}
    for name, column in columns.items():
        # Of a list both its rows and its numbers can lack.
        is_list = pa.types.is_fixed_size_list(column.type)
        numbers = column.flatten() if is_list else column
        if column.null_count or numbers.null_count:
            yield f"{name} is missing in some rows"
        if name in _FINITE and not np.isfinite(numbers.to_numpy()).all():
            yield f"{name} is no finite number in some rows"
        if name in _WORDS:
            known = pc.is_in(column, pa.array(_WORDS[name]))
            for word in column.filter(pc.invert(known))[:1].to_pylist():
                yield f"{name} is {word!r}; valid: {', '.join(_WORDS[name])}"
    if "step" in columns:
        yield from _faults_of_order(columns)


def _faults_of_order(columns: dict[str, pa.Array]) -> Iterator[str]:
    """Trials come one after the other, and the actions of each in order."""
    trial, step, action = (
        columns[name].to_numpy() for name in ("trial", "step", "action")
    )
    if ((action < 0) | (action >= len(ACTION_NAMES))).any():
        yield f"action is not always from 0 to {len(ACTION_NAMES) - 1}"
    begins = step == 0
    follows = (np.diff(trial) == 0) & (np.diff(step) == 1)
    next_one = (np.diff(trial) == 1) & begins[1:]
    if trial.size and not (begins[0] and trial[0] == 0 and (follows | next_one).all()):
        yield "its steps are out of order"
