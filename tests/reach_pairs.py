"""Pairs of start and goal for gross motion, and a planner's verdict on each.

A pair and its verdict depend on nothing but their seed, so that they can be drawn once
and several controllers be tried on them.
"""

import functools
import time
from dataclasses import dataclass

import numpy as np
from joblib import Parallel, delayed
from sampling_planner import ArmIsFree, PlannerSettings, plan

from prospect_mj.robot import names, posture, wam, wam_ik
from prospect_mj.robot.names import Side
from prospect_mj.sim.props import Obstacle, Props
from prospect_mj.sim.scene import SceneSettings

POST = Obstacle()
SCENE = SceneSettings(props=Props(obstacle=POST))
JOINT_MARGIN = 0.15
"""Of start and goal from every joint limit [rad]."""
PLANNED_JOINT_MARGIN = 0.05
"""Of the judge's paths from every joint limit [rad]."""
WORKSPACE = np.array([[0.20, -0.25, 0.10], [0.90, 0.70, 1.00]])
"""Of the left hand's grasp site [m]: in front of the torso, above the table, on its own
side and somewhat across; the right hand's is its reflection."""
END_CLEARANCE = 0.03
"""Of start and goal [m]."""
PATH_CLEARANCE = 0.010
"""Of the judge's paths [m]: what mink keeps, too."""
LEAST_DISTANCE = 0.30
"""Between the hand at the start and at the goal [m]."""
OBSTACLE_OFFSET = 0.08
"""Of the post from below the middle between both hands, at most along x and y [m]."""
_SWIVELS = np.linspace(-np.pi, np.pi, 12, endpoint=False)
_MOST_GOALS = 40


@dataclass(frozen=True)
class ReachPair:
    """One task, and whether it can be done."""

    side: Side
    index: int
    start: np.ndarray
    """Joint angles (7,) [rad]."""
    position: np.ndarray
    """Goal of the grasp site in the world (3,) [m]; its roll is free."""
    rotation: np.ndarray
    """(3, 3)"""
    goal: np.ndarray
    """Joint angles (7,) [rad] that the goal was made from."""
    obstacle: np.ndarray | None
    """Centre of the post on the table (2,) [m]."""
    path: np.ndarray | None
    """The judge's path (m, 7) [rad]; None: not plannable within its budget."""
    planning_time: float
    """Of the judge [s]."""

    @property
    def plannable(self) -> bool:
        return self.path is not None


def draw_pair(
    side: Side, index: int, seed: int, planner: PlannerSettings | None = None
) -> ReachPair:
    """A random pair; those of odd index have the obstacle between start and goal."""
    rng = np.random.default_rng([seed, names.SIDES.index(side), index])
    free = _judge(side, END_CLEARANCE)
    place = None
    while True:
        free.place_obstacle(np.array(POST.position))
        start, goal = _posture(free, side, rng), _posture(free, side, rng)
        ends = [free.hand_pose(joints) for joints in (start, goal)]
        if np.linalg.norm(ends[0][0] - ends[1][0]) < LEAST_DISTANCE:
            continue
        if index % 2 == 0:
            break
        place = (ends[0][0] + ends[1][0])[:2] / 2
        place = place + rng.uniform(-OBSTACLE_OFFSET, OBSTACLE_OFFSET, 2)
        free.place_obstacle(place)
        if _fits(place, side) and free(start) and free(goal):
            break
    begun = time.perf_counter()
    path = _judged(side, start, goal, ends[1], place, rng, planner)
    planning_time = time.perf_counter() - begun
    return ReachPair(side, index, start, *ends[1], goal, place, path, planning_time)


@functools.cache
def _judge(side: Side, clearance: float) -> ArmIsFree:
    return ArmIsFree(side, clearance, SCENE)


def _limits(side: Side, margin: float) -> tuple[np.ndarray, np.ndarray]:
    low, high = np.array(wam.JOINT_LIMITS).T
    ends = np.array([posture.reflected(q, side) for q in (low + margin, high - margin)])
    return ends.min(axis=0), ends.max(axis=0)


def _posture(free: ArmIsFree, side: Side, rng: np.random.Generator) -> np.ndarray:
    """Uniform in the joint limits, of those with the hand in the workspace."""
    while True:
        joints = rng.uniform(*_limits(side, JOINT_MARGIN))
        place = free.hand_pose(joints)[0] * [1, names.sign(side), 1]
        inside = (place > WORKSPACE[0]) & (place < WORKSPACE[1])
        if inside.all() and free(joints):
            return joints


def _fits(place: np.ndarray, side: Side) -> bool:
    """Whether the post stands on the table and clear of the arm that waits at home."""
    table, other = SCENE.props.table, names.other(side)
    offset = np.abs(place - table.centre)
    waiting = _judge(other, END_CLEARANCE)
    waiting.place_obstacle(place)
    on_table = bool((offset + POST.radius < table.half_size).all())
    return on_table and waiting(posture.home(other))


def _judged(
    side: Side,
    start: np.ndarray,
    goal: np.ndarray,
    pose: tuple[np.ndarray, np.ndarray],
    place: np.ndarray | None,
    rng: np.random.Generator,
    planner: PlannerSettings | None,
) -> np.ndarray | None:
    """The judge's path to any of the arm's solutions for the hand's pose."""
    wide, near = _judge(side, END_CLEARANCE), _judge(side, PATH_CLEARANCE)
    for free in (wide, near):
        free.place_obstacle(np.array(POST.position) if place is None else place)
    others = wam_ik.solutions_free_roll(
        side, *pose, _SWIVELS, _SWIVELS, PLANNED_JOINT_MARGIN
    )
    others = rng.permutation([joints for joints in others if wide(joints)])
    goals = np.array([goal, *others[: _MOST_GOALS - 1]])
    limits = _limits(side, PLANNED_JOINT_MARGIN)
    return plan(near, start, goals, limits, rng, planner)


def draw_in_parallel(n: int, seed: int, jobs: int = 2) -> list[ReachPair]:
    """`n` pairs per arm."""
    tasks = [(side, index, seed) for side in names.SIDES for index in range(n)]
    return Parallel(n_jobs=jobs)(delayed(draw_pair)(*task) for task in tasks)
