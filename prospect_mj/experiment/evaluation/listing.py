"""Single trials of an evaluation, each with the command that replays it."""

import shlex
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from prospect_mj.experiment.view.run_view import RunView


@dataclass(frozen=True)
class Listed:
    """One trial."""

    trial: int
    """Its number."""
    orientation: str
    """Side on which the lid lay."""
    actions: tuple[str, ...]
    """What was done, with its result where that was no success."""
    replay: str
    """The command that replays it."""


def listed(view: RunView, chosen: NDArray[np.bool_]) -> tuple[Listed, ...]:
    """List trials.

    Args:
        view: they are in it.
        chosen: (n,), which of its trials.
    """
    sides = view.trials["orientation"]
    return tuple(
        Listed(trial, str(sides[trial]), _actions(view, trial), _command(view, trial))
        for trial in map(int, np.flatnonzero(chosen))
    )


def _actions(view: RunView, trial: int) -> tuple[str, ...]:
    rows = view.actions_of(trial).to_pylist()
    return tuple(_words(row["action_name"], row["result"]) for row in rows)


def _words(action: str, result: str) -> str:
    return action if result == "success" else f"{action} ({result})"


def _command(view: RunView, trial: int) -> str:
    return f"prospect replay {shlex.quote(str(view.path))} --trial {trial}"
