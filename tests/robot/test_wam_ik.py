"""Closed-form inverse kinematics against the compiled model's forward kinematics."""

import numpy as np
import pytest

from prospect_mj.control.kinematics import KinematicTwin
from prospect_mj.robot import names, posture, wam, wam_ik
from prospect_mj.sim.scene import SceneSettings

SIDES = names.SIDES
LOW, HIGH = np.array(wam.JOINT_LIMITS).T
ROUNDING = 1e-9
"""The model file is rounded to nanometres [m, rad]."""
SWIVELS = np.linspace(-np.pi, np.pi, 32, endpoint=False)
REFLECTION = np.diag([1.0, -1.0, 1.0])


@pytest.fixture(scope="module")
def twin():
    return KinematicTwin(SceneSettings())


def pose_of(twin, side, joints):
    """Position (3,) [m] and rotation (3, 3) of the grasp site, by MuJoCo."""
    angles = twin.configuration.q.copy()
    angles[twin.columns(side)] = joints
    twin.configuration.update(angles)
    site = twin.configuration.data.site(names.grasp_site(side))
    return site.xpos.copy(), site.xmat.reshape(3, 3).copy()


def random_joints(side, rng):
    return posture.reflected(tuple(rng.uniform(LOW, HIGH)), side)


def about_z(angle):
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1.0]])


@pytest.mark.parametrize("side", SIDES)
def test_every_solution_holds_the_grasp_site_at_the_pose(twin, side):
    rng = np.random.default_rng(0)
    found = 0
    for _ in range(100):
        position, rotation = pose_of(twin, side, random_joints(side, rng))
        swivels = rng.uniform(-np.pi, np.pi, 8)
        for joints in wam_ik.solutions(side, position, rotation, swivels):
            reached, turned = pose_of(twin, side, joints)
            assert reached == pytest.approx(position, abs=ROUNDING)
            assert turned == pytest.approx(rotation, abs=ROUNDING)
            found += 1
    assert found > 300


@pytest.mark.parametrize("side", SIDES)
def test_the_joint_angles_behind_a_pose_are_among_its_solutions(twin, side):
    rng = np.random.default_rng(1)
    for _ in range(100):
        joints = random_joints(side, rng)
        own = np.array([wam_ik.swivel(side, joints)])
        found = wam_ik.solutions(side, *pose_of(twin, side, joints), own)
        # Where the elbow is stretched or folded its angle goes as the root of a
        # distance, and so of the rounding.
        assert np.abs(found - joints).max(axis=1).min() < 1e-4
        assert len(found) <= 8


@pytest.mark.parametrize("side", SIDES)
def test_solutions_have_the_swivel_that_was_asked_for(twin, side):
    rng = np.random.default_rng(2)
    position, rotation = pose_of(twin, side, posture.over_well(side))
    for asked in rng.uniform(-np.pi, np.pi, 200):
        for joints in wam_ik.solutions(side, position, rotation, np.array([asked])):
            error = wam_ik.swivel(side, joints) - asked
            assert np.mod(error + np.pi, 2 * np.pi) == pytest.approx(np.pi, abs=1e-7)


def test_all_branches_of_elbow_shoulder_and_wrist_occur(twin):
    """Elbow either way, J2 and J6 of either sign: 8 combinations over random poses."""
    rng = np.random.default_rng(3)
    branches = set()
    for _ in range(100):
        pose = pose_of(twin, "left", random_joints("left", rng))
        found = wam_ik.solutions("left", *pose, SWIVELS)
        straight = np.arctan2(wam.ELBOW_OFFSET, wam.UPPER_ARM) + np.arctan2(
            wam.ELBOW_OFFSET, wam.FOREARM
        )
        sides = np.column_stack([found[:, 3] > straight, found[:, [1, 5]] > 0])
        branches |= {tuple(row) for row in sides.tolist()}
    assert len(branches) == 8


def test_the_right_arm_is_the_left_ones_reflection(twin):
    rng = np.random.default_rng(4)
    for _ in range(30):
        position, rotation = pose_of(twin, "left", random_joints("left", rng))
        left = wam_ik.solutions("left", position, rotation, SWIVELS)
        mirrored = REFLECTION @ position, REFLECTION @ rotation @ REFLECTION
        right = wam_ik.solutions("right", *mirrored, SWIVELS)
        assert right == pytest.approx(left * wam.MIRROR)


