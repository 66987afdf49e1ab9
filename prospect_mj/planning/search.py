"""The search for a way on one grid: solve, walk the streamline, close what it touches."""

from collections.abc import Iterator
from dataclasses import replace
from itertools import product

import numpy as np

from prospect_mj.planning.arm_body import GROSS_JOINTS
from prospect_mj.planning.gross_plan import Cell, GrossPlan
from prospect_mj.planning.harmonic_field import HarmonicField, harmonic_field
from prospect_mj.planning.joint_grid import JointGrid
from prospect_mj.planning.occupancy import free_cells
from prospect_mj.planning.query import Query
from prospect_mj.planning.settings import PlannerSettings
from prospect_mj.planning.streamline import streamline

_CORNERS = np.array(list(product((0, 1), repeat=GROSS_JOINTS)))
_LONGEST = 60.0
"""Streamlines that are longer are given up [rad]."""


def straight(query: Query, settings: PlannerSettings) -> GrossPlan | None:
    """The straight way to a goal that is near, if it is clear."""
    away = np.linalg.norm(query.goals - query.start, axis=1)
    for goal in np.argsort(away, kind="stable"):
        if away[goal] > settings.straight:
            break
        way = line(query.start, query.goals[goal], settings.step)
        if not too_near(query, way, int(goal), settings).any():
            return GrossPlan(query, way, int(goal))
    return None


def resumed(
    plan: GrossPlan, query: Query, settings: PlannerSettings
) -> GrossPlan | None:
    """The way of a plan from another start in another world, if it is still clear."""
    if plan.field is None:
        return straight(query, settings)
    for path, goal in ways(query, plan.field, plan.goal_of, [], settings):
        if not too_near(query, path, goal, settings).any():
            return replace(plan, query=query, path=path, goal=goal)
    return None


def search(
    query: Query, grid: JointGrid, room: np.ndarray, settings: PlannerSettings
) -> GrossPlan | None:
    """A way from the start to one of the goals, if this grid shows one.

    The harmonic function leads past everything that fills a cell's centre. What lies
    between centres is found by walking its streamline with the arm's own geometry: the
    cell where that comes too near to something is closed, and the function is solved
    again.
    """
    return _Search(query, grid, room, settings).run()


def ways(
    query: Query,
    field: HarmonicField,
    goal_of: dict[Cell, int],
    entries: list[np.ndarray],
    settings: PlannerSettings,
) -> Iterator[tuple[np.ndarray, int]]:
    """Ways (n, 7) [rad] along streamlines to a goal, each with the goal's number.

    The first begins at the start itself; others go straight to an entry (7,) first.
    """
    for begin in [query.start, *entries]:
        gross = begin[:GROSS_JOINTS]
        found = streamline(field, gross, settings.step, _LONGEST)
        if not found.reached:
            continue
        goal = goal_of[tuple(field.grid.cell_of(found.points[-1]).tolist())]
        path = query.configurations(found.points)
        path[0] = begin
        before = line(query.start, begin, settings.step)[:-1]
        behind = line(path[-1], query.goals[goal], settings.step)[1:]
        yield np.concatenate([before, path, behind]), goal


def line(first: np.ndarray, last: np.ndarray, step: float) -> np.ndarray:
    """Points (n, 7) [rad] of a straight line, at most a step apart."""
    n = int(np.ceil(np.linalg.norm(last - first) / step))
    return np.linspace(first, last, n + 1)


def too_near(
    query: Query, path: np.ndarray, goal: int, settings: PlannerSettings
) -> np.ndarray:
    """Which points of a path are nearer to something than the settings allow."""
    return query.too_near(path, goal, settings.path_margin, settings.end_zone)


class _Search:
    def __init__(
        self,
        query: Query,
        grid: JointGrid,
        room: np.ndarray,
        settings: PlannerSettings,
    ) -> None:
        self._query, self._grid, self._settings = query, grid, settings
        axes = tuple(grid.centres(j) for j in range(grid.n_joints))
        self._free = free_cells(
            query.arm,
            axes,
            query.fixed,
            query.moving,
            room,
            query.reach,
            query.chart,
            settings.cell_margin,
        )
        self._goal_of = self._goal_cells()

    def run(self) -> GrossPlan | None:
        for _ in range(self._settings.repairs):
            if not self._goal_of:
                return None
            field = self._solve()
            closing = None
            entries = self._entries(field)
            for path, goal in ways(
                self._query, field, self._goal_of, entries, self._settings
            ):
                near = too_near(self._query, path, goal, self._settings)
                if not near.any():
                    return GrossPlan(self._query, path, goal, field, self._goal_of)
                closing = path[np.argmax(near)] if closing is None else closing
            if closing is None:
                return None
            self._close(closing)
        return None

    def _solve(self) -> HarmonicField:
        goal = np.zeros(self._grid.shape, bool)
        goal[tuple(np.array(list(self._goal_of)).T)] = True
        return harmonic_field(self._grid, self._free, goal)

    def _goal_cells(self) -> dict[Cell, int]:
        """Cells round the goals from which the way to the goal is straight."""
        found: dict[Cell, int] = {}
        for number, goal in enumerate(self._query.goals):
            for cell in self._round(goal):
                way = line(self._centre(cell), goal, self._settings.step)
                near = too_near(self._query, way, number, self._settings)
                if cell not in found and not near.any():
                    found[cell] = number
        return found

    def _entries(self, field: HarmonicField) -> list[np.ndarray]:
        """Centres (7,) [rad] of the cells round the start, the best first."""
        cells = self._round(self._query.start)
        return [self._centre(c) for c in sorted(cells, key=lambda c: -field.log_u[c])]

    def _round(self, joints: np.ndarray) -> list[Cell]:
        """Free cells whose centres surround a configuration."""
        base = np.floor(self._grid.coordinates(joints[:GROSS_JOINTS])).astype(int)
        cells = base + _CORNERS
        inside = ((cells >= 0) & (cells < self._grid.shape)).all(axis=1)
        return [c for c in map(tuple, cells[inside].tolist()) if self._free[c]]

    def _centre(self, cell: Cell) -> np.ndarray:
        gross = self._grid.centre(np.array(cell))
        return self._query.configurations(gross[None])[0]

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
