"""A map of free cells says of every cell what a look at that cell alone says."""

import numpy as np
import pytest
from arm_scene import FAR, NO_JAR, ArmScene, in_hand, random_joints

from prospect_mj.planning.arm_body import arm_body
from prospect_mj.planning.arm_kernels import (
    FOREARM,
    HAND,
    clearances,
    link_clearance,
    link_frames,
)
from prospect_mj.planning.joint_grid import JointGrid
from prospect_mj.planning.occupancy import free_cells, room_among, wrist_at
from prospect_mj.planning.query import Chart
from prospect_mj.planning.static_map import MOST_ROOM, shoulders_and_elbows
from prospect_mj.planning.surroundings import Surroundings, body_with
from prospect_mj.robot import names, posture

MARGIN = 0.02
"""[m]"""
N = 7
"""Cells per joint."""


class Case:
    """An arm at work between a post, the other arm and perhaps a jar."""

    def __init__(self, side, held, margin=MARGIN):
        known = in_hand(side) if held else NO_JAR
        other = names.other(side)
        scene = ArmScene(known)
        scene.place_post([0.5, 0.25 * names.sign(side)])
        scene.put(other, posture.presenting(other))
        around = Surroundings(scene.model, side)
        self.body = body_with(arm_body(scene.model, side), known)
        self.fixed, self.moving = around.fixed, around.moving(scene.data, known)
        low, high = self.body.limits[:4].T
        self.grid = JointGrid(tuple(low), tuple(high), (N,) * 4)
        some = random_joints(side, np.random.default_rng(0), 4)
        self.chart = Chart(some[:, :4].copy(), some[:, 4:].copy())
        self.margin = margin

    def free(self, reach=None):
        """As the planner asks for it."""
        arm, cells = self.body.arrays, shoulders_and_elbows(self.grid)
        room = room_among(arm, *cells, self.fixed, self.margin, MOST_ROOM)
        reach = self.body.reach if reach is None else reach
        known = self.fixed, self.moving, room.astype(np.float32), self.chart
        return free_cells(arm, *cells, *known, reach, self.margin).reshape(
            self.grid.shape
        )

    def configurations(self):
        """All cells' centres with their wrists (N^4, 7) [rad]."""
        gross = self.grid.all_centres()
        wrists = np.empty((len(gross), 3))
        for k, wrist in enumerate(wrists):
            wrist_at(self.chart, gross, k, wrist)
        return np.hstack([gross, wrists])

    def clearances(self, configurations):
        rows = np.concatenate([self.fixed, self.moving])
        return clearances(self.body.arrays, configurations, rows, FAR)


@pytest.mark.parametrize("held", [False, True], ids=["empty", "with a jar"])
def test_it_is_what_every_cell_by_itself_says(side, held):
    case = Case(side, held)
    alone = case.clearances(case.configurations()).reshape(case.grid.shape)
    # A clearance within rounding of the margin may count as either.
    clear_cut = np.abs(alone - MARGIN) > 1e-6
    assert clear_cut.sum() > 0.999 * alone.size
    free = case.free()
    assert 0.1 < free.mean() < 0.9
    assert (free == (alone >= MARGIN))[clear_cut].all()


def test_a_larger_margin_leaves_fewer_cells(side):
    wide, narrow = (Case(side, False, margin).free() for margin in (0.05, 0.01))
    assert (wide <= narrow).all()
    assert wide.sum() < narrow.sum()


def test_what_moves_takes_cells_away_and_gives_no_new_ones(side):
    case = Case(side, False)
    with_all = case.free()
    case.moving = case.moving[:0]
    without = case.free()
    assert (with_all <= without).all()
    assert with_all.sum() < without.sum()


def test_where_the_hand_can_reach_nothing_it_touches_nothing_however_it_is_turned(
    side,
):
    """The shortcut: room of the wrist is at least reach and margin."""
    case = Case(side, held=True)
    arm, reach = case.body.arrays, case.body.reach
    rng = np.random.default_rng(1)
    joints = random_joints(side, rng, 3000)
    roomy = 0
    for each in joints:
        room = room_among(arm, each[None, :3], each[3:4], case.fixed, MARGIN, MOST_ROOM)
        if room[0, 0] < reach + MARGIN:
            continue
        roomy += 1
        frames = link_frames(arm, each)
        rows = case.fixed
        hand = link_clearance(arm.hand, HAND, frames, rows, FAR)
        jar = link_clearance(arm.jar, HAND, frames, rows, FAR)
        assert min(hand, jar) >= MARGIN - 1e-9
    assert roomy > 100


def test_a_reach_told_too_short_would_overlook_something(side):
    """Otherwise the shortcut would not be tested above."""
    case = Case(side, held=True)
    assert case.free(reach=0.01).sum() > case.free().sum()


def test_room_is_the_distance_of_the_wrists_centre(side):
    case = Case(side, False)
    arm, cells = case.body.arrays, shoulders_and_elbows(case.grid)
    room = room_among(arm, *cells, case.fixed, MARGIN, MOST_ROOM).ravel()
    open_ones = np.flatnonzero(room >= 0)
    assert 0 < len(open_ones) < room.size
    point = np.array([[0.0, 0.0, 0.0, 0.0]])
    point[0, :3] = arm.wrist[0]
    for k in open_ones[::7]:
        frames = link_frames(arm, case.grid.all_centres()[k])
        one_point = np.concatenate([point, point])
        expected = link_clearance(one_point, FOREARM, frames, case.fixed, MOST_ROOM)
        assert room[k] == pytest.approx(expected, abs=1e-12)


def test_the_wrist_between_known_ones_is_a_weighted_mean_of_theirs():
    known = random_joints("left", np.random.default_rng(2), 3)
    chart = Chart(known[:, :4].copy(), known[:, 4:].copy())
    wrist = np.empty(3)
    for k in range(3):
        wrist_at(chart, chart.gross, k, wrist)
        assert wrist == pytest.approx(chart.wrists[k], abs=1e-6)
    anywhere = random_joints("left", np.random.default_rng(3), 50)[:, :4].copy()
    for k in range(50):
        wrist_at(chart, anywhere, k, wrist)
        assert (wrist >= chart.wrists.min(axis=0) - 1e-12).all()
        assert (wrist <= chart.wrists.max(axis=0) + 1e-12).all()
    alone = only(chart, 0)
    wrist_at(alone, anywhere, 0, wrist)
    assert wrist == pytest.approx(chart.wrists[0])


def only(chart, k):
    return Chart(chart.gross[k : k + 1].copy(), chart.wrists[k : k + 1].copy())
