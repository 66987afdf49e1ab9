"""Search in live physics whose receptacle is slightly too wide or too narrow.

Its plan is carried out where it was recorded what happens in the world.
"""

from collections.abc import Iterator
from dataclasses import replace

import pyarrow as pa

from prospect_mj.experiment.development.rivals.planner.clock import Clock
from prospect_mj.experiment.development.rivals.planner.search import (
    breadth_first,
    tried_out,
)
from prospect_mj.experiment.development.rivals.planner.simulators import (
    LiveSimulator,
    RecordedSimulator,
    first_presentations,
)
from prospect_mj.experiment.development.rivals.settings import RivalSettings
from prospect_mj.recording.grower import task_settings
from prospect_mj.recording.hands import hand_of
from prospect_mj.recording.recording import Recording
from prospect_mj.task.pick_place import PickPlaceTask, TaskSettings

WRONG = pa.schema(
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
"""By error [mm] of the searched physics: the plan, empty where there is none; whether
it inserts the jar in the world; its actions, all that a trial may have where it
doesn't; and what the search took."""


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
    for error in settings.live_errors:
        with PickPlaceTask(_wrong(recording, error / 1000)) as task:
            for row in _rows(recording, task, settings.depth, max_actions):
                rows.append({"error": error} | row)
    return pa.Table.from_pylist(rows, schema=WRONG)


def _wrong(recording: Recording, wider: float) -> TaskSettings:
    """The recording's physics with another receptacle; `wider` is of half of it [m]."""
    settings = task_settings(recording.key.config)
    props = settings.scene.props
    well = replace(props.well, half_width=props.well.half_width + wider)
    scene = replace(settings.scene, props=replace(props, well=well))
    return replace(settings, scene=scene)


def _rows(
    recording: Recording, task: PickPlaceTask, depth: int, max_actions: int
) -> Iterator[dict[str, object]]:
    """The search of the first presentation of each orientation."""
    simulator, shown = LiveSimulator(task), recording.presentations
    for number in first_presentations(recording, 1):
        start, clock = simulator.present(recording, number), Clock()
        found, spent = breadth_first(simulator, start, depth), clock.spent
        plan = found.actions or ()
        real = tried_out(RecordedSimulator(recording), int(shown.root[number]), plan)
        inserted = real.actions is not None
        yield {
            "orientation": hand_of(int(shown.lid[number])),
            "plan": ", ".join(action.label for action in plan),
            "inserted": inserted,
            "actions": len(plan) if inserted else max_actions,
            "simulated": found.simulated,
            "sim_seconds": found.sim_seconds,
            "wall_seconds": spent.wall,
            "processor_seconds": spent.processor,
        }
