"""The compiled torso has the published dimensions, masses and limits.

The numbers are written out again here, from the sources and not from the package: WAM
7-DoF Denavit-Hartenberg table and joint limits (manual D1001 AH.00 p. 64-65), link
masses (libbarrett wam7w.conf), effort limits (barrett_model URDF), BarrettHand Craig
parameters (BH8-262 manual p. 75) and ranges (GraspIt, OpenRAVE).
"""

import mujoco
import numpy as np
import pytest

from prospect_mj import paths

ARM_LIMITS = [
    (-2.6, 2.6),
    (-2.0, 2.0),
    (-2.8, 2.8),
    (-0.9, 3.1),
    (-4.76, 1.24),
    (-1.6, 1.6),
    (-3.0, 3.0),
]
"""[rad], in the sense of the published table: that of the left arm."""
ARM_EFFORTS = [60, 60, 45, 30, 10, 10, 10]
ARM_MASSES = [10.77, 3.87, 1.80, 2.17, 0.357, 0.409, 0.075]
REFLECTED = [-1, 1, -1, 1, -1, 1, -1]
"""Joints about z turn the other way in the mirror, those about y do not."""
SIDES = ("left", "right")


@pytest.fixture(scope="module")
def model():
    return mujoco.MjModel.from_xml_path(str(paths.torso_xml()))


@pytest.fixture(scope="module")
def straight(model):
    """State with all joints at zero: the arm of the Denavit-Hartenberg table."""
    data = mujoco.MjData(model)
    data.qpos[:] = 0
    mujoco.mj_forward(model, data)
    return data


def in_base(data, side, point):
    base = data.body(f"{side}_base")
    return base.xmat.reshape(3, 3).T @ (point - base.xpos)


def anchors(data, side):
    names = [f"{side}_joint{i}" for i in range(1, 8)]
    return [in_base(data, side, data.joint(name).xanchor) for name in names]


@pytest.mark.parametrize("side", SIDES)
def test_arm_has_the_published_link_lengths(straight, side):
    """a3 = 0.045, d3 = 0.55, a4 = -0.045, d5 = 0.30, d7 = 0.06 m; the rest are 0."""
    places = anchors(straight, side)
    expected = [
        (0, 0, 0),
        (0, 0, 0),
        (0, 0, 0),
        (0.045, 0, 0.55),
        (0, 0, 0.55),
        (0, 0, 0.85),
        (0, 0, 0.85),
    ]
    for place, wanted in zip(places, expected, strict=True):
        assert place == pytest.approx(wanted, abs=1e-9)
    flange = in_base(straight, side, straight.body(f"{side}_palm").xpos)
    assert flange == pytest.approx((0, 0, 0.91), abs=1e-9)


@pytest.mark.parametrize("side", SIDES)
def test_joint_axes_alternate_as_the_twists_of_the_table_say(straight, side):
    base = straight.body(f"{side}_base").xmat.reshape(3, 3)
    for i, axis in enumerate("zyzyzyz", start=1):
        direction = base.T @ straight.joint(f"{side}_joint{i}").xaxis
        assert direction == pytest.approx(np.eye(3)["xyz".index(axis)], abs=1e-9)


@pytest.mark.parametrize("side", SIDES)
def test_arm_has_the_published_joint_limits(model, side):
    for i, (low, high) in enumerate(ARM_LIMITS):
        if side == "right" and REFLECTED[i] < 0:
            low, high = -high, -low
        name = f"{side}_joint{i + 1}"
        assert model.joint(name).limited[0]
        assert model.joint(name).range == pytest.approx((low, high))
        assert model.actuator(name).ctrlrange == pytest.approx((low, high))


@pytest.mark.parametrize("side", SIDES)
def test_arm_has_the_published_efforts(model, side):
    """Both at the joint, so that the weight counts, and at the motor."""
    for i, effort in enumerate(ARM_EFFORTS, start=1):
        joint = model.joint(f"{side}_joint{i}")
        assert model.jnt_actfrclimited[joint.id]
        assert model.jnt_actfrcrange[joint.id] == pytest.approx((-effort, effort))
        motor = model.actuator(f"{side}_joint{i}")
        assert motor.forcelimited[0]
        assert motor.forcerange == pytest.approx((-effort, effort))


@pytest.mark.parametrize("side", SIDES)
def test_masses_are_the_published_ones(model, side):
    links = [model.body(f"{side}_link{i}").mass[0] for i in range(1, 8)]
    assert links == pytest.approx(ARM_MASSES)
    assert model.body(f"{side}_palm").subtreemass[0] == pytest.approx(1.18)


