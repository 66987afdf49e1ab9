"""A planned way leads to a goal, clear of everything; or there is none."""

import time
from dataclasses import replace

import mink
import numpy as np
import pytest
from arm_scene import (
    NO_JAR,
    ArmScene,
    TrueClearance,
    in_hand,
    random_joints,
    site_pose,
)
from reach_clearance import planners_clearance

from prospect_mj.errors import InvalidValue, ProspectError
from prospect_mj.planning import search as searching
from prospect_mj.planning.goals import NATURAL, GoalSet, apart, goals
from prospect_mj.planning.planner import GrossPlanner, World
from prospect_mj.planning.settings import Attempt, PlannerSettings
from prospect_mj.planning.sight import subdivided
from prospect_mj.robot import names, posture

ROOMY = Attempt(refinement=1, cell_margin=0.030, path_margin=0.015)
TIGHT = Attempt(refinement=1, cell_margin=0.012, path_margin=0.008)
ONE_GRID = PlannerSettings(attempts=(ROOMY, TIGHT))
"""The grid that all plans but the most difficult ones are made on."""
CORNER = np.array([1.07, -0.70])
"""Where the post is out of the way [m]."""
WORKSPACE = np.array([[0.25, -0.15, 0.15], [0.80, 0.60, 0.80]])
"""Of the left hand [m]."""


@pytest.fixture
def scene():
    return ArmScene()


def planner_of(scene, side, settings=ONE_GRID):
    return GrossPlanner(scene.model, side, settings)


def world_of(scene):
    return World(scene.data, scene.jars)


def clearance_of(scene, side, configurations):
    return planners_clearance(scene.model, side, configurations, world_of(scene))


def to(*goals):
    goals = np.array(goals)
    return [GoalSet(lambda: goals, most=len(goals))]


def finely(path, step=0.02):
    """Points (n, 7) [rad] all along straight lines between a path's points."""
    return subdivided(path, step)


def hand_at(scene, side, joints):
    scene.put(side, joints)
    return site_pose(scene.data, side).translation() * [1, names.sign(side), 1]


def at_work(scene, side, rng):
    """Joint angles (7,) [rad] with the hand in front of the torso."""
    while True:
        joints = random_joints(side, rng, 1, margin=0.15)[0]
        hand = hand_at(scene, side, joints)
        if ((hand > WORKSPACE[0]) & (hand < WORKSPACE[1])).all():
            return joints


def task(scene, side, rng):
    """Start and goal with the post between the hands, all of them 3 cm apart."""
    while True:
        scene.place_post(CORNER)
        ends = [at_work(scene, side, rng) for _ in range(2)]
        hands = [hand_at(scene, side, joints) for joints in ends]
        if np.linalg.norm(hands[1] - hands[0]) < 0.3:
            continue
        scene.place_post(np.mean(hands, axis=0)[:2] * [1, names.sign(side)])
        true = TrueClearance(scene, side)
        if min(true(joints) for joints in ends) > 0.03:
            return *ends, true


JARS = {
    "empty": lambda side: NO_JAR,
    "with a jar": in_hand,
    "past a jar": lambda side: in_hand(names.other(side)),
}


@pytest.mark.parametrize("jars", JARS.values(), ids=JARS)
def test_ways_past_a_post_are_clear_all_along_by_mujocos_own_distances(side, jars):
    """Straight lines between their points included, to a millimetre of the margin."""
    scene = ArmScene(jars(side))
    planner, rng = planner_of(scene, side), np.random.default_rng(0)
    found = blocked = 0
    for _ in range(4):
        start, goal, true = task(scene, side, rng)
        plan = planner.plan(start, to(goal), world_of(scene))
        if plan is None:
            continue
        found += 1
        blocked += min(true(q) for q in finely(np.array([start, goal]))) < 0
        assert np.array_equal(plan.path[0], start)
        assert np.array_equal(plan.path[-1], goal)
        steps = np.linalg.norm(np.diff(plan.path, axis=0), axis=1)
        assert 0 < steps.max() <= planner.settings.step + 1e-9
        least = min(true(q) for q in finely(plan.path))
        assert least >= plan.query.margin - 1e-3
    assert found >= 3
    assert blocked >= 2, "none but free ways: nothing is shown"


