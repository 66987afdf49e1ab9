"""Where a cylinder sits in a hand, from three contacts on it."""

import mink
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from rig import angle_between

from prospect_mj.actions import poses
from prospect_mj.actions.held import felt_jar
from prospect_mj.robot.torso import Touch

TURN = st.tuples(*[st.floats(-1.2, 1.2)] * 3)
ANGLES = np.deg2rad([80.0, 200.0, 330.0])
HEIGHTS = np.array([0.055, 0.060, 0.052])


def touch_of(jar, radius=0.036):
    """What three fingertips feel of a cylinder: exact contacts on its surface."""
    around = np.column_stack([np.cos(ANGLES), np.sin(ANGLES), np.zeros(3)])
    local = radius * around + np.outer(HEIGHTS, [0, 0, 1])
    matrix = jar.rotation().as_matrix()
    return Touch(
        found=np.ones(3, bool),
        force=np.full(3, 15.0),
        shear=np.zeros(3),
        position=local @ matrix.T + jar.translation(),
        normal=-around @ matrix.T,
    )


@given(TURN, TURN, st.floats(-0.01, 0.01), st.floats(-0.01, 0.01))
def test_touch_tells_axis_and_place_across_it(turn, error, x, y):
    """Knowledge that is off by 10 mm and some degrees is put right but for two DoF."""
    jar = poses.pose(mink.SO3.exp(np.array(turn)), np.array([0.5, 0.1, 0.4]))
    wrong = mink.SE3.from_rotation_and_translation(
        mink.SO3.exp(0.1 * np.array(error)), np.array([x, y, 0.0])
    )
    known = jar @ wrong
    felt = felt_jar(touch_of(jar), known)
    axis = jar.rotation().as_matrix()[:, 2]
    assert angle_between(felt.rotation().as_matrix()[:, 2], axis) < 1e-6
    offset = felt.translation() - jar.translation()
    assert np.linalg.norm(offset - (offset @ axis) * axis) < 1e-9


def test_the_place_along_the_axis_is_kept_from_before():
    jar = poses.pose(mink.SO3.identity(), np.array([0.5, 0.1, 0.4]))
    known = jar @ mink.SE3.from_translation(np.array([0.004, 0.0, 0.007]))
    felt = felt_jar(touch_of(jar), known)
    assert felt.translation() == pytest.approx([0.5, 0.1, 0.407], abs=1e-9)


def test_the_sense_of_the_axis_is_kept_from_before():
    """Three normals can't tell one end from the other."""
    jar = poses.pose(mink.SO3.identity(), np.array([0.5, 0.1, 0.4]))
    turned = jar @ mink.SE3.from_rotation(mink.SO3.from_x_radians(np.pi - 0.05))
    felt = felt_jar(touch_of(jar), turned)
    assert felt.rotation().as_matrix()[:, 2] == pytest.approx([0, 0, -1], abs=1e-6)


def test_the_radius_does_not_matter():
    jar = poses.pose(mink.SO3.exp(np.array([0.2, 0.1, 0.0])), np.array([0.5, 0.1, 0.4]))
    for radius in (0.036, 0.045):
        felt = felt_jar(touch_of(jar, radius), jar)
        assert felt.translation() == pytest.approx(jar.translation(), abs=1e-9)