@pytest.mark.parametrize("side", SIDES)
def test_arms_and_hands_carry_their_own_weight_with_their_motors(model, side):
    """Gravity compensation as on the WAM: by torque, which counts against its limit."""
    for body in range(model.nbody):
        if model.body(body).name.startswith((f"{side}_link", f"{side}_palm")):
            assert model.body_gravcomp[body] == 1
    for i in range(1, 8):
        assert model.jnt_actgravcomp[model.joint(f"{side}_joint{i}").id]


@pytest.mark.parametrize("side", SIDES)
def test_fingers_have_the_published_base_places(straight, side):
    """Aw = 25 mm, A1 = 50 mm; spread 60 degrees; F3 fixed on the palm's midline."""
    palm = straight.body(f"{side}_palm")
    turn, mirror = palm.xmat.reshape(3, 3).T, 1 if side == "left" else -1
    half, root = 0.5, np.sqrt(0.75)
    expected = {
        1: (0.050 * half, mirror * (0.025 + 0.050 * root)),
        2: (0.050 * half, -mirror * (0.025 + 0.050 * root)),
        3: (-0.050, 0.0),
    }
    for finger, place in expected.items():
        anchor = straight.joint(f"{side}_finger{finger}_proximal").xanchor
        offset = turn @ (anchor - palm.xpos)
        assert offset[:2] == pytest.approx(place, abs=1e-8)
        # Dw is 76 mm on the BH8-280; the palm of the model is half a millimetre lower.
        assert offset[2] == pytest.approx(0.076, abs=6e-4)


@pytest.mark.parametrize("side", SIDES)
@pytest.mark.parametrize("finger", [1, 2, 3])
def test_fingers_have_the_published_lengths(model, straight, side, finger):
    """A2 = 70 mm, A3 = 50 mm, D3 = 9.5 mm and a distal bend of Phi3 = 50 degrees."""
    stem = f"{side}_finger{finger}"
    knuckle = straight.joint(f"{stem}_proximal").xanchor
    middle = straight.joint(f"{stem}_distal").xanchor
    tip = straight.geom(f"{stem}_tip").xpos
    proximal, distal = middle - knuckle, tip - middle
    assert np.linalg.norm(proximal) == pytest.approx(0.070)
    assert np.linalg.norm(distal) == pytest.approx(0.050)
    assert model.geom(f"{stem}_tip").size[0] == pytest.approx(0.0095)
    bend = np.degrees(np.arccos(proximal @ distal / 0.070 / 0.050))
    assert bend == pytest.approx(50.0)


@pytest.mark.parametrize("side", SIDES)
@pytest.mark.parametrize("finger", [1, 2, 3])
def test_fingers_have_the_published_ranges(model, side, finger):
    for link, degrees in (("proximal", 140.0), ("distal", 48.0)):
        joint = model.joint(f"{side}_finger{finger}_{link}")
        assert joint.limited[0]
        assert np.degrees(joint.range) == pytest.approx((0.0, degrees))
        motor = model.actuator(f"{side}_finger{finger}_{link}")
        assert np.degrees(motor.ctrlrange) == pytest.approx((0.0, degrees))
        assert motor.forcelimited[0]


@pytest.mark.parametrize("side", SIDES)
def test_each_wrist_has_force_and_torque_and_each_fingertip_touch(model, side):
    kinds = mujoco.mjtSensor
    for name, kind in (("force", kinds.mjSENS_FORCE), ("torque", kinds.mjSENS_TORQUE)):
        sensor = model.sensor(f"{side}_wrist_{name}")
        assert sensor.type[0] == kind
        assert sensor.objid[0] == model.site(f"{side}_wrist").id
    # The wrist's sensor carries the whole hand: it sits between flange and palm.
    site = model.site(f"{side}_wrist")
    assert model.body(site.bodyid[0]).name == f"{side}_palm"
    for finger in (1, 2, 3):
        sensor = model.sensor(f"{side}_finger{finger}_touch")
        assert sensor.type[0] == kinds.mjSENS_CONTACT
        assert sensor.objid[0] == model.geom(f"{side}_finger{finger}_tip").id


def test_the_head_has_a_stereo_pair(model):
    left, right = model.camera("left_eye"), model.camera("right_eye")
    assert left.fovy[0] == right.fovy[0]
    for eye in (left, right):
        assert eye.mode[0] == mujoco.mjtCamLight.mjCAMLIGHT_FIXED
        assert model.body(eye.bodyid[0]).name == "head"
    assert left.pos == pytest.approx(right.pos * [1, -1, 1])
    assert left.pos[1] > 0