def test_one_of_several_goals_is_reached_and_named(scene, side):
    planner, rng = planner_of(scene, side), np.random.default_rng(1)
    start = posture.home(side)
    true = TrueClearance(scene, side)
    several = []
    while len(several) < 4:
        joints = at_work(scene, side, rng)
        if true(joints) > 0.03:
            several.append(joints)
    plan = planner.plan(start, to(*several), world_of(scene))
    assert plan.path[-1] in plan.query.goals
    assert np.array_equal(plan.path[-1], plan.query.goals[plan.goal])
    assert any(np.array_equal(plan.path[-1], goal) for goal in several)


def test_a_goal_that_touches_something_is_left_for_another(scene, side):
    planner = planner_of(scene, side)
    start, bad = posture.home(side), posture.over_well(side)
    scene.put(side, bad)
    scene.place_post(site_pose(scene.data, side).translation()[:2])
    good = posture.presenting(side)
    assert planner.plan(start, to(bad), world_of(scene)) is None
    plan = planner.plan(start, to(bad, good), world_of(scene))
    assert np.array_equal(plan.path[-1], good)


def test_a_later_set_of_goals_is_asked_for_only_when_an_earlier_one_fails(scene, side):
    planner, start = planner_of(scene, side), posture.home(side)
    bad, good = posture.over_well(side), posture.presenting(side)
    scene.put(side, bad)
    scene.place_post(site_pose(scene.data, side).translation()[:2])
    asked = []

    def ask(goal):
        asked.append(goal)
        return goal[None]

    first, second = (GoalSet(lambda goal=goal: ask(goal)) for goal in (good, bad))
    assert planner.plan(start, [first, second], world_of(scene)) is not None
    assert len(asked) == 1
    plan = planner.plan(start, [second, first], world_of(scene))
    assert np.array_equal(plan.path[-1], good)
    assert len(asked) == 3


def test_without_a_goal_there_is_no_way(scene, side):
    planner = planner_of(scene, side)
    none = [GoalSet(lambda: np.empty((0, 7)), 5)]
    assert planner.plan(posture.home(side), none, world_of(scene)) is None


def stocks(scene, side, joints):
    """Four broad plates round the forearm, which neither hand nor elbow can pass."""
    scene.put(side, joints)
    forearm = scene.data.geom(f"{side}_forearm")
    centre, turn = forearm.xpos.copy(), forearm.xmat.reshape(3, 3).copy()
    model = scene.model
    gap, broad = 0.045 + 0.035, 0.6
    walls = ("far", "left", "near", "right")
    for name, direction in zip(walls, ((1, 0), (0, 1), (-1, 0), (0, -1)), strict=True):
        geom = model.geom(f"well/wall_{name}")
        away = np.array([*direction, 0.0]) * (gap + broad)
        model.geom_pos[geom.id] = turn @ away
        quat = mink.SO3.from_matrix(turn).wxyz
        model.geom_quat[geom.id] = quat
        across = abs(direction[0])
        size = [broad, 2 * broad, 0.02] if across else [2 * broad, broad, 0.02]
        model.geom_size[geom.id] = size
        model.geom_rbound[geom.id] = np.linalg.norm(size)
    for geom in range(model.ngeom):
        if model.geom(geom).name.startswith(("well/floor", "well/chamfer")):
            model.geom_pos[geom] = [0.0, 0.0, -9.0]
    model.body_pos[model.body("well/").id] = centre
    scene.put(side, joints)


def test_an_arm_in_the_stocks_has_no_way_out(scene, side):
    """Its links fit through with room, so that only the search can tell."""
    start = posture.home(side)
    stocks(scene, side, start)
    planner = planner_of(scene, side, PlannerSettings(attempts=(TIGHT,)))
    world, true = world_of(scene), TrueClearance(scene, side)
    goal = start + [0.0, 0.0, 0.0, 0.0, 0.3 * names.sign(side), 0.0, 0.0]
    assert min(true(start), true(goal)) > 0.02
    assert planner.plan(start, to(goal), world) is not None
    outside = next(
        joints
        for joints in random_joints(side, np.random.default_rng(0), 5000)
        if true(joints) > 0.05 and np.linalg.norm(joints[:4] - start[:4]) > 1.5
    )
    assert planner.plan(start, to(outside), world) is None
    assert planner.plan(outside, to(start), world) is None


def test_a_near_goal_is_gone_to_straight_unless_something_is_between(scene, side):
    planner, start = planner_of(scene, side), posture.home(side)
    goal = start + 0.1 * np.array([1, -1, 1, -1, 1, 1, 1])
    plan = planner.plan(start, to(goal), world_of(scene))
    assert plan.field is None
    off = np.cross(plan.path[:, :3] - start[:3], (goal - start)[:3])
    assert np.abs(off).max() < 1e-12
    assert np.linalg.norm(np.diff(plan.path, axis=0), axis=1).max() <= 0.05 + 1e-9


