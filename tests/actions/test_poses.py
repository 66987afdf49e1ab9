"""Geometry of the poses that actions aim for."""

import mink
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from rig import angle_between

from prospect_mj.actions import poses

UNIT = st.tuples(*[st.floats(-1, 1)] * 3).filter(lambda v: np.linalg.norm(v) > 0.1)
TURN = st.tuples(*[st.floats(-1.5, 1.5)] * 3)


def normalised(vector):
    return np.array(vector) / np.linalg.norm(vector)


@given(TURN, UNIT)
def test_turning_to_a_direction_is_the_smallest_turn_that_does_it(turn, direction):
    rotation, direction = mink.SO3.exp(np.array(turn)), normalised(direction)
    turned = poses.turned_to(rotation, direction)
    z = rotation.as_matrix()[:, 2]
    assert turned.as_matrix()[:, 2] == pytest.approx(direction, abs=1e-6)
    angle = np.linalg.norm((rotation.inverse() @ turned).log())
    assert angle == pytest.approx(angle_between(z, direction), abs=1e-5)


@pytest.mark.parametrize("sign", [1, -1])
def test_turning_to_the_same_or_opposite_direction(sign):
    rotation = mink.SO3.exp(np.array([0.3, -0.4, 1.0]))
    z = rotation.as_matrix()[:, 2]
    turned = poses.turned_to(rotation, sign * z).as_matrix()
    assert turned[:, 2] == pytest.approx(sign * z, abs=1e-9)
    assert np.linalg.det(turned) == pytest.approx(1.0)


def test_backing_off_goes_against_the_palm_and_raising_goes_up():
    hand = poses.pose(mink.SO3.from_x_radians(np.pi / 2), np.array([0.1, 0.2, 0.3]))
    assert hand.rotation().as_matrix()[:, 2] == pytest.approx([0, -1, 0])
    assert poses.backed_off(hand, 0.1).translation() == pytest.approx([0.1, 0.3, 0.3])
    assert poses.raised(hand, 0.1).translation() == pytest.approx([0.1, 0.2, 0.4])


def test_each_hand_takes_its_own_end_with_the_palm_towards_the_middle():
    centre, axis = np.array([0.6, 0.0, 0.2]), np.array([0.0, 1.0, 0.0])
    point, palm = poses.end_of_jar("left", centre, axis, 0.06)
    assert point == pytest.approx([0.6, 0.06, 0.2])
    assert palm == pytest.approx([0, -1, 0])
    point, palm = poses.end_of_jar("right", centre, axis, 0.06)
    assert point == pytest.approx([0.6, -0.06, 0.2])
    assert palm == pytest.approx([0, 1, 0])


@pytest.mark.parametrize("side", ["left", "right"])
@given(TURN, TURN, UNIT)
def test_a_held_jar_comes_where_it_is_wanted_with_its_gripped_end_up(
    side, turn, grip, up
):
    hand = poses.pose(mink.SO3.exp(np.array(turn)), np.array([0.5, 0.1, 0.4]))
    held = poses.pose(mink.SO3.exp(np.array(grip)), np.array([0.001, 0.002, 0.058]))
    centre, up = np.array([0.45, 0.0, 0.3]), normalised(up)
    target = poses.jar_over(side, hand, held, centre, up)
    jar = target @ held
    assert jar.translation() == pytest.approx(centre, abs=1e-9)
    gripped_end = jar.rotation().as_matrix()[:, 2] * (1 if side == "left" else -1)
    assert gripped_end == pytest.approx(up, abs=1e-6)
