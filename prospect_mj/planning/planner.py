"""Gross motion planning by a harmonic function over shoulder and elbow."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import mujoco
import numpy as np

from prospect_mj.errors import InvalidValue
from prospect_mj.planning.arm_body import arm_body
from prospect_mj.planning.arm_kernels import clearances
from prospect_mj.planning.gross_plan import GrossPlan
from prospect_mj.planning.query import CEILING, Query, Solids, make_query
from prospect_mj.planning.search import Map, resumed, search, straight
from prospect_mj.planning.settings import Attempt, PlannerSettings
from prospect_mj.planning.static_map import static_room
from prospect_mj.planning.surroundings import KnownJars, Surroundings, body_with
from prospect_mj.robot import wam
from prospect_mj.robot.names import Side


class GoalSet(NamedTuple):
    """Goals that are found when they are first needed."""

    find: Callable[[], np.ndarray]
    """Tells joint angles (n, 7) [rad], the preferred ones first."""
    most: int = 1
    """Of those that are clear, how many to plan for."""
    spread: float = np.inf
    """Distance from the first of them within which they lie [rad]."""


@dataclass(frozen=True)
class World:
    """What moves: the state of a robot model, and where the jar is believed to be."""

    data: mujoco.MjData
    jars: KnownJars


class GrossPlanner:
    """Plans large movements of one arm among everything that it must not touch.

    Args:
        model: the robot and what stands around it, without a jar.
        side: the arm.
        settings: grid and clearances.
    """

    def __init__(
        self, model: mujoco.MjModel, side: Side, settings: PlannerSettings | None = None
    ) -> None:
        """Compute or load the static part of the first attempt; others come later."""
        self.settings = PlannerSettings() if settings is None else settings
        self.body = arm_body(model, side)
        self._surroundings = Surroundings(model, side)
        self._maps: dict[tuple[int, float], Map] = {}
        self._map(self.settings.attempts[0])

    def plan(
        self,
        start: np.ndarray,
        goal_sets: Sequence[GoalSet],
        world: World,
        thorough: bool = True,
    ) -> GrossPlan | None:
        """A way from one configuration to any of several others.

        Args:
            start: joint angles (7,) [rad].
            goal_sets: where to, the preferred set first.
            world: what moves.
            thorough: whether finer grids are tried when the coarse one shows no way;
                that there is none at all takes seconds to find out.

        Returns:
            The way, or None if there is none that the grids show.

        Raises:
            InvalidValue: without a goal set, or with a start that is no configuration.
        """
        if not goal_sets:
            raise InvalidValue("number of goal sets", 0, "at least 1")
        if start.shape != (wam.N_JOINTS,) or not np.isfinite(start).all():
            expected = f"{wam.N_JOINTS} finite joint angles"
            raise InvalidValue("start of a gross motion", start.tolist(), expected)
        coarse = [a for a in self.settings.attempts if a.refinement == 1]
        for attempt in self.settings.attempts if thorough else coarse:
            for goals in goal_sets:
                query = self._query(start, goals, world, attempt)
                plan = self._answer(query, attempt)
                if plan is not None:
                    return plan
        return None

    def _answer(self, query: Query, attempt: Attempt) -> GrossPlan | None:
        if not len(query.goals):
            return None
        near = straight(query, self.settings)
        return near or search(query, self._map(attempt), attempt, self.settings)

    def resume(
        self, plan: GrossPlan, start: np.ndarray, world: World
    ) -> GrossPlan | None:
        """The way of a plan from where the arm is now, in the world as it is now.

        Args:
            plan: an earlier one.
            start: joint angles (7,) [rad].
            world: what moves.

        Returns:
            The way along the same harmonic function, or None if something is in it.
        """
        moving = self._surroundings.moving(world.data, world.jars)
        return resumed(plan, plan.query.again(start, moving), self.settings)

    def clearance(self, configurations: np.ndarray, world: World) -> np.ndarray:
        """Least distances (n,) [m] of configurations (n, 7) [rad] to anything."""
        body = body_with(self.body, world.jars)
        rows = self._rows(world)
        return clearances(body.arrays, configurations, rows, CEILING)

    def _rows(self, world: World) -> np.ndarray:
        moving = self._surroundings.moving(world.data, world.jars)
        return np.concatenate([self._surroundings.fixed, moving])

    def _query(
        self, start: np.ndarray, goals: GoalSet, world: World, attempt: Attempt
    ) -> Query:
        body = body_with(self.body, world.jars)
        moving = self._surroundings.moving(world.data, world.jars)
        solids = Solids(self._surroundings.fixed, moving)
        found, most, spread = goals.find(), goals.most, goals.spread
        zone = self.settings.end_zone
        return make_query(body, solids, start, found, most, spread, attempt, zone)

    def _map(self, attempt: Attempt) -> Map:
        """The static part of an attempt."""
        key = attempt.refinement, attempt.cell_margin
        if key not in self._maps:
            grid = self.settings.grid(attempt, self.body.limits)
            fixed, margin = self._surroundings.fixed, attempt.cell_margin
            room = static_room(self.body, fixed, grid, margin)
            self._maps[key] = Map(grid, room)
        return self._maps[key]
