"""The judge judged: on a maze whose answers are known, and on the arm by MuJoCo."""

import itertools
from collections import deque

import mujoco
import numpy as np
import pytest
from sampling_planner import ArmIsFree, PlannerSettings, plan

from prospect_mj.robot import names, posture, wam
from prospect_mj.sim.props import Obstacle, Props
from prospect_mj.sim.scene import SceneSettings

SQUARE = np.array([-1.0, -1.0]), np.array([1.0, 1.0])
LEFT, RIGHT = np.array([-0.8, 0.0]), np.array([0.8, 0.0])
SMALL = PlannerSettings(step=0.02, extension=0.2, budget=20_000)
SCENE = SceneSettings(props=Props(obstacle=Obstacle(height=0.8)))


def wall(gap):
    """A wall across the square, with a gap at its upper end."""
    return lambda point: bool(abs(point[0]) > 0.1 or point[1] > 1.0 - gap)


def points_along(path, step):
    for a, b in itertools.pairwise(path):
        for share in np.linspace(0, 1, 2 + int(np.linalg.norm(b - a) / step)):
            yield a + share * (b - a)


@pytest.mark.parametrize("seed", range(5))
def test_it_finds_the_way_through_a_gap(seed):
    free = wall(gap=0.2)
    rng = np.random.default_rng(seed)
    path = plan(free, LEFT, RIGHT[None], SQUARE, rng, SMALL)
    assert path[0] == pytest.approx(LEFT)
    assert path[-1] == pytest.approx(RIGHT)
    assert len(path) > 2
    assert all(free(point) for point in points_along(path, 0.02))


def test_a_closed_wall_exhausts_the_budget():
    checks = deque()

    def free(point):
        checks.append(point)
        return wall(gap=0.0)(point)

    settings = PlannerSettings(step=0.02, extension=0.2, budget=3_000)
    rng = np.random.default_rng(0)
    assert plan(free, LEFT, RIGHT[None], SQUARE, rng, settings) is None
    longest_edge = 10
    assert 3_000 <= len(checks) < 3_000 + 20 * longest_edge


def test_a_free_straight_line_is_taken():
    rng = np.random.default_rng(0)
    path = plan(lambda point: True, LEFT, RIGHT[None], SQUARE, rng, SMALL)
    assert np.array_equal(path, [LEFT, RIGHT])


def test_of_several_goals_it_takes_one_that_can_be_reached():
    free = wall(gap=0.0)
    goals = np.array([RIGHT, [-0.8, 0.9], [0.0, 0.0]])
    path = plan(free, LEFT, goals, SQUARE, np.random.default_rng(0), SMALL)
    assert path[-1] == pytest.approx(goals[1])
    blocked = plan(free, LEFT, goals[2:], SQUARE, np.random.default_rng(0), SMALL)
    assert blocked is None


def test_the_answer_depends_on_the_seed_alone():
    paths = [
        plan(wall(0.1), LEFT, RIGHT[None], SQUARE, np.random.default_rng(3), SMALL)
        for _ in range(2)
    ]
    assert np.array_equal(*paths)


def least_distance(free, side):
    """Of the moving arm to anything but its own links, pair by pair [m]."""
    model, data = free.model, free.data
    welded = model.body_weldid[model.geom_bodyid]
    links = [model.body(name).id for name in names.arm_links(side)]
    moving = [i for i in range(model.ngeom) if welded[i] in links[2:]]
    others = [i for i in range(model.ngeom) if welded[i] not in links]
    return min(
        mujoco.mj_geomDistance(model, data, a, b, 1.0, None)
        for a in moving
        for b in others
    )


@pytest.mark.parametrize("side", names.SIDES)
def test_the_arm_is_free_exactly_if_no_pair_is_nearer_than_the_clearance(side):
    """Against distances taken pair by pair; limits that no own link can touch at."""
    free = ArmIsFree(side, 0.03, SCENE)
    free.place_obstacle(np.array([0.5, 0.3 * names.sign(side)]))
    rng = np.random.default_rng(0)
    verdicts = []
    for _ in range(60):
        joints = posture.home(side) + rng.uniform(-0.6, 0.6, 7)
        joints[[1, 3, 5]] = posture.home(side)[[1, 3, 5]] + rng.uniform(-0.3, 0.3, 3)
        verdicts.append(free(joints))
        assert verdicts[-1] == (least_distance(free, side) >= 0.03)
    assert 5 < sum(verdicts) < 55


@pytest.mark.parametrize("side", names.SIDES)
def test_the_arm_may_not_touch_itself(side):
    free = ArmIsFree(side, 0.01, SCENE)
    folded = posture.reflected((0.0, 0.0, 0.0, 2.9, 0.0, 1.3, 0.0), side)
    assert free(posture.home(side))
    assert not free(folded)


def test_motor_and_upper_arm_need_no_clearance_but_may_not_touch():
    free = ArmIsFree("left", 0.03, SCENE)
    for tilt, expected in ((1.5, True), (1.85, True), (1.99, False)):
        assert free(np.array([-1.0, tilt, 0.0, 0.0, 0.0, 0.0, 0.0])) is expected


@pytest.mark.parametrize("side", names.SIDES)
def test_it_leads_an_arm_round_the_obstacle(side):
    """The straight way is barred; the path keeps its clearance at every point."""
    free = ArmIsFree(side, 0.01, SCENE)
    # J2 swings the hand sideways; the post is put where the hand would pass.
    swing = posture.reflected((0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0), side)
    start, between, goal = (posture.home(side) + a * swing for a in (0.5, -0.34, -0.9))
    free.place_obstacle(free.hand_pose(between)[0][:2])
    assert not free(between)
    low, high = np.array(wam.JOINT_LIMITS).T
    ends = np.array([posture.reflected(low, side), posture.reflected(high, side)])
    limits = ends.min(axis=0), ends.max(axis=0)
    path = plan(free, start, goal[None], limits, np.random.default_rng(0))
    assert path is not None
    assert all(free(point) for point in points_along(path, 0.03))
