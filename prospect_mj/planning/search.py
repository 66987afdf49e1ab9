"""The search for a way on one grid: solve, walk the streamline, close what touches."""

from collections.abc import Iterator
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from prospect_mj.planning.gross_plan import Cell, GrossPlan
from prospect_mj.planning.harmonic_field import HarmonicField, harmonic_field
from prospect_mj.planning.joint_grid import JointGrid
from prospect_mj.planning.occupancy import free_cells
from prospect_mj.planning.query import Query
from prospect_mj.planning.settings import GROSS_JOINTS, Attempt, PlannerSettings
from prospect_mj.planning.sight import cells_in_sight, line, subdivided
from prospect_mj.planning.static_map import shoulders_and_elbows
from prospect_mj.planning.streamline import streamline

_MOST_ENTRIES = 6
"""Cells near the start that are tried besides the start itself."""
_LONGEST = 60.0
"""Streamlines that are longer are given up [rad]."""


class Map(NamedTuple):
    """The static part of planning on one grid."""

    grid: JointGrid
    """Of the gross joints."""
    room: np.ndarray
    """Result of `static_map.static_room` (m, n) [m]."""


class Way(NamedTuple):
    """A way along a streamline, in the words of `GrossPlan`."""

    path: np.ndarray
    """Joint angles (n, 7) [rad], from the start to one of the goals."""
    goal: int
    """Number of this goal."""
    last_stretch: float
    """Arc length of the straight way from the goal cell to the goal [rad]."""


def straight(query: Query, settings: PlannerSettings) -> GrossPlan | None:
    """The straight way to a goal that is near, if it is clear."""
    away = np.linalg.norm(query.goals - query.start, axis=1)
    for goal in np.argsort(away, kind="stable"):
        if away[goal] > settings.straight:
            break
        way = line(query.start, query.goals[goal], settings.step)
        if not query.too_near(way).any():
            return GrossPlan(query, way, int(goal), away[goal])
    return None


def resumed(
    plan: GrossPlan, query: Query, settings: PlannerSettings
) -> GrossPlan | None:
    """The way of a plan from another start in another world, if it is still clear."""
    if plan.field is None:
        return straight(query, settings)
    if plan.length_left(query.start) < plan.last_stretch + settings.step:
        # Past the goal cell: a streamline from here may well lead to another goal.
        way = line(query.start, query.goals[plan.goal], settings.step)
        if not query.too_near(way).any():
            return replace(plan, query=query, path=way)
    for way in ways(query, plan.field, plan.goal_of, np.empty((0, 4)), settings):
        if not query.too_near(way.path).any():
            return replace(plan, query=query, **way._asdict())
    return None


def search(
    query: Query, static: Map, attempt: Attempt, settings: PlannerSettings
) -> GrossPlan | None:
    """A way from the start to one of the goals, if this grid shows one.

    The harmonic function leads past everything that fills a cell's centre. What lies
    between centres is found by walking its streamline with the arm's own geometry: the
    cell where that comes too near to something is closed, and the function is solved
    again.
    """
    return _Search(query, static, attempt, settings).run()


def ways(
    query: Query,
    field: HarmonicField,
    goal_of: dict[Cell, int],
    entries: np.ndarray,
    settings: PlannerSettings,
) -> Iterator[Way]:
    """Ways along streamlines to a goal.

    The first begins at the start itself; others go straight to one of
    some entries (k, 4) [rad] first.
    """
    for begin in [query.start[:GROSS_JOINTS], *entries]:
        found = streamline(field, begin, settings.step, _LONGEST)
        if not found.reached:
            continue
        goal = goal_of[tuple(field.grid.cell_of(found.points[-1]).tolist())]
        path = query.configurations(found.points)
        before = line(query.start, path[0], settings.step)[:-1]
        behind = line(path[-1], query.goals[goal], settings.step)[1:]
        last = float(np.linalg.norm(query.goals[goal] - path[-1]))
        # The wrist may turn by far more than shoulder and elbow from point to point.
        path = subdivided(np.concatenate([before, path, behind]), settings.step)
        yield Way(path, goal, last)


class _Search:
    def __init__(
        self,
        query: Query,
        static: Map,
        attempt: Attempt,
        settings: PlannerSettings,
    ) -> None:
        self._query, self._grid = query, static.grid
        self._attempt, self._settings = attempt, settings
        free = free_cells(
            query.arm,
            *shoulders_and_elbows(self._grid),
            *query.solids,
            static.room,
            query.chart,
            query.reach,
            attempt.cell_margin,
        )
        self._free = free.reshape(self._grid.shape)
        self._goal_of = self._goal_cells()

    def run(self) -> GrossPlan | None:
        entries = self._in_sight(self._query.start)
        for _ in range(self._attempt.repairs):
            if not self._goal_of:
                return None
            field = self._solve()
            if not field.converged:
                return None
            touched, furthest = None, -1
            for way in self._ways(field, entries):
                near = self._query.too_near(way.path)
                if not near.any():
                    return GrossPlan(self._query, *way, field, self._goal_of)
                first = int(np.argmax(near))
                if first > furthest:
                    touched, furthest = way.path[first], first
            if touched is None:
                return None
            self._close(touched)
        return None

    def _ways(self, field: HarmonicField, entries: list[Cell]) -> Iterator[Way]:
        """Ways along streamlines from the start itself and from cells round it."""
        open_ones = [c for c in entries if self._free[c] and field.connected[c]]
        best = sorted(open_ones, key=lambda cell: -field.log_u[cell])[:_MOST_ENTRIES]
        centres = self._grid.centre(np.reshape(best, (-1, GROSS_JOINTS)))
        return ways(self._query, field, self._goal_of, centres, self._settings)

    def _in_sight(self, joints: np.ndarray) -> list[Cell]:
        step = self._settings.step
        return cells_in_sight(self._query, self._grid, self._free, joints, step)

    def _solve(self) -> HarmonicField:
        goal = np.zeros(self._grid.shape, bool)
        goal[tuple(np.array(list(self._goal_of)).T)] = True
        return harmonic_field(self._grid, self._free, goal, self._settings.solver)

    def _goal_cells(self) -> dict[Cell, int]:
        """Cells from which the way to a goal is straight."""
        found: dict[Cell, int] = {}
        for number, goal in enumerate(self._query.goals):
            for cell in self._in_sight(goal):
                found.setdefault(cell, number)
        return found

    def _close(self, joints: np.ndarray) -> None:
        """Close the cell in which a path came too near to something."""
        cell = tuple(self._grid.cell_of(joints[:GROSS_JOINTS]).tolist())
        if not self._free[cell]:
            # Between free cells: the nearest free one leads there.
            cell = self._nearest_free(joints)
        self._free[cell] = False
        self._goal_of.pop(cell, None)

    def _nearest_free(self, joints: np.ndarray) -> Cell:
        place = self._grid.coordinates(joints[:GROSS_JOINTS])
        free = np.argwhere(self._free)
        away = np.linalg.norm(free - place, axis=1)
        return tuple(free[np.argmin(away)].tolist())
