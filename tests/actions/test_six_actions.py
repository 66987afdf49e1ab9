"""The six actions in physics, each from the state that the others lead to."""

import numpy as np
import pytest
from rig import GRASP, INSERT, OTHER, SIDES, SWAP_FROM, angle_between

from prospect_mj.actions.action import Action, ActionResult

PLACES = [
    ((0.0, 0.0, 0.0), 0.0),
    ((0.02, -0.02, 0.01), np.deg2rad(10)),
    ((-0.02, 0.02, -0.01), np.deg2rad(-10)),
]
"""Nominal, and two corners of the reset distribution: offset [m], yaw [rad]."""
VISION_BIAS = (0.002, -0.001, 0.002)
LONGEST = 10.0
"""Of any action that succeeds [s]."""


def stands_in_the_well(rig):
    position, axis = rig.simulation.jar_position, rig.simulation.jar_axis
    upright = axis[2] > 0.99
    return upright and np.allclose(position, [0.45, 0, 0.105], atol=0.006)


def belief_error(rig, side):
    """(across [m], along [m], angle [rad]) of the believed against the true jar."""
    jar = rig.arms[side].grasp_pose() @ rig.belief.held[side]
    axis = rig.simulation.jar_axis
    offset = jar.translation() - rig.simulation.jar_position
    along = abs(offset @ axis)
    across = np.linalg.norm(offset - (offset @ axis) * axis)
    angle = angle_between(jar.rotation().as_matrix()[:, 2], axis)
    return across, along, min(angle, np.pi - angle)


def held_by(rig):
    touch = {side: rig.torso.arms[side].read().touch.found for side in SIDES}
    return {side for side, found in touch.items() if found.all()}


def test_the_actions_are_the_papers_in_its_order():
    assert [action.label for action in Action] == [
        "grasp-left",
        "grasp-right",
        "swap-left-to-right",
        "swap-right-to-left",
        "insert-left",
        "insert-right",
    ]
    assert [int(action) for action in Action] == list(range(6))


@pytest.mark.parametrize("lid", SIDES)
@pytest.mark.parametrize(("offset", "yaw"), PLACES)
def test_grasp_by_the_lid_and_insert(rig, lid, offset, yaw):
    rig.present(lid, offset, yaw, VISION_BIAS)
    (grasped,) = rig.act(GRASP[lid])
    assert grasped.result is ActionResult.SUCCESS
    assert rig.belief.holding == lid
    assert held_by(rig) == {lid}
    rig.sense()
    assert rig.is_presenting(lid)
    assert rig.is_home(OTHER[lid])
    (inserted,) = rig.act(INSERT[lid])
    assert inserted.result is ActionResult.SUCCESS
    assert rig.belief.holding is None
    assert held_by(rig) == set()
    assert stands_in_the_well(rig)
    assert rig.is_home("left")
    assert rig.is_home("right")
    assert max(grasped.sim_seconds, inserted.sim_seconds) < LONGEST


@pytest.mark.parametrize("lid", SIDES)
@pytest.mark.parametrize(("offset", "yaw"), PLACES[1:])
def test_grasp_by_the_base_jam_swap_and_insert(rig, lid, offset, yaw):
    """The nominal place is that of the same trial in `test_observed_events.py`."""
    other = OTHER[lid]
    rig.present(lid, offset, yaw, VISION_BIAS)
    (grasped,) = rig.act(GRASP[other])
    assert grasped.result is ActionResult.SUCCESS
    before = rig.jar_in_hand(other)
    (jammed,) = rig.act(INSERT[other])
    assert jammed.result is ActionResult.JAMMED
    assert rig.belief.holding == other
    assert held_by(rig) == {other}
    assert rig.is_presenting(other)
    rig.sense()
    # A wedge of 45 degrees is a hard knock: still in the hand, and known where.
    across, along, angle = belief_error(rig, other)
    assert across < 1e-3
    assert along < 3e-3
    assert angle < np.deg2rad(0.5)
    moved = rig.jar_in_hand(other).position - before.position
    assert np.linalg.norm(moved) < 0.012
    (swapped,) = rig.act(SWAP_FROM[other])
    assert swapped.result is ActionResult.SUCCESS
    assert rig.belief.holding == lid
    assert held_by(rig) == {lid}
    assert rig.is_presenting(lid)
    assert rig.is_home(other)
    (inserted,) = rig.act(INSERT[lid])
    assert inserted.result is ActionResult.SUCCESS
    assert stands_in_the_well(rig)
    outcomes = (grasped, jammed, swapped, inserted)
    assert max(outcome.sim_seconds for outcome in outcomes) < LONGEST


