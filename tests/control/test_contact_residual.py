"""Residuals and required friction of contacts, by hand-computed values."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from prospect_mj.control.contact_residual import (
    CHARACTERISTIC_LENGTH,
    contact_residual,
    meeting_point,
    required_friction,
)

RADIUS = 0.05
THIRDS = np.deg2rad([90.0, 210.0, 330.0])
AROUND = np.column_stack([np.cos(THIRDS), np.sin(THIRDS), np.zeros(3)])
ANGLE = st.floats(-np.pi, np.pi)
SMALL = st.floats(-0.3, 0.3)


def on_cylinder(offset=(0.0, 0.0)):
    """Three fingers that close along lines 120 degrees apart, the hand displaced.

    The lines pass through `offset`, the cylinder stands at the origin.
    """
    foot = np.array([*offset, 0.0])
    along = AROUND @ foot
    reach = -along + np.sqrt(along**2 - foot @ foot + RADIUS**2)
    positions = foot + reach[:, None] * AROUND
    return positions, -positions / RADIUS


def test_three_contacts_evenly_round_a_cylinder_balance():
    positions, normals = on_cylinder()
    residual = contact_residual(positions, normals)
    assert residual.force == pytest.approx(np.zeros(3), abs=1e-15)
    assert residual.moment == pytest.approx(np.zeros(3), abs=1e-15)
    assert residual.value == pytest.approx(0.0, abs=1e-29)
    assert required_friction(positions, normals) == pytest.approx(0.0, abs=1e-7)


@pytest.mark.parametrize("direction", np.deg2rad([0.0, 37.0, 90.0, 200.0]))
def test_an_offset_of_the_hand_is_felt_as_a_force(direction):
    """rho_f = -(3/2) d / r to first order, whatever the direction of d."""
    offset = 1e-4 * np.array([np.cos(direction), np.sin(direction)])
    residual = contact_residual(*on_cylinder(offset))
    expected = -1.5 * np.array([*offset, 0.0]) / RADIUS
    assert residual.force == pytest.approx(expected, rel=0.01, abs=1e-5)
    assert residual.value == pytest.approx(expected @ expected, rel=0.02)


def test_a_tilt_of_the_hand_is_felt_as_a_moment():
    """Contacts in a plane tilted by a about x: rho_m = (3/2) r/l a, and no force."""
    tilt = 1e-3
    positions, normals = on_cylinder()
    positions = positions + [0, 0, 1] * np.outer(positions[:, 1], [tilt])
    residual = contact_residual(positions, normals)
    assert residual.force == pytest.approx(np.zeros(3), abs=1e-15)
    expected = 1.5 * RADIUS / CHARACTERISTIC_LENGTH * tilt
    assert residual.moment == pytest.approx([expected, 0, 0], abs=1e-9)


def test_two_fingers_from_one_side_have_the_residual_worked_out_by_hand():
    """n = (1,0,0), (1,0,0), (-1,0,0) at y = +-0.02 and 0: force 1, no moment."""
    positions = np.array([[-0.04, 0.02, 0], [-0.04, -0.02, 0], [0.04, 0, 0]])
    normals = np.array([[1.0, 0, 0], [1.0, 0, 0], [-1.0, 0, 0]])
    residual = contact_residual(positions, normals)
    assert residual.force == pytest.approx([1, 0, 0])
    assert residual.moment == pytest.approx([0, 0, 0], abs=1e-15)
    assert residual.value == pytest.approx(1.0)


def test_a_couple_has_a_moment_and_no_force():
    """Opposite unit forces 0.02 m apart: moment 0.02 / l about z."""
    positions = np.array([[-0.04, 0.01, 0], [0.04, -0.01, 0]])
    normals = np.array([[1.0, 0, 0], [-1.0, 0, 0]])
    residual = contact_residual(positions, normals)
    assert residual.force == pytest.approx(np.zeros(3))
    assert residual.moment == pytest.approx([0, 0, -0.02 / CHARACTERISTIC_LENGTH])


@given(ANGLE, ANGLE, ANGLE, SMALL, SMALL, SMALL, st.floats(-0.01, 0.01))
def test_residual_and_friction_do_not_depend_on_the_frame(a, b, c, x, y, z, offset):
    positions, normals = on_cylinder((offset, 0.004))
    turn = Rotation.from_euler("xyz", [a, b, c])
    moved, turned = turn.apply(positions) + [x, y, z], turn.apply(normals)
    here, there = contact_residual(positions, normals), contact_residual(moved, turned)
    assert there.value == pytest.approx(here.value, abs=1e-9)
    assert there.force == pytest.approx(turn.apply(here.force), abs=1e-9)
    assert there.moment == pytest.approx(turn.apply(here.moment), abs=1e-9)
    friction = required_friction(positions, normals)
    assert required_friction(moved, turned) == pytest.approx(friction, abs=1e-6)


@given(st.permutations([0, 1, 2]), st.floats(-0.01, 0.01), st.floats(-0.01, 0.01))
def test_the_order_of_the_fingers_does_not_matter(order, x, y):
    positions, normals = on_cylinder((x, y))
    here = contact_residual(positions, normals)
    there = contact_residual(positions[order], normals[order])
    assert there.value == pytest.approx(here.value, abs=1e-12)
    friction = required_friction(positions, normals)
    assert required_friction(positions[order], normals[order]) == pytest.approx(
        friction, abs=1e-9
    )


def test_normals_of_a_cylinder_meet_on_its_axis():
    positions, normals = on_cylinder((0.006, -0.003))
    assert meeting_point(positions, normals)[:2] == pytest.approx([0, 0], abs=1e-12)


def test_normals_that_miss_each_other_meet_in_the_middle_by_least_squares():
    """Three lines that form an equilateral triangle: its centre."""
    aside = 0.003 * np.column_stack([-AROUND[:, 1], AROUND[:, 0], np.zeros(3)])
    point = meeting_point(RADIUS * AROUND + aside, -AROUND)
    assert point[:2] == pytest.approx([0, 0], abs=1e-12)


def test_friction_of_normals_turned_by_an_angle_is_its_tangent():
    """Balanced positions, every normal turned by 20 degrees about z."""
    turn = Rotation.from_euler("z", 20, degrees=True)
    friction = required_friction(RADIUS * AROUND, turn.apply(-AROUND))
    assert friction == pytest.approx(np.tan(np.deg2rad(20.0)))


def test_three_forces_from_one_half_can_never_balance():
    """Contacts within 120 degrees of a cylinder's circle: no friction is enough."""
    angles = np.deg2rad([60.0, 90.0, 120.0])
    around = np.column_stack([np.cos(angles), np.sin(angles), np.zeros(3)])
    assert required_friction(RADIUS * around, -around) == float("inf")


def test_contacts_just_over_half_way_round_can_balance():
    angles = np.deg2rad([0.0, 91.0, 182.0])
    around = np.column_stack([np.cos(angles), np.sin(angles), np.zeros(3)])
    assert required_friction(RADIUS * around, -around) < 1e-6


def test_pulling_contacts_can_never_balance():
    """Normals that point away from each other would have to pull."""
    assert required_friction(RADIUS * AROUND, AROUND) == float("inf")
