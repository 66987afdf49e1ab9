"""Gross motion planning by a harmonic function over shoulder and elbow."""

from collections.abc import Sequence
from dataclasses import dataclass

import mujoco
import numpy as np

from prospect_mj.errors import InvalidValue
from prospect_mj.planning.arm_body import arm_body
from prospect_mj.planning.goals import GoalSet
from prospect_mj.planning.gross_plan import GrossPlan
from prospect_mj.planning.query import Demand, Query, Solids, make_query
from prospect_mj.planning.search import Map, resumed, search, straight
from prospect_mj.planning.settings import Attempt, PlannerSettings
from prospect_mj.planning.static_map import static_room
from prospect_mj.planning.surroundings import KnownJars, Surroundings, body_with
from prospect_mj.robot import wam
from prospect_mj.robot.names import Side


@dataclass(frozen=True)
class World:
    """What moves: the state of a robot model, and where the jar is believed to be."""

    data: mujoco.MjData
    """Of the planner's model, its kinematics up to date."""
    jars: KnownJars
    """The jar is no part of that model."""


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
        query = plan.query.again(start, self._solids(world))
        return resumed(plan, query, self.settings)

    def _solids(self, world: World) -> Solids:
        moving = self._surroundings.moving(world.data, world.jars)
        return Solids(self._surroundings.fixed, moving)

    def _query(
        self, start: np.ndarray, goals: GoalSet, world: World, attempt: Attempt
    ) -> Query:
        body = body_with(self.body, world.jars)
        demand = Demand(attempt.path_margin, self.settings.end_zone, attempt.wrist)
        return make_query(body, self._solids(world), start, goals, demand)

    def _map(self, attempt: Attempt) -> Map:
        """The static part of an attempt."""
        key = attempt.refinement, attempt.cell_margin
        if key not in self._maps:
            grid = self.settings.grid(attempt, self.body.limits)
            fixed, margin = self._surroundings.fixed, attempt.cell_margin
            room = static_room(self.body, fixed, grid, margin)
            self._maps[key] = Map(grid, room)
        return self._maps[key]