def test_a_straight_way_that_touches_something_is_not_taken(scene, side):
    """However near the goal may count as."""
    settings = replace(ONE_GRID, straight=20.0)
    planner, rng = planner_of(scene, side, settings), np.random.default_rng(7)
    blocked = 0
    for _ in range(3):
        start, goal, true = task(scene, side, rng)
        line = finely(np.array([start, goal]))
        is_free = min(true(joints) for joints in line) > 0.03
        touches = min(true(joints) for joints in line) < 0
        plan = planner.plan(start, to(goal), world_of(scene))
        if is_free:
            assert plan.field is None
        if touches:
            blocked += 1
            assert plan is None or plan.field is not None
    assert blocked


def asked(scene, planner, start, goal, attempt=ROOMY):
    return planner._query(start, to(goal)[0], world_of(scene), attempt)


def test_points_nearer_than_the_margin_are_too_near(scene, side):
    """But for what is as near to an end of the way as that end is to something."""
    planner, rng = planner_of(scene, side), np.random.default_rng(8)
    start, goal, true = task(scene, side, rng)
    assert true(start) > 0.03
    assert true(goal) > 0.03
    query = asked(scene, planner, start, goal)
    points = random_joints(side, rng, 3000)
    clearance = clearance_of(scene, side, points)
    assert (query.too_near(points) == (clearance < ROOMY.path_margin)).all()
    close = (clearance > 0) & (clearance < ROOMY.path_margin)
    assert close.sum() > 10


def test_near_a_tight_end_a_way_may_be_as_near_as_that_end(scene, side):
    rng = np.random.default_rng(9)
    planner, room = planner_of(scene, side), 0.0
    while not 0.004 < room < 0.012:
        tight, goal = (at_work(scene, side, rng) for _ in range(2))
        room = clearance_of(scene, side, tight[None])[0]
        room *= clearance_of(scene, side, goal[None])[0] > 0.03
    query = asked(scene, planner, tight, goal)
    zone = planner.settings.end_zone
    assert not query.too_near(tight[None])[0]
    directions = rng.standard_normal((4000, 7))
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    points = tight + rng.uniform(0, 2 * zone, (4000, 1)) * directions
    clearance = clearance_of(scene, side, points)
    inside = np.linalg.norm(points - tight, axis=1) < zone
    need = np.where(inside, room - 1e-3, ROOMY.path_margin)
    assert (query.too_near(points) == (clearance < need)).all()
    between = (clearance > room) & (clearance < ROOMY.path_margin)
    assert (between & inside).any()
    assert (between & ~inside).any()


def far_task(scene, side):
    """Home to over the well, without anything between."""
    scene.place_post(CORNER)
    return posture.home(side), posture.over_well(side)


def between(plan, scene, side, share=0.5):
    """Where the hand is on a plan's way: centre (2,) [m] for the post."""
    scene.put(side, plan.path[int(share * len(plan.path))])
    return site_pose(scene.data, side).translation()[:2]


