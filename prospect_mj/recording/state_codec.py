"""The state of a trial as a row of plain numbers, bit for bit."""

from typing import Any

import mink
import numpy as np

from prospect_mj.actions.belief import Belief, SeenJar
from prospect_mj.robot.names import SIDES
from prospect_mj.supervisor.predicates import PredicateState
from prospect_mj.task.trial_state import TrialState


def state_row(state: TrialState) -> dict[str, Any]:
    """A state as a row under `schema.STATE`."""
    belief = state.belief
    return {
        "physics": state.physics,
        "seen": _seen_numbers(belief.seen),
        "cradle": _seen_numbers(belief.cradle),
        "inserted": _pose_numbers(belief.inserted),
        **{f"held_{side}": _pose_numbers(belief.held.get(side)) for side in SIDES},
    }


def state_of_row(row: dict[str, Any], predicates: PredicateState) -> TrialState:
    """The state that `state_row` has made a row of."""
    held = {
        side: mink.SE3(np.array(numbers))
        for side in SIDES
        if (numbers := row[f"held_{side}"]) is not None
    }
    standing = row["inserted"]
    belief = Belief(
        seen=_seen(row["seen"]),
        cradle=_seen(row["cradle"]),
        inserted=None if standing is None else mink.SE3(np.array(standing)),
        held=held,
    )
    return TrialState(np.array(row["physics"]), belief, predicates)


def _seen_numbers(seen: SeenJar | None) -> np.ndarray | None:
    return None if seen is None else np.concatenate([seen.position, seen.axis])


def _pose_numbers(pose: mink.SE3 | None) -> np.ndarray | None:
    return None if pose is None else pose.wxyz_xyz


def _seen(numbers: list[float] | None) -> SeenJar | None:
    if numbers is None:
        return None
    return SeenJar(np.array(numbers[:3]), np.array(numbers[3:]))
