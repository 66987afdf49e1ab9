"""What a planner comes to whose model is slightly wrong, carried out in the real world.

"Real" is what was recorded. Two planners: backward chaining, with an error in a size
that it believes or in the side of the lid; and blind search in live physics in which
the receptacle is built slightly too wide or too narrow.
"""

from collections.abc import Iterator
from dataclasses import replace
from typing import get_args

import numpy as np
import pyarrow as pa

from prospect_mj.agent.failed_actions import FailedActions
from prospect_mj.experiment.development.rivals.planner.clock import Clock
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
from prospect_mj.experiment.development.rivals.planner.search import (
    Found,
    breadth_first,
)
from prospect_mj.experiment.development.rivals.planner.simulators import LiveSimulator
from prospect_mj.experiment.development.rivals.settings import RivalSettings
from prospect_mj.recording.grower import presentation_rng, task_settings
from prospect_mj.recording.hands import NUMBERS, hand_of
from prospect_mj.recording.recording import Recording
from prospect_mj.robot.names import other
from prospect_mj.task.pick_place import PickPlaceTask, TaskSettings
from prospect_mj.task.presentation import ORIENTATIONS

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
LIVE = pa.schema(
    {
        "error": pa.float64(),
        "orientation": pa.string(),
        "plan": pa.string(),
        "inserted": pa.bool_(),
        "actions": pa.int32(),
        "simulated": pa.int32(),
        "sim_seconds": pa.float64(),
        "wall_seconds": pa.float64(),
        "processor_seconds": pa.float64(),
    }
)
"""By error [mm] of the searched physics: the plan, whether it does in the real world
what it did there, its actions, and what the search took."""

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
        for rule in get_args(FailedActions):
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


def searched(
    recording: Recording, settings: RivalSettings, max_actions: int
) -> pa.Table:
    """Search in live physics with a wrong receptacle, and act as it says.

    Args:
        recording: the outcomes of the real world, and its presentations.
        settings: which errors.
        max_actions: what a trial takes that was not solved.

    Raises:
        RenderingUnavailable: if there is no OpenGL.
    """
    rows = []
    for millimetres in settings.live_errors:
        with PickPlaceTask(_wrong(recording, millimetres / 1000)) as task:
            rows += _rows(recording, task, millimetres, settings.depth, max_actions)
    return pa.Table.from_pylist(rows, schema=LIVE)


def _wrong(recording: Recording, wider: float) -> TaskSettings:
    """The recording's physics with another receptacle; `wider` is of half of it [m]."""
    settings = task_settings(recording.key.config)
    props = settings.scene.props
    well = replace(props.well, half_width=props.well.half_width + wider)
    scene = replace(settings.scene, props=replace(props, well=well))
    return replace(settings, scene=scene)


def _rows(
    recording: Recording,
    task: PickPlaceTask,
    millimetres: float,
    depth: int,
    max_actions: int,
) -> Iterator[dict[str, object]]:
    simulator, shown = LiveSimulator(task), recording.presentations
    for orientation in ORIENTATIONS:
        number = int(np.flatnonzero(shown.lid == NUMBERS[orientation])[0])
        config, own = recording.key.config, int(shown.number[number])
        rng = presentation_rng(config, orientation, own)
        start, clock = simulator.begin(orientation, rng), Clock()
        found, spent = breadth_first(simulator, start, depth), clock.spent
        inserted = _inserts(recording, int(shown.root[number]), found)
        yield {
            "error": millimetres,
            "orientation": orientation,
            "plan": ", ".join(action.label for action in found.actions or ()),
            "inserted": inserted,
            "actions": len(found.actions) if inserted else max_actions,
            "simulated": found.simulated,
            "sim_seconds": found.sim_seconds,
            "wall_seconds": spent.wall,
            "processor_seconds": spent.processor,
        }


def _inserts(recording: Recording, root: int, found: Found) -> bool:
    """Whether a plan's last action leaves the jar in the real receptacle."""
    node, inserted = root, False
    for action in found.actions or ():
        led_to = int(recording.nodes.child[node, action])
        node, inserted = (
            int(recording.nodes.situation[led_to]),
            bool(recording.nodes.inserted[led_to]),
        )
    return inserted
