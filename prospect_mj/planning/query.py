"""One question to the planner, and the clearance that its answer must keep."""

from typing import NamedTuple

import numpy as np

from prospect_mj.planning.arm_body import GROSS_JOINTS, HAND, ArmBody
from prospect_mj.planning.clearance import (
    Arrays,
    Chart,
    arrays,
    clearances,
    wrist_at,
)

CEILING = 0.3
"""Larger clearances are not told apart [m]."""


class Query(NamedTuple):
    """From where to where, among what, with which wrist."""

    arm: Arrays
    fixed: np.ndarray
    """Solids that never move (n, 18)."""
    moving: np.ndarray
    """Solids that do (m, 18)."""
    rows: np.ndarray
    """Both (n + m, 18)."""
    reach: float
    """Of hand and jar from the wrist's centre [m]."""
    start: np.ndarray
    """Joint angles (7,) [rad]."""
    goals: np.ndarray
    """Joint angles (k, 7) [rad], clear of everything."""
    ends: np.ndarray
    """Clearance of the start and of the goals (1 + k,) [m]."""
    chart: Chart
    """The wrist everywhere, from those of the start and of the goals."""

    def configurations(self, gross: np.ndarray) -> np.ndarray:
        """Joint angles (n, 7) [rad] of gross joint angles (n, 4) [rad]."""
        wrists = np.empty((len(gross), 3))
        for row, wrist in zip(gross, wrists, strict=True):
            wrist_at(self.chart, row, wrist)
        return np.hstack([gross, wrists])

    def too_near(
        self, path: np.ndarray, goal: int, margin: float, zone: float
    ) -> np.ndarray:
        """Which points of a path are nearer to something than they may be.

        Args:
            path: joint angles (n, 7) [rad] that end at a goal.
            goal: number of this goal.
            margin: clearance to keep [m]; within `zone` of an end only as much of it
                as the end itself has.
            zone: [rad].
        """
        need = np.full(len(path), margin)
        for end, room in ((path[0], self.ends[0]), (path[-1], self.ends[1 + goal])):
            within = np.linalg.norm(path - end, axis=1) < zone
            # A millimetre for what a step between two points may lose.
            need[within] = np.minimum(need[within], room - 1e-3)
        return clearances(self.arm, path, self.rows, margin) < need


def make_query(
    body: ArmBody,
    fixed: np.ndarray,
    moving: np.ndarray,
    start: np.ndarray,
    goals: np.ndarray,
) -> Query:
    """A question about one arm.

    Args:
        body: the arm, with what it holds.
        fixed: solids that never move (n, 18).
        moving: solids that do (m, 18).
        start: joint angles (7,) [rad].
        goals: joint angles (k, 7) [rad]; those that touch something are left out.
    """
    arm, rows = arrays(body), np.concatenate([fixed, moving])
    room = clearances(arm, goals, rows, CEILING)
    goals, room = goals[room > 0.0], room[room > 0.0]
    known = np.concatenate([start[None], goals])
    chart = Chart(known[:, :GROSS_JOINTS].copy(), known[:, GROSS_JOINTS:].copy())
    here = clearances(arm, start[None], rows, CEILING)
    beyond = body.spheres[body.first[HAND] :]
    reach = (np.linalg.norm(beyond[:, :3], axis=1) + beyond[:, 3]).max()
    ends = np.concatenate([here, room])
    return Query(arm, fixed, moving, rows, reach, start, goals, ends, chart)
