"""Insertion in physics: it fits, it jams and backs out, it is guided in, it is lost."""

import mujoco
import numpy as np
import pytest
from rig import SIDES, holding, holding_wrong
from stations import over_the_well

from prospect_mj.control.controller import CONTROL_PERIOD
from prospect_mj.control.insertion_settings import InsertionResult
from prospect_mj.control.result import Status

FORCE_CAP = 30.0
"""[N]: twice what the servo lead at the rim exerts."""
RIM, FLOOR, HALF = 0.10, 0.02, 0.085


def lowest_point(rig):
    """Of the jar's axis [m], whichever end is down."""
    axis = rig.simulation.jar_axis
    return rig.simulation.jar_position[2] - HALF * abs(axis[2])


def force_of_the_well(rig):
    """Sum of its contact forces on the jar (3,) [N], from the simulator."""
    total, force = np.zeros(3), np.zeros(6)
    for i in range(rig.data.ncon):
        contact = rig.data.contact[i]
        names = [rig.model.geom(int(geom)).name for geom in contact.geom]
        if any(name.startswith("well/") for name in names):
            mujoco.mj_contactForce(rig.model, rig.data, i, force)
            onto = contact.frame.reshape(3, 3).T @ force[:3]
            total += onto if names[1].startswith("jar/") else -onto
    return total


@pytest.mark.parametrize("side", SIDES)
def test_the_right_way_round_it_stands_on_the_floor(rig, side):
    rig.restore(holding(side))
    insertion = over_the_well(rig, side)
    above = lowest_point(rig)
    result = rig.drive(insertion)
    assert isinstance(result, InsertionResult)
    assert result.converged, result.reason
    assert not result.jammed
    assert lowest_point(rig) == pytest.approx(FLOOR, abs=2e-3)
    # The hand went as far as the jar did: nothing slipped on the way.
    assert result.depth == pytest.approx(above - lowest_point(rig), abs=0.0015)
    assert 2.0 < result.peak_force < FORCE_CAP


@pytest.mark.parametrize("side", SIDES)
@pytest.mark.parametrize("aside", [(0.006, 0), (-0.006, 0), (0, 0.006), (0, -0.006)])
def test_a_misaligned_jar_is_guided_in_by_the_chamfer(rig, side, aside):
    """6 mm aside with 4 mm of play: without yielding it would stand on the rim."""
    rig.restore(holding(side))
    controller = over_the_well(rig, side, aside)
    start = rig.simulation.jar_position
    assert np.abs(start[:2] - [0.45, 0.0]).max() > 0.004
    result = rig.drive(controller)
    assert result.converged, result.reason
    assert lowest_point(rig) == pytest.approx(FLOOR, abs=2e-3)
    assert np.abs(rig.simulation.jar_position[:2] - [0.45, 0.0]).max() < 0.0045
    assert result.peak_force < FORCE_CAP


@pytest.mark.parametrize("side", SIDES)
@pytest.mark.parametrize("aside", [(0, 0), (0.006, 0), (0, -0.006), (0.006, 0.006)])
def test_the_wrong_way_round_it_jams_and_comes_back_in_the_hand(rig, side, aside):
    rig.restore(holding_wrong(side))
    before = rig.jar_in_hand(side)
    heights, peak, lead = [], [], []

    def watch():
        heights.append(lowest_point(rig))
        peak.append(np.linalg.norm(force_of_the_well(rig)))
        own = rig.torso.arms[side].read()
        if peak[-1] > 2.0:
            lead.append(np.abs(own.joint_command - own.joints).max())

    result = rig.drive(over_the_well(rig, side, aside), hook=watch)
    assert result.status is Status.STALLED
    assert result.jammed
    assert "above the floor" in result.reason
    # The lid, 5 mm wider than the well, wedges in the 45 degree chamfer: 5 mm above.
    assert min(heights) == pytest.approx(RIM + 0.005, abs=0.004)
    assert lowest_point(rig) > RIM + 0.01
    assert rig.torso.arms[side].read().touch.found.all()
    after = rig.jar_in_hand(side)
    assert np.linalg.norm(after.position - before.position) < 3e-3
    assert 2.0 < result.peak_force < FORCE_CAP
    assert max(peak) < FORCE_CAP
    # The servos' lead on the rim is what bounds the force of a stiff contact.
    assert max(lead) < 0.02


@pytest.mark.parametrize("side", SIDES)
def test_the_wrist_feels_the_force_that_acts_on_the_jar(rig, side):
    """The peak it reports against the peak of MuJoCo's contact forces in the well."""
    rig.restore(holding_wrong(side))
    controller = over_the_well(rig, side)
    peak = []

    def watch():
        peak.append(np.linalg.norm(force_of_the_well(rig)))

    result = rig.drive(controller, hook=watch)
    assert result.peak_force == pytest.approx(max(peak), abs=3.0)


@pytest.mark.parametrize("side", SIDES)
def test_a_jar_dropped_on_the_way_is_lost(rig, side):
    rig.restore(holding(side))
    controller = over_the_well(rig, side)
    ticks = [0]

    def let_go():
        ticks[0] += 1
        if ticks[0] > 10:
            rig.torso.arms[side].command_fingers(np.full(3, 0.6))

    result = rig.drive(controller, hook=let_go)
    assert result.status is Status.LOST
    assert not result.jammed
    assert "fingertips" in result.reason


def test_the_hand_descends_no_faster_than_it_is_set_to(rig):
    rig.restore(holding("left"))
    controller = over_the_well(rig, "left")
    heights = []

    def watch():
        heights.append(rig.twin.grasp_pose("left").translation()[2])

    assert rig.drive(controller, hook=watch).converged
    speed = -np.diff(heights) / CONTROL_PERIOD
    assert 0.05 < speed.max() < 0.18
