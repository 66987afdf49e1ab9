"""What a decision costs: queries and seconds of a planner, one product of a learner."""

from collections.abc import Callable
from functools import partial

import numpy as np
import pyarrow as pa

from prospect_mj.agent import LinearQ, Observation
from prospect_mj.agent.features import StateFeatureGenerator
from prospect_mj.experiment.development.rivals.planner.clock import Clock, Spent
from prospect_mj.experiment.development.rivals.planner.facts import presented
from prospect_mj.experiment.development.rivals.planner.geometry import Geometry
from prospect_mj.experiment.development.rivals.planner.regression import Plan, plan
from prospect_mj.experiment.development.rivals.planner.search import (
    SearchResult,
    backward,
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
from prospect_mj.task.pick_place import PickPlaceTask

PRICES = pa.schema(
    {
        "method": pa.string(),
        "trials": pa.int32(),
        "actions": pa.float64(),
        "steps": pa.float64(),
        "queries": pa.float64(),
        "simulated": pa.float64(),
        "sim_seconds": pa.float64(),
        "motion_plans": pa.float64(),
        "ik_solutions": pa.float64(),
        "wall_seconds": pa.float64(),
        "processor_seconds": pa.float64(),
    }
)
"""Means over trials: actions of the plan; goals taken back through an operator, or
situations expanded; questions to geometry; actions that were run in the exact model,
and their simulated time [s]; large movements that were planned for them, and inverse
kinematics solved; wall and processor time [s]. Null where there is no such thing."""

LEARNER = "the learner: one product of features and weights"
CHAINING = "backward chaining over the geometric model"
VERIFIED = "the same, its plan tried out in live physics"
BLIND_LIVE = "search in live physics, breadth first"
BLIND = "search in the recorded tree, breadth first"
WHOLE = "backward chaining over the recorded tree, all of it known"

_DECISIONS = 2000


def prices(
    recording: Recording, settings: RivalSettings, max_actions: int, live: pa.Table
) -> pa.Table:
    """What the first decision of a trial costs, by method.

    Args:
        recording: presentations and outcomes.
        settings: how deep is searched.
        max_actions: for which presentations must be complete.
        live: the rows of live physics, which are made on their own.
    """
    shown = recording.complete(max_actions)
    rows = [_decision(recording)]
    rows.append(_mean(CHAINING, [_chained(recording, n) for n in shown]))
    rows += live.to_pylist()
    rows.append(_mean(BLIND, [_blind(recording, n, settings.depth) for n in shown]))
    rows.append(_mean(WHOLE, [_whole(recording, n) for n in shown]))
    return pa.Table.from_pylist(rows, schema=PRICES)


def live_prices(recording: Recording, settings: RivalSettings) -> pa.Table:
    """The rows of live physics: a plan tried out, and the blind search.

    Args:
        recording: presentations.
        settings: in how many of them, and how deep is searched.

    Raises:
        RenderingUnavailable: if there is no OpenGL.
    """
    verified, blind = [], []
    with PickPlaceTask(task_settings(recording.key.config)) as task:
        simulator = LiveSimulator(task)
        numbers = first_presentations(recording, settings.live_presentations)
        # Compiled code and maps are loaded when they are first asked for.
        _verified(recording, simulator, numbers[0])
        for number in numbers:
            verified.append(_verified(recording, simulator, number))
            start = simulator.present(recording, number)
            search = partial(breadth_first, simulator, start, settings.depth)
            blind.append(_searched(search) | _counted(simulator))
    rows = [_mean(VERIFIED, verified), _mean(BLIND_LIVE, blind)]
    return pa.Table.from_pylist(rows, schema=PRICES)


def _mean(method: str, trials: list[dict[str, float]]) -> dict[str, object]:
    means = {name: float(np.mean([one[name] for one in trials])) for name in trials[0]}
    return {"method": method, "trials": len(trials), **means}


def _decision(recording: Recording) -> dict[str, object]:
    """The learner's six values, from a histogram that was seen."""
    histogram = recording.presentations.histogram[0].astype(np.float64)
    features = StateFeatureGenerator().generate(histogram, "none")
    observation = Observation.of(features, 0)
    learner = LinearQ(rng=np.random.default_rng(0))
    learner.q_values(observation)
    clock = Clock()
    for _ in range(_DECISIONS):
        learner.q_values(observation)
    spent = Spent(*(seconds / _DECISIONS for seconds in clock.spent))
    return {"method": LEARNER, "trials": _DECISIONS, **_seconds(spent)}


def _chained(recording: Recording, number: int) -> dict[str, float]:
    """Backward chaining that knows on which side the lid lies."""
    clock = Clock()
    made = _planned(recording, number)
    spent = clock.spent
    return {"actions": len(made.actions), **_asked(made), **_seconds(spent)}


def _planned(recording: Recording, number: int) -> Plan:
    lid = hand_of(int(recording.presentations.lid[number]))
    return plan(presented(lid), Geometry(), np.random.default_rng(number))


def _asked(made: Plan) -> dict[str, float]:
    return {"steps": made.regressions, "queries": made.queries}


def _seconds(spent: Spent) -> dict[str, float]:
    return {"wall_seconds": spent.wall, "processor_seconds": spent.processor}


def _blind(recording: Recording, number: int, depth: int) -> dict[str, float]:
    root = int(recording.presentations.root[number])
    simulator = RecordedSimulator(recording)
    return _searched(lambda: breadth_first(simulator, root, depth))


def _whole(recording: Recording, number: int) -> dict[str, float]:
    return _searched(lambda: backward(recording, number))


def _searched(search: Callable[[], SearchResult]) -> dict[str, float]:
    clock = Clock()
    found = search()
    spent = clock.spent
    return _found(found) | {"steps": found.expanded} | _seconds(spent)


def _found(found: SearchResult) -> dict[str, float]:
    return {
        "actions": np.nan if found.actions is None else len(found.actions),
        "simulated": found.simulated,
        "sim_seconds": found.sim_seconds,
    }


def _verified(
    recording: Recording, simulator: LiveSimulator, number: int
) -> dict[str, float]:
    start = simulator.present(recording, number)
    clock = Clock()
    made = _planned(recording, number)
    found = tried_out(simulator, start, made.actions)
    spent = clock.spent
    return _found(found) | _asked(made) | _seconds(spent) | _counted(simulator)


def _counted(simulator: LiveSimulator) -> dict[str, float]:
    return {
        "motion_plans": simulator.motion_plans,
        "ik_solutions": simulator.ik_solutions,
    }