@pytest.mark.parametrize("lid", SIDES)
def test_swap_there_and_back_keeps_the_jar_and_the_belief(rig, lid):
    rig.present(lid)
    rig.act(GRASP[lid])
    for giver in (lid, OTHER[lid]) * 2:
        (outcome,) = rig.act(SWAP_FROM[giver])
        assert outcome.result is ActionResult.SUCCESS
        taker = OTHER[giver]
        assert held_by(rig) == {taker}
        assert list(rig.belief.held) == [taker]
        rig.sense()
        across, along, angle = belief_error(rig, taker)
        assert across < 1e-3
        assert along < 6e-3
        assert angle < np.deg2rad(0.5)


@pytest.mark.parametrize("side", SIDES)
@pytest.mark.parametrize("lid", SIDES)
def test_after_a_grasp_the_robot_feels_where_the_jar_is(rig, side, lid):
    """Less than 1 mm across and 0.5 degrees, although it was seen 3 mm aside."""
    rig.present(lid, bias=(0.003, 0.0, -0.003))
    (outcome,) = rig.act(GRASP[side])
    assert outcome.result is ActionResult.SUCCESS
    rig.sense()
    across, along, angle = belief_error(rig, side)
    assert across < 1e-3
    assert along < 3e-3
    assert angle < np.deg2rad(0.5)


@pytest.mark.parametrize("side", SIDES)
def test_slip_between_two_actions_is_below_half_a_millimetre(rig, side):
    """2 s in the presenting hand, straight after the grasp, in its own frame."""
    rig.present(lid=side)
    rig.act(GRASP[side])
    rig.wait(0.2)
    before = rig.jar_in_hand(side)
    rig.wait(2.0)
    after = rig.jar_in_hand(side)
    assert np.linalg.norm(after.position - before.position) < 5e-4
    assert angle_between(before.axis, after.axis) < np.deg2rad(0.2)


@pytest.mark.parametrize("side", SIDES)
def test_an_outcome_lists_its_controllers_and_adds_up_their_time(rig, side):
    rig.present(lid=side)
    before = rig.data.time
    (outcome,) = rig.act(GRASP[side])
    assert outcome.executed
    assert outcome.action is GRASP[side]
    assert outcome.sim_seconds == pytest.approx(rig.data.time - before)
    runs = [run.name for run in outcome.runs]
    assert runs[:2] == ["HarmonicReach", "HandMotion"]
    assert "GraspController" in runs
    assert "Weighing" in runs
    assert all(run.side == side for run in outcome.runs)
    # Only the reach and the opening hand run at the same time.
    in_turn = sum(
        run.result.seconds for run in outcome.runs if run.name != "HandMotion"
    )
    assert outcome.sim_seconds == pytest.approx(in_turn, abs=0.3)


@pytest.mark.parametrize("side", SIDES)
def test_the_same_presentation_gives_the_same_actions_bit_by_bit(rig, side):
    states = []
    for _ in range(2):
        rig.present(side, (0.01, 0.01, 0.0), 0.1, VISION_BIAS)
        rig.act(GRASP[side], SWAP_FROM[side])
        states.append(rig.simulation.save())
    assert np.array_equal(*states)


def test_what_happened_before_does_not_matter_to_a_new_trial(rig):
    """Controllers keep nothing from one trial to the next."""
    rig.present("left")
    rig.act(GRASP["left"], INSERT["left"])
    clean = rig.simulation.save()
    rig.present("right", (0.02, 0.0, 0.0), -0.1, bias=(0.0, 0.08, 0.0))
    rig.act(GRASP["left"], GRASP["right"])
    rig.present("left")
    rig.act(GRASP["left"], INSERT["left"])
    assert np.array_equal(rig.simulation.save(), clean)
