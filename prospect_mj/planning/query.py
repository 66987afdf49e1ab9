"""One question to the planner, and the clearance that its answer must keep."""

from typing import NamedTuple

import numpy as np

from prospect_mj.planning.arm_body import ArmBody, Arrays
from prospect_mj.planning.arm_kernels import clearances
from prospect_mj.planning.goals import GoalSet, apart
from prospect_mj.planning.occupancy import wrist_at
from prospect_mj.planning.settings import GROSS_JOINTS, Wrist

CEILING = 0.3
"""Larger clearances are not told apart [m]."""


class Chart(NamedTuple):
    """Wrist angles that are known at some angles of shoulder and elbow."""

    gross: np.ndarray
    """(n, 4) [rad]"""
    wrists: np.ndarray
    """(n, 3) [rad]"""


class Solids(NamedTuple):
    """What is round an arm."""

    fixed: np.ndarray
    """Solids that never move (n, 18)."""
    moving: np.ndarray
    """Solids that do (m, 18)."""


class Demand(NamedTuple):
    """What is asked of a way."""

    margin: float
    """Its clearance [m]."""
    zone: float
    """Distance from an end up to which it may be as near as that end [rad]."""
    wrist: Wrist
    """How it is held, see `Attempt.wrist`."""


class Query(NamedTuple):
    """From where to where, among what, with which wrist."""

    arm: Arrays
    """Its geometry, with what it holds."""
    solids: Solids
    """What is round it."""
    rows: np.ndarray
    """The same in one array (n + m, 18)."""
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
    margin: float
    """Clearance of a way [m]."""
    zone: float
    """Distance from an end up to which a way may be as near as that end [rad]."""

    def again(self, start: np.ndarray, solids: Solids) -> "Query":
        """The same question from another start, in a world that moved.

        Args:
            start: joint angles (7,) [rad].
            solids: what is round the arm now.
        """
        rows = np.concatenate(solids)
        known = np.concatenate([start[None], self.goals])
        ends = clearances(self.arm, known, rows, CEILING)
        return self._replace(solids=solids, rows=rows, start=start, ends=ends)

    def configurations(self, gross: np.ndarray) -> np.ndarray:
        """Joint angles (n, 7) [rad] of gross joint angles (n, 4) [rad]."""
        wrists = np.empty((len(gross), 3))
        for k, wrist in enumerate(wrists):
            wrist_at(self.chart, gross, k, wrist)
        return np.hstack([gross, wrists])

    def too_near(self, points: np.ndarray) -> np.ndarray:
        """Which of points (n, 7) [rad] are nearer to something than they may be.

        They must keep the margin; near the start or a goal only as much of it as that
        has itself.
        """
        need = np.full(len(points), self.margin)
        for end, room in zip([self.start, *self.goals], self.ends, strict=True):
            if room < self.margin:
                within = np.linalg.norm(points - end, axis=1) < self.zone
                # A millimetre for what a step between two points may lose.
                need[within] = np.minimum(need[within], room - 1e-3)
        return clearances(self.arm, points, self.rows, self.margin) < need


def make_query(
    body: ArmBody,
    solids: Solids,
    start: np.ndarray,
    goal_set: GoalSet,
    demand: Demand,
) -> Query:
    """A question about one arm.

    Args:
        body: the arm, with what it holds.
        solids: what is round it.
        start: joint angles (7,) [rad].
        goal_set: where to; goals that touch something are left out, and those that are
            much like an earlier one.
        demand: what is asked of the way; all goals have its clearance if any has.
    """
    arm, rows, goals = body.arrays, np.concatenate(solids), goal_set.find()
    room = clearances(arm, goals, rows, CEILING)
    wide = room >= demand.margin
    clear = wide if wide.any() else room > 0.0
    chosen = np.flatnonzero(clear)[apart(goals[clear], goal_set.most, goal_set.spread)]
    goals, room = goals[chosen], room[chosen]
    here = clearances(arm, start[None], rows, CEILING)
    ends = np.concatenate([here, room])
    known = start, goals, ends, _chart(start, goals, demand.wrist)
    return Query(arm, solids, rows, body.reach, *known, demand.margin, demand.zone)


def _chart(start: np.ndarray, goals: np.ndarray, wrist: Wrist) -> Chart:
    known = {
        "between": np.concatenate([start[None], goals]),
        "start": start[None],
        "goal": goals,
        "straight": np.zeros((1, len(start))),
    }[wrist]
    return Chart(known[:, :GROSS_JOINTS].copy(), known[:, GROSS_JOINTS:].copy())