def test_it_goes_on_along_the_same_field_as_long_as_the_way_is_clear(scene, side):
    planner = planner_of(scene, side)
    start, goal = far_task(scene, side)
    plan = planner.plan(start, to(goal), world_of(scene))
    assert plan.field is not None
    way = between(plan, scene, side)
    here = plan.path[len(plan.path) // 5] + 0.01
    scene.place_post(CORNER - 0.05)
    again = planner.resume(plan, here, world_of(scene))
    assert again.field is plan.field
    assert again.goal == plan.goal
    assert np.array_equal(again.path[0], here)
    assert np.array_equal(again.path[-1], goal)
    assert again.length_left(here) < plan.length_left(start)
    scene.place_post(way)
    assert planner.resume(plan, here, world_of(scene)) is None
    assert planner.resume(again, here, world_of(scene)) is None


def test_what_moved_into_the_way_is_gone_round_by_a_new_plan(scene, side):
    planner = planner_of(scene, side)
    start, goal, _ = unaware(scene, side, planner)
    other = planner.plan(start, to(goal), world_of(scene))
    true = TrueClearance(scene, side)
    assert min(true(q) for q in finely(other.path)) > other.query.margin - 1e-3


def unaware(scene, side, planner):
    """Start, goal and a plan in whose way, but off both ends, the post is put then."""
    rng = np.random.default_rng(6)
    while True:
        start, goal, true = task(scene, side, rng)
        scene.place_post(CORNER)
        plan = planner.plan(start, to(goal), world_of(scene))
        if plan is not None:
            scene.place_post(between(plan, scene, side))
            true = TrueClearance(scene, side)
            in_the_way = clearance_of(scene, side, plan.path).min() < 0
            if in_the_way and min(true(start), true(goal)) > 0.04:
                return start, goal, plan


def test_plans_do_not_depend_on_plans_made_before(side):
    """No state but the map of what never moves."""
    fresh, used = ArmScene(), ArmScene()
    planner = planner_of(used, side)
    rng = np.random.default_rng(3)
    for _ in range(2):
        start, goal, _ = task(used, side, rng)
        planner.plan(start, to(goal), world_of(used))
    paths = []
    for scene, each in ((fresh, planner_of(fresh, side)), (used, planner)):
        scene.put(side, posture.home(side))
        start, goal = far_task(scene, side)
        paths.append(each.plan(start, to(goal), world_of(scene)).path)
    assert np.array_equal(*paths)


def test_left_and_right_are_each_others_reflection():
    paths = []
    for side in names.SIDES:
        scene = ArmScene()
        start, goal = far_task(scene, side)
        scene.place_post([-0.9, 0.0])
        path = planner_of(scene, side).plan(start, to(goal), world_of(scene)).path
        paths.append(np.array([posture.reflected(q, side) for q in path]))
    assert len(paths[0]) == pytest.approx(len(paths[1]), rel=0.1)
    assert paths[0][len(paths[0]) // 2] == pytest.approx(
        paths[1][len(paths[1]) // 2], abs=0.2
    )


def attempted(monkeypatch):
    """Grid sizes of all searches from now on."""
    sizes, search = [], searching.search

    def spy(query, static, attempt, settings):
        sizes.append((static.grid.cells[0], attempt))
        return search(query, static, attempt, settings)

    monkeypatch.setattr("prospect_mj.planning.planner.search", spy)
    return sizes


def test_a_finer_grid_is_made_and_used_only_when_the_coarser_ones_fail(
    scene, side, monkeypatch, tmp_path
):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    attempts = (replace(ROOMY, repairs=1), TIGHT, replace(TIGHT, refinement=2))
    settings = PlannerSettings(cells=(6, 6, 6, 6), attempts=attempts)
    planner = planner_of(scene, side, settings)
    start, goal = far_task(scene, side)
    searches, world = attempted(monkeypatch), world_of(scene)
    assert planner.plan(start, to(goal), world) is not None
    n = len(searches)
    assert [size for size, _ in searches] == [6, 6, 12][:n]
    assert len(planner._maps) == n
    scene.put(side, goal)
    scene.place_post(site_pose(scene.data, side).translation()[:2])
    assert planner.plan(start, to(goal), world) is None
    assert len(searches) == n, "a goal that touches something was searched for"
    scene.place_post(CORNER)
    monkeypatch.setattr(
        "prospect_mj.planning.planner.search",
        lambda *asked: searches.append(asked[2]),
    )
    del searches[:]
    assert planner.plan(start, to(goal), world) is None
    assert searches == list(attempts)


BAD = [
    ({"cells": (16, 16, 16)}, "one number for each of 4 joints"),
    ({"cells": (16,) * 5}, "one number for each of 4 joints"),
    ({"cells": (16, 16, 16, 1)}, "at least 2"),
    ({"cells": (16, 16, 16, 16.5)}, "at least 2"),
    ({"cells": (400,) * 4}, r"memory that a grid of 400 x 400 x 400 x 400 cells"),
    ({"attempts": ()}, "attempts of the planner is 0"),
    ({"step": 0.0}, "step of the planner .* is 0.0; expected a positive number"),
    ({"step": -0.05}, "step of the planner .* is -0.05"),
    ({"step": np.nan}, "step of the planner .* is nan"),
    ({"step": np.inf}, "step of the planner .* is inf"),
    ({"end_zone": -0.1}, "end zone of the planner .* is -0.1; expected at least 0"),
    ({"end_zone": np.nan}, "end zone of the planner .* is nan"),
    ({"straight": -0.5}, "straight of the planner .* is -0.5; expected at least 0"),
    ({"straight": np.nan}, "straight of the planner .* is nan"),
]


@pytest.mark.parametrize(("changed", "message"), BAD)
def test_bad_settings_are_one_line_before_anything_is_computed(changed, message):
    begun = time.perf_counter()
    with pytest.raises(InvalidValue, match=message) as refusal:
        PlannerSettings(**changed)
    assert time.perf_counter() - begun < 0.1
    assert "\n" not in str(refusal.value)


BAD_ATTEMPTS = [
    ({"cell_margin": -0.01}, "cell margin .* is -0.01; expected 0 to 0.04"),
    ({"cell_margin": 0.05}, "cell margin .* is 0.05; expected 0 to 0.04"),
    ({"path_margin": -0.01}, "path margin .* is -0.01; expected at least 0"),
    ({"path_margin": np.nan}, "path margin .* is nan"),
    ({"refinement": 0}, "refinement is 0; expected an integer of at least 1"),
    ({"refinement": 1.5}, "refinement is 1.5"),
    ({"repairs": 0}, "repairs is 0; expected an integer of at least 1"),
    ({"repairs": 2.5}, "repairs is 2.5"),
    ({"wrist": "bent"}, "wrist is 'bent'; valid: between, goal, start, straight"),
]


@pytest.mark.parametrize(("changed", "message"), BAD_ATTEMPTS)
def test_an_attempt_that_is_none_is_one_line(changed, message):
    with pytest.raises(ProspectError, match=message) as refusal:
        replace(ROOMY, **changed)
    assert "\n" not in str(refusal.value)


def test_settings_may_be_as_little_as_makes_a_planner():
    attempt = replace(ROOMY, cell_margin=0.0, path_margin=0.0, repairs=1)
    least = PlannerSettings(attempts=(attempt,), step=1e-3, end_zone=0.0, straight=0.0)
    assert least.attempts == (attempt,)


def test_goals_of_a_pose_put_the_hand_there_the_most_natural_first(scene, side):
    there = posture.presenting(side)
    pose, start = scene.hand(side, there), posture.home(side)
    found = goals(side, pose, start, there, True, NATURAL)
    assert len(found) > 20
    away = [np.linalg.norm(q - there) + np.linalg.norm(q - start) for q in found]
    assert (np.diff(away) >= -1e-12).all()
    z = pose.rotation().as_matrix()[:, 2]
    for joints in found[::10]:
        hand = scene.hand(side, joints)
        assert hand.translation() == pytest.approx(pose.translation(), abs=1e-8)
        assert hand.rotation().as_matrix()[:, 2] == pytest.approx(z, abs=1e-8)
    fixed = goals(side, pose, start, there, False, NATURAL)
    assert 0 < len(fixed) < len(found)
    assert scene.hand(side, fixed[0]).as_matrix() == pytest.approx(
        pose.as_matrix(), abs=1e-8
    )
    out = mink.SE3.from_rotation_and_translation(
        pose.rotation(), np.array([3.0, 0.0, 0.0])
    )
    assert goals(side, out, start, there, True, NATURAL).shape == (0, 7)


def test_goals_that_are_much_alike_are_one():
    rng = np.random.default_rng(4)
    some = rng.uniform(-1, 1, (200, 7))
    chosen = apart(some, 10, np.inf)
    assert chosen[0] == 0
    assert len(chosen) == len(set(chosen)) == 10
    picked = some[chosen]
    gaps = np.linalg.norm(picked[:, None] - picked, axis=2)
    assert gaps[~np.eye(10, dtype=bool)].min() > 0.5
    near = apart(some, 200, 1.5)
    assert np.linalg.norm(some[near] - some[0], axis=1).max() <= 1.5
    assert apart(some[:0], 5, np.inf) == []
    same = np.repeat(some[:1], 9, axis=0)
    assert apart(same, 5, np.inf) == [0]


def length(path):
    return np.linalg.norm(np.diff(path, axis=0), axis=1).sum()


def test_a_subdivided_path_is_the_same_line_in_small_steps():
    rng = np.random.default_rng(5)
    corners = rng.uniform(-1, 1, (6, 7))
    fine = subdivided(corners, 0.03)
    assert np.linalg.norm(np.diff(fine, axis=0), axis=1).max() <= 0.03 + 1e-12
    assert length(fine) == pytest.approx(length(corners))
    for corner in corners:
        assert np.linalg.norm(fine - corner, axis=1).min() < 1e-12
    assert np.array_equal(subdivided(corners, 9.0), corners)
