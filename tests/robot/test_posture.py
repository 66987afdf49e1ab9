"""Named postures and the preshaped grasp, checked on the compiled torso."""

import mujoco
import numpy as np
import pytest
from scipy.optimize import brentq

from prospect_mj import paths
from prospect_mj.robot import barrett_hand, posture

SIDES = ("left", "right")
POSTURES = {
    "home": posture.home,
    "presenting": posture.presenting,
    "over_well": posture.over_well,
}


@pytest.fixture(scope="module")
def model():
    return mujoco.MjModel.from_xml_path(str(paths.torso_xml()))


@pytest.mark.parametrize("side", SIDES)
@pytest.mark.parametrize("name", POSTURES)
def test_postures_keep_a_third_of_a_radian_from_every_limit(model, side, name):
    limits = np.array([model.joint(f"{side}_joint{i}").range for i in range(1, 8)])
    angles = POSTURES[name](side)
    margin = np.minimum(angles - limits[:, 0], limits[:, 1] - angles)
    assert margin.min() > 0.33


@pytest.mark.parametrize("name", POSTURES)
def test_postures_mirror(name):
    flips = np.array([-1, 1, -1, 1, -1, 1, -1])
    left, right = POSTURES[name]("left"), POSTURES[name]("right")
    assert np.array_equal(right, flips * left)


def test_home_is_the_keyframe(model):
    home = model.key("home").qpos
    for side in SIDES:
        address = [model.joint(f"{side}_joint{i}").qposadr[0] for i in range(1, 8)]
        assert home[address] == pytest.approx(posture.home(side))


@pytest.mark.parametrize("side", SIDES)
def test_contacts_with_a_nominal_cylinder_balance_in_the_grasp_frame(model, side):
    """Unit normals of three tips on a cylinder along the site's z cancel.

    The tips come from the compiled hand, each finger closed until it touches.
    """
    data = mujoco.MjData(model)
    mujoco.mj_resetDataKeyframe(model, data, 0)

    def tip(finger, angle):
        stem = f"{side}_finger{finger}"
        data.joint(f"{stem}_proximal").qpos = angle
        data.joint(f"{stem}_distal").qpos = angle / 3
        mujoco.mj_kinematics(model, data)
        return data.geom(f"{stem}_tip").xpos.copy()

    mujoco.mj_kinematics(model, data)
    site = data.site(f"{side}_grasp")
    origin, axis = site.xpos.copy(), site.xmat.reshape(3, 3)[:, 2].copy()
    touching = posture.NOMINAL_GRASP_RADIUS + 0.0095
    tips, normals = [], []
    for finger in (1, 2, 3):

        def gap(angle, finger=finger):
            offset = tip(finger, angle) - origin
            return np.linalg.norm(np.cross(axis, offset)) - touching

        place = tip(finger, brentq(gap, 0.5, 1.5))
        across = place - origin
        across -= (across @ axis) * axis
        tips.append(place)
        normals.append(-across / np.linalg.norm(across))
    tips, normals = np.array(tips), np.array(normals)
    assert np.abs(normals.sum(axis=0)).max() < 1e-6
    moment = np.cross(tips - tips.mean(axis=0), normals).sum(axis=0)
    assert np.abs(moment).max() < 1e-7
    # The site lies in the mean plane of the tips.
    assert (tips.mean(axis=0) - origin) @ axis == pytest.approx(0, abs=1e-7)


@pytest.mark.parametrize("finger", [1, 2, 3])
@pytest.mark.parametrize("angle", [0.0, 0.7, 1.4])
def test_fingertip_formula_equals_the_compiled_hand(model, finger, angle):
    data = mujoco.MjData(model)
    data.joint(f"left_finger{finger}_proximal").qpos = angle
    data.joint(f"left_finger{finger}_distal").qpos = angle / 3
    mujoco.mj_kinematics(model, data)
    palm = data.body("left_palm")
    offset = data.geom(f"left_finger{finger}_tip").xpos - palm.xpos
    expected = barrett_hand.fingertip(finger, angle)
    assert palm.xmat.reshape(3, 3).T @ offset == pytest.approx(expected, abs=1e-8)


def test_closing_planes_meet_at_the_grasp_centre():
    """Lines along the fingers' headings through their bases pass through it."""
    centre = barrett_hand.grasp_centre()
    assert centre[:2] == pytest.approx((-0.025 / np.tan(np.pi / 3), 0))
    for finger in (1, 2, 3):
        base, heading = barrett_hand.finger_base(finger)
        offset = (centre - base)[:2]
        aside = offset[0] * np.sin(heading) - offset[1] * np.cos(heading)
        assert aside == pytest.approx(0, abs=1e-12)
