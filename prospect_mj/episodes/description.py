"""What of an episode is no array, as plain numbers and words."""

from itertools import pairwise
from typing import Any

import cattrs
import numpy as np
from cattrs.preconf.json import make_converter
from numpy.typing import NDArray

from prospect_mj.actions.action import ActionOutcome, PlanOutcome
from prospect_mj.episodes.episode import (
    ActionSpan,
    ControllerSpan,
    Episode,
    LookTaken,
    PlannedPath,
    Signals,
    States,
)
from prospect_mj.sim.camera import StereoPair
from prospect_mj.sim.scene import SceneSettings
from prospect_mj.task.presentation import Presentation

_PLAIN: cattrs.Converter = make_converter(forbid_extra_keys=True)
_PLAIN.register_unstructure_hook(np.ndarray, lambda array: array.tolist())
_PLAIN.register_structure_hook(np.ndarray, lambda numbers, _: np.array(numbers, float))


def of(episode: Episode) -> dict[str, Any]:
    """Describe an episode."""
    look = episode.look
    return {
        "scene": _PLAIN.unstructure(episode.scene),
        "presentation": _PLAIN.unstructure(episode.presentation),
        "look": {
            "status": look.status,
            "position": None if look.position is None else look.position.tolist(),
            "axis": None if look.axis is None else look.axis.tolist(),
        },
        "actions": [_action(span) for span in episode.actions],
        "inserted": episode.inserted,
    }


def path_points(episode: Episode) -> NDArray[np.float32]:
    """Points (n, 7) [rad] of all planned paths, one after the other."""
    paths = [path.joints for span in episode.actions for path in span.paths]
    return np.concatenate([np.empty((0, 7), np.float32), *paths])


def episode(
    told: dict[str, Any],
    images: StereoPair,
    histogram: NDArray[np.int64],
    states: States,
    signals: Signals,
    points: NDArray[np.float32],
) -> Episode:
    """Build the episode that `of` and `path_points` have described."""
    look = told["look"]
    position, axis = (
        None if look[name] is None else np.array(look[name])
        for name in ("position", "axis")
    )
    lengths = [p["length"] for span in told["actions"] for p in span["paths"]]
    ends = np.cumsum([0, *lengths])
    if ends[-1] != len(points):
        raise ValueError("its planned paths are damaged")
    paths = iter([points[start:end] for start, end in pairwise(ends)])
    return Episode(
        scene=_PLAIN.structure(told["scene"], SceneSettings),
        presentation=_PLAIN.structure(told["presentation"], Presentation),
        look=LookTaken(images, histogram, look["status"], position, axis),
        states=states,
        signals=signals,
        actions=tuple(_span(span, paths) for span in told["actions"]),
        inserted=bool(told["inserted"]),
    )


def _action(span: ActionSpan) -> dict[str, Any]:
    outcome = span.outcome
    acted = isinstance(outcome, ActionOutcome)
    return {
        "name": span.name,
        "action": int(outcome.action) if acted else None,
        "executed": outcome.executed if acted else None,
        "result": str(outcome.result),
        "sim_seconds": outcome.sim_seconds,
        "start": span.start,
        "end": span.end,
        "controllers": _PLAIN.unstructure(span.controllers),
        "paths": [
            {"side": p.side, "start": p.start, "end": p.end, "length": len(p.joints)}
            for p in span.paths
        ],
    }


def _span(told: dict[str, Any], paths: Any) -> ActionSpan:  # noqa: ANN401
    planned = told["action"] is None
    names = () if planned else ("action", "executed")
    plain = {name: told[name] for name in (*names, "result", "sim_seconds")}
    kind = PlanOutcome if planned else ActionOutcome
    return ActionSpan(
        name=told["name"],
        outcome=_PLAIN.structure(plain | {"runs": ()}, kind),
        start=float(told["start"]),
        end=float(told["end"]),
        controllers=_PLAIN.structure(told["controllers"], tuple[ControllerSpan, ...]),
        paths=tuple(
            PlannedPath(p["side"], p["start"], p["end"], next(paths))
            for p in told["paths"]
        ),
    )