@pytest.mark.parametrize("side", SIDES)
@pytest.mark.parametrize("margin", [0.0, 0.15])
def test_joint_limits_are_kept_and_whole_turns_are_used(twin, side, margin):
    rng = np.random.default_rng(5)
    below = above = 0
    for _ in range(60):
        pose = pose_of(twin, side, random_joints(side, rng))
        found = wam_ik.solutions(side, *pose, SWIVELS, margin)
        left = posture.reflected(found, side)
        assert (left >= LOW + margin).all()
        assert (left <= HIGH - margin).all()
        # J5 goes beyond half a turn: an angle in (-pi, pi] would miss it.
        below += (left[:, 4] < -np.pi).sum()
        above += (left[:, 4] > 0).sum()
    assert below > 50
    assert above > 50


def test_a_larger_margin_leaves_exactly_the_solutions_inside_of_it(twin):
    pose = pose_of(twin, "left", posture.home("left"))
    every = wam_ik.solutions("left", *pose, SWIVELS)
    inside = ((every >= LOW + 0.3) & (every <= HIGH - 0.3)).all(axis=1)
    assert 0 < inside.sum() < len(every)
    fewer = wam_ik.solutions("left", *pose, SWIVELS, margin=0.3)
    assert np.array_equal(fewer, every[inside])


@pytest.mark.parametrize("side", SIDES)
@pytest.mark.parametrize("offset", [(2.0, 0, 0), (0, 0, -3.0)])
def test_a_pose_out_of_reach_has_no_solution(twin, side, offset):
    position, rotation = pose_of(twin, side, posture.home(side))
    far = position + offset
    assert wam_ik.solutions(side, far, rotation, SWIVELS).shape == (0, 7)
    free = wam_ik.solutions_free_roll(side, far, rotation, SWIVELS, SWIVELS)
    assert free.shape == (0, 7)


def test_a_wrist_too_near_to_the_shoulder_has_no_solution(twin):
    """The folded elbow keeps sqrt(2 a^2 + d3^2 + d5^2 - 2 ...) = 0.25 m of distance."""
    shoulder = np.array([0.0, 0.22, 0.55])
    hand = 0.06 + posture.grasp_frame()[0][2]
    inwards = shoulder + [0, 0, hand + 0.1]
    assert wam_ik.solutions("left", inwards, np.eye(3), SWIVELS).shape == (0, 7)


@pytest.mark.parametrize("side", SIDES)
def test_with_free_roll_the_palms_axis_and_place_stay(twin, side):
    rng = np.random.default_rng(6)
    rolls = np.linspace(-np.pi, np.pi, 12, endpoint=False)
    position, rotation = pose_of(twin, side, posture.presenting(side))
    found = wam_ik.solutions_free_roll(side, position, rotation, SWIVELS, rolls)
    used = set()
    for joints in rng.permutation(found)[:200]:
        reached, turned = pose_of(twin, side, joints)
        assert reached == pytest.approx(position, abs=ROUNDING)
        assert turned[:, 2] == pytest.approx(rotation[:, 2], abs=ROUNDING)
        relative = rotation.T @ turned
        roll = np.arctan2(relative[1, 0], relative[0, 0])
        used.add(int(np.argmin(np.abs(np.sin((rolls - roll) / 2)))))
        nearest = rolls[np.argmin(np.abs(np.sin((rolls - roll) / 2)))]
        assert turned == pytest.approx(rotation @ about_z(nearest), abs=1e-8)
    assert len(used) > 3


def test_a_wrist_on_the_axis_of_the_first_joint_is_no_exception(twin):
    """There swivel 0 has no plane; every solution must be right all the same."""
    position, rotation = pose_of(twin, "left", np.zeros(7))
    found = wam_ik.solutions("left", position, rotation, SWIVELS)
    assert len(found) >= 8
    for joints in found:
        reached, turned = pose_of(twin, "left", joints)
        assert reached == pytest.approx(position, abs=ROUNDING)
        assert turned == pytest.approx(rotation, abs=ROUNDING)
