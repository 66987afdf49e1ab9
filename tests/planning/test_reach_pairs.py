"""Pairs of start and goal keep what they promise, and their runs see what happens."""

import functools
from dataclasses import replace

import numpy as np
import pytest
import reach_pairs
import reach_runs
from reach_pairs import END_CLEARANCE, PATH_CLEARANCE, POST, SCENE, draw_pair
from reach_runs import run
from sampling_planner import ArmIsFree, PlannerSettings

from prospect_mj.control.controller import CONTROL_PERIOD, Controller
from prospect_mj.control.result import Status, Targets
from prospect_mj.control.straight_reach import StraightReach
from prospect_mj.robot import names, posture, wam

N = 6
"""Pairs per arm."""
SERVO_LAG = np.divide(wam.SERVO.damping, wam.SERVO.stiffness)
"""Of a joint behind a steadily moving target [s]."""


@functools.cache
def pairs():
    return [draw_pair(side, i, seed=1) for side in names.SIDES for i in range(N)]


@functools.cache
def judge(side, clearance):
    return ArmIsFree(side, clearance, SCENE)


def judged(pair, clearance):
    free = judge(pair.side, clearance)
    free.place_obstacle(np.array(POST.position))
    if pair.obstacle is not None:
        free.place_obstacle(pair.obstacle)
    return free


def along(path, step):
    """Points (n, 7) [rad] on a path, evenly spaced."""
    lengths = np.linalg.norm(np.diff(path, axis=0), axis=1)
    stations = np.concatenate([[0.0], np.cumsum(lengths)])
    places = np.arange(0.0, stations[-1], step)
    points = [np.interp(places, stations, joint) for joint in path.T]
    return np.vstack([np.column_stack(points), path[-1]])


def test_start_and_goal_are_clear_far_apart_and_in_the_workspace():
    for pair in pairs():
        free = judged(pair, END_CLEARANCE)
        assert free(pair.start)
        assert free(pair.goal)
        hands = [free.hand_pose(q)[0] for q in (pair.start, pair.goal)]
        assert np.linalg.norm(hands[1] - hands[0]) >= reach_pairs.LEAST_DISTANCE
        for hand in hands:
            place = hand * [1, names.sign(pair.side), 1]
            assert (place > reach_pairs.WORKSPACE[0]).all()
            assert (place < reach_pairs.WORKSPACE[1]).all()


def test_every_other_pair_has_the_post_between_its_ends_and_off_the_waiting_arm():
    obstructed = [pair for pair in pairs() if pair.obstacle is not None]
    assert len(obstructed) == len(pairs()) / 2
    for pair in obstructed:
        free = judged(pair, END_CLEARANCE)
        hands = [free.hand_pose(q)[0] for q in (pair.start, pair.goal)]
        offset = pair.obstacle - np.mean(hands, axis=0)[:2]
        assert np.abs(offset).max() <= reach_pairs.OBSTACLE_OFFSET
        other = judge(names.other(pair.side), END_CLEARANCE)
        other.place_obstacle(pair.obstacle)
        assert other(posture.home(names.other(pair.side)))


def test_a_verdict_is_a_clear_path_from_the_start_to_the_hands_pose():
    for pair in pairs():
        assert pair.plannable
        assert np.array_equal(pair.path[0], pair.start)
        free = judged(pair, PATH_CLEARANCE)
        assert all(free(joints) for joints in along(pair.path, 0.05))
        position, rotation = free.hand_pose(pair.path[-1])
        assert position == pytest.approx(pair.position, abs=1e-8)
        assert rotation[:, 2] == pytest.approx(pair.rotation[:, 2], abs=1e-8)


def test_some_pairs_need_a_detour():
    """Otherwise the verdicts would say little."""
    assert any(len(pair.path) > 2 for pair in pairs())


def test_without_a_budget_only_straight_ways_are_found():
    pair = next(pair for pair in pairs() if len(pair.path) > 2)
    none = draw_pair(pair.side, pair.index, 1, PlannerSettings(budget=0))
    assert np.array_equal(none.start, pair.start)
    assert not none.plannable


def test_a_pair_depends_on_its_seed_alone():
    first, again = pairs()[1], draw_pair("left", 1, seed=1)
    for field in ("start", "goal", "position", "rotation", "obstacle", "path"):
        assert np.array_equal(getattr(first, field), getattr(again, field))
    assert not np.array_equal(draw_pair("left", 1, seed=2).start, first.start)


class Follower(Controller):
    """Drives joints along given points, blind to everything else."""

    def __init__(self, side, points, speed=0.4):
        super().__init__(side, time_budget=60.0)
        self._points = along(points, speed * CONTROL_PERIOD)
        self._n = 0

    def _law(self, reading):
        here = self._points[min(self._n, len(self._points) - 1)]
        self._n += 1
        ahead = self._points[min(self._n, len(self._points) - 1)]
        if np.abs(reading[self.side].joints - self._points[-1]).max() < 5e-3:
            self._finish(Status.CONVERGED)
        # Against the servos' lag, so that a corner of the path is not cut.
        return Targets(joints=here + SERVO_LAG * (ahead - here) / CONTROL_PERIOD)


@pytest.mark.parametrize("index", range(2 * N))
def test_physics_agrees_with_the_verdict(index):
    """The judge's path leads to the goal in physics, and nothing is touched."""
    pair = pairs()[index]
    reach = run(pair, lambda arm, target, reference: Follower(pair.side, pair.path))
    assert reach.arrived, reach
    assert not reach.contacts


@pytest.mark.parametrize("side", names.SIDES)
def test_a_blow_against_the_post_is_seen(side):
    obstructed = (draw_pair(side, i, seed=1) for i in range(1, 100, 2))
    pair = next(
        pair
        for pair in obstructed
        if not all(
            judged(pair, 0.0)(joints)
            for joints in along(np.array([pair.start, pair.goal]), 0.05)
        )
    )
    blunt = np.array([pair.start, pair.goal])
    reach = run(pair, lambda arm, target, reference: Follower(pair.side, blunt))
    assert reach.contacts
    assert all(steps > 0 for steps in reach.contacts.values())


class Braggart(Controller):
    """Says at once that it has arrived."""

    def _law(self, reading):
        self._finish(Status.CONVERGED)
        return Targets()


def test_arrival_is_judged_by_where_the_hand_is():
    pair = pairs()[0]
    reach = run(pair, lambda arm, target, reference: Braggart(pair.side, 1.0))
    assert reach.status is Status.CONVERGED
    assert reach.position_error == pytest.approx(
        np.linalg.norm(judged(pair, 0.0).hand_pose(pair.start)[0] - pair.position),
        abs=1e-3,
    )
    assert not reach.arrived
    free = judged(pair, 0.0)
    position, rotation = free.hand_pose(pair.start)
    here = replace(pair, position=position, rotation=rotation)
    assert run(here, lambda arm, target, ref: Braggart(pair.side, 1.0)).arrived


def test_the_straight_reach_says_truly_how_it_ended():
    reaches = [run(pair, StraightReach) for pair in pairs()]
    ends = {reach.status for reach in reaches}
    assert Status.CONVERGED in ends
    assert len(ends) > 1, "none got stuck: the pairs are too easy to tell anything"
    for reach in reaches:
        assert reach.arrived is (reach.status is Status.CONVERGED)
    lines = reach_runs.table(reaches).splitlines()
    assert len(lines) == 1 + 2 * len(names.SIDES)
