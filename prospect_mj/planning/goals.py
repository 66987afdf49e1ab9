"""Goal configurations: several ways in which an arm can hold its hand at one pose."""

import mink
import numpy as np

from prospect_mj.robot import wam_ik
from prospect_mj.robot.names import Side

_SWIVELS = np.linspace(-np.pi, np.pi, 24, endpoint=False)
_ROLLS = np.array([0.0, -0.35, 0.35, -0.7, 0.7, -1.2, 1.2, -2.0, 2.0, np.pi])
"""Turns about the palm's axis, those near the wanted one closer together [rad]."""
_APART = 0.5
"""Two goals nearer to each other than this are one [rad]."""


def goals(
    side: Side,
    pose: mink.SE3,
    reference: np.ndarray,
    free_roll: bool,
    margin: float,
    most: int,
) -> np.ndarray:
    """Joint angles that put a hand's grasp site at a pose, the most natural first.

    Args:
        side: the arm.
        pose: in the world.
        reference: joint angles (7,) [rad]; the nearer to these, the more natural.
        free_roll: whether the hand may be turned about the palm's axis.
        margin: kept from every joint limit [rad].
        most: how many to return.

    Returns:
        Joint angles (n, 7) [rad], n <= `most`, all apart from each other; none if the
        pose is out of reach.
    """
    turn = pose.rotation().as_matrix()
    rolls = _ROLLS if free_roll else _ROLLS[:1]
    found = wam_ik.solutions_free_roll(
        side, pose.translation(), turn, _SWIVELS, rolls, margin
    )
    order = np.argsort(np.linalg.norm(found - reference, axis=1), kind="stable")
    return _thinned(found[order], most)


def _thinned(candidates: np.ndarray, most: int) -> np.ndarray:
    """The first `most` (n, 7) of candidates (m, 7) that are apart from each other."""
    chosen = np.empty((0, candidates.shape[1]))
    left = candidates
    while len(left) and len(chosen) < most:
        chosen = np.vstack([chosen, left[:1]])
        left = left[np.linalg.norm(left - left[0], axis=1) > _APART]
    return chosen
