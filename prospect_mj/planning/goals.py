"""Goal configurations: several ways in which an arm can hold its hand at one pose."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import mink
import numpy as np

from prospect_mj.robot import wam_ik
from prospect_mj.robot.names import Side

_APART = 0.5
"""Two goals nearer to each other than this are one [rad]."""


class GoalSet(NamedTuple):
    """Goals that are found when they are first needed."""

    find: Callable[[], np.ndarray]
    """Tells joint angles (n, 7) [rad], the preferred ones first."""
    most: int = 1
    """Of those that are clear, how many to plan for."""
    spread: float = np.inf
    """Distance from the first of them within which they lie [rad]."""


@dataclass(frozen=True)
class GoalSearch:
    """How thoroughly the arm's redundancy is searched."""

    swivels: int
    """Of the elbow, over a whole turn."""
    rolls: int
    """Of the hand about the palm's axis, over a whole turn."""
    limit_margin: float
    """Kept from every joint limit [rad]."""
    most: int
    """Goals to plan for."""
    spread: float
    """Distance from the most natural one within which they lie [rad]."""


NATURAL = GoalSearch(swivels=24, rolls=24, limit_margin=0.1, most=6, spread=1.0)
"""Some, not too near to the joint limits for the fine motion that follows."""
THOROUGH = GoalSearch(swivels=96, rolls=36, limit_margin=0.04, most=24, spread=np.inf)
"""Whatever there is."""


def goals(
    side: Side,
    pose: mink.SE3,
    start: np.ndarray,
    reference: np.ndarray,
    free_roll: bool,
    how: GoalSearch = NATURAL,
) -> np.ndarray:
    """Joint angles that put a hand's grasp site at a pose, the most natural first.

    Args:
        side: the arm.
        pose: in the world.
        start: joint angles (7,) [rad] of the arm now.
        reference: joint angles (7,) [rad] as in the work to be done there; the nearer
            to both, the more natural.
        free_roll: whether the hand may be turned about the palm's axis.
        how: how thoroughly to search.

    Returns:
        Joint angles (n, 7) [rad]; none if the pose is out of reach.
    """
    turn = pose.rotation().as_matrix()
    swivels = _whole_turn(how.swivels)
    rolls = _whole_turn(how.rolls) if free_roll else np.zeros(1)
    found = wam_ik.solutions_free_roll(
        side, pose.translation(), turn, swivels, rolls, how.limit_margin
    )
    away = np.linalg.norm(found - reference, axis=1)
    away += np.linalg.norm(found - start, axis=1)
    return found[np.argsort(away, kind="stable")]


def _whole_turn(n: int) -> np.ndarray:
    return np.linspace(-np.pi, np.pi, n, endpoint=False)


def apart(candidates: np.ndarray, most: int, spread: float) -> list[int]:
    """Numbers of the first few of candidates (n, 7) that differ from each other.

    Args:
        candidates: joint angles (n, 7) [rad].
        most: how many.
        spread: distance from the first one within which they lie [rad].
    """
    chosen: list[int] = []
    near = np.linalg.norm(candidates - candidates[:1], axis=1) <= spread
    left = np.flatnonzero(near)
    while len(left) and len(chosen) < most:
        chosen.append(int(left[0]))
        away = np.linalg.norm(candidates[left] - candidates[left[0]], axis=1)
        left = left[away > _APART]
    return chosen
