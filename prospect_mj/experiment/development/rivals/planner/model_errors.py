"""What backward chaining comes to whose model is slightly wrong, on recorded outcomes.

The error is in a size that it believes, or in the side of the lid.
"""

from collections.abc import Iterator

import numpy as np
import pyarrow as pa

from prospect_mj.agent.failed_actions import RULES, FailedActions
from prospect_mj.experiment.development.rivals.planner.execution import (
    Belief,
    Executed,
    carry_out,
    costs,
)
from prospect_mj.experiment.development.rivals.planner.geometry import (
    Geometry,
    SizeError,
)
from prospect_mj.experiment.development.rivals.settings import RivalSettings
from prospect_mj.recording.hands import hand_of
from prospect_mj.recording.recording import Recording
from prospect_mj.robot.names import other

WIDTH, LID, FLIP = "half width of the receptacle", "radius of the lid", "side of lid"
KINDS = (WIDTH, LID, FLIP)

ERRORS = pa.schema(
    {
        "kind": pa.string(),
        "error": pa.float64(),
        "failed_actions": pa.string(),
        "trials": pa.int32(),
        "actions": pa.float64(),
        "failures": pa.float64(),
    }
)
"""By error [mm], or probability of the lid's other side [1], and rule for failed
actions: mean actions of a trial, and the share of trials that were not solved."""

_FLIPS = 4
"""Trials of each presentation for each probability of a flip."""


def believed(
    recording: Recording, settings: RivalSettings, max_actions: int
) -> pa.Table:
    """Backward chaining with wrong beliefs, in every complete presentation.

    Args:
        recording: the outcomes.
        settings: which errors.
        max_actions: trials are cut off after so many.
    """
    shown = recording.complete(max_actions)
    rows = []
    for kind, error, size, flip in _errors(settings):
        for rule in RULES:
            # The same chances for every error, so that the errors alone differ.
            rng = np.random.default_rng([settings.seed, KINDS.index(kind)])
            repeats = _FLIPS if kind == FLIP else 1
            # One for all trials: what a hand reaches is asked once.
            geometry = Geometry(size)
            trials = [
                _trial(recording, number, geometry, flip, rule, rng, max_actions)
                for number in np.tile(shown, repeats)
            ]
            head = {"kind": kind, "error": error, "failed_actions": rule}
            rows.append(head | _told(trials, max_actions))
    return pa.Table.from_pylist(rows, schema=ERRORS)


def _errors(settings: RivalSettings) -> Iterator[tuple[str, float, SizeError, float]]:
    """Kind and amount of each error, as an error of sizes and as one of the side."""
    for millimetres in settings.size_errors:
        metres = millimetres / 1000
        yield WIDTH, millimetres, SizeError(half_width=metres), 0.0
        yield LID, millimetres, SizeError(lid_radius=metres), 0.0
    for flip in settings.flips:
        yield FLIP, flip, SizeError(), flip


def _trial(
    recording: Recording,
    number: int,
    geometry: Geometry,
    flip: float,
    rule: FailedActions,
    rng: np.random.Generator,
    max_actions: int,
) -> Executed:
    shown = recording.presentations
    lid = hand_of(int(shown.lid[number]))
    if rng.random() < flip:
        lid = other(lid)
    root, belief = int(shown.root[number]), Belief(lid, rule)
    return carry_out(recording, root, belief, geometry, rng, max_actions)


def _told(trials: list[Executed], max_actions: int) -> dict[str, object]:
    actions = costs(trials, max_actions)
    solved = np.array([trial.inserted for trial in trials])
    return {
        "trials": len(trials),
        "actions": float(actions.mean()),
        "failures": float(1 - solved.mean()),
    }
