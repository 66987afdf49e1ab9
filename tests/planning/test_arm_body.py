"""An arm of spheres and frames is the model's arm, never nearer than it looks."""

import mink
import numpy as np
import pytest
from arm_scene import (
    FAR,
    IN_HAND,
    JAR,
    NO_JAR,
    ArmScene,
    TrueClearance,
    in_hand,
    random_joints,
    site_pose,
)

from prospect_mj.planning.arm_body import arm_body, geoms_of
from prospect_mj.planning.arm_kernels import (
    FOLDED,
    clearances,
    hand_clearance,
    link_frames,
    upper_arm_solids,
)
from prospect_mj.planning.surroundings import KnownJars, Surroundings, body_with
from prospect_mj.robot import names, posture

NEAR = 0.05
"""Clearances of which a planner's margin can be [m]."""
LYING = mink.SE3.from_rotation_and_translation(
    mink.SO3.from_x_radians(1.5), np.array([0.5, 0.05, 0.4])
)
JARS = {
    "none": lambda side: NO_JAR,
    "held": in_hand,
    "held by the other": lambda side: in_hand(names.other(side)),
    "lying": lambda side: KnownJars(JAR, placed=LYING),
}


def frames_of(scene, side):
    """MuJoCo's frames (7, 12) of an arm's links."""
    bodies = [scene.data.body(name) for name in names.arm_links(side)]
    return np.array([np.concatenate([body.xpos, body.xmat]) for body in bodies])


def test_frames_are_mujocos_at_any_joint_angles(side):
    scene = ArmScene()
    body = arm_body(scene.model, side)
    for joints in random_joints(side, np.random.default_rng(0), 100):
        scene.put(side, joints)
        frames = link_frames(body.arrays, joints)
        assert np.abs(frames[1:] - frames_of(scene, side)).max() < 1e-9
        grasp = site_pose(scene.data, side)
        flange = mink.SE3.from_rotation_and_translation(
            mink.SO3.from_matrix(frames[7, 3:].reshape(3, 3)), frames[7, :3]
        )
        assert (flange @ body.grasp).as_matrix() == pytest.approx(grasp.as_matrix())


def test_the_right_arm_is_not_the_left_one():
    """A mirrored arm read off with the other side's names would pass unseen."""
    model = ArmScene().model
    left, right = (arm_body(model, side).arrays for side in names.SIDES)
    assert left.base[1] == pytest.approx(-right.base[1])
    assert abs(left.base[1]) > 0.1


def test_limits_are_the_models(side):
    model = ArmScene().model
    body = arm_body(model, side)
    for joint, (low, high) in zip(names.arm_joints(side), body.limits, strict=True):
        assert model.joint(joint).range == pytest.approx([low, high])


def test_all_that_hangs_on_the_arm_is_covered(side):
    """Every geom's centre lies in a sphere of the link that carries it."""
    scene = ArmScene()
    body = arm_body(scene.model, side)
    rng = np.random.default_rng(1)
    for joints in random_joints(side, rng, 5):
        scene.put(side, joints)
        frames = link_frames(body.arrays, joints)
        spheres = np.concatenate(
            [
                placed(frames[3], body.arrays.upper_arm),
                placed(frames[4], body.arrays.forearm),
                placed(frames[7], body.arrays.hand),
            ]
        )
        geoms = geoms_of(scene.model, side)
        assert len(geoms) == 16
        for geom in geoms:
            centre = scene.data.geom_xpos[geom]
            away = np.linalg.norm(spheres[:, :3] - centre, axis=1) - spheres[:, 3]
            assert away.min() < 0


def placed(frame, spheres):
    """A link's spheres (n, 4) in the world, without the one round all of them."""
    turn = frame[3:].reshape(3, 3)
    return np.column_stack([spheres[1:, :3] @ turn.T + frame[:3], spheres[1:, 3]])


@pytest.mark.parametrize("where", JARS)
def test_its_clearance_is_at_most_the_true_one_and_little_less(side, where):
    """Against MuJoCo's distances of the same pairs, with the post in the way.

    MuJoCo's distance of a capsule from a box is wrong where the axis pierces the box;
    there the cover says rightly that it touches.
    """
    known = JARS[where](side)
    scene = ArmScene(known)
    scene.place_post([0.55, 0.15 * names.sign(side)])
    scene.put(names.other(side), posture.presenting(names.other(side)))
    true = TrueClearance(scene, side)
    body = body_with(arm_body(scene.model, side), known)
    around = Surroundings(scene.model, side)
    rows = np.concatenate([around.fixed, around.moving(scene.data, known)])
    joints = random_joints(side, np.random.default_rng(2), 1500)
    covers = clearances(body.arrays, joints, rows, FAR)
    truth = np.array([true(each) for each in joints])
    assert (covers <= np.maximum(truth, 0.0) + 2e-6).all()
    assert (covers[truth > 0] <= truth[truth > 0] + 2e-6).all()
    matters = (covers > 0) & (truth < NEAR)
    assert matters.sum() > 50
    # The spheres of a held jar stand out by 3 cm at its flat ends.
    assert (truth - covers)[matters].max() < (0.032 if where == "held" else 0.006)
    clear = covers > 0
    assert np.quantile((truth - covers)[clear], 0.95) < 0.006


def test_a_held_jar_is_where_the_hand_holds_it(side):
    scene = ArmScene()
    joints = posture.presenting(side)
    scene.put(side, joints)
    body = arm_body(scene.model, side).holding(IN_HAND, JAR.radius, JAR.length)
    frames = link_frames(body.arrays, joints)
    spheres = placed(frames[7], body.arrays.jar)
    jar = site_pose(scene.data, side) @ IN_HAND
    assert spheres[:, :3].mean(axis=0) == pytest.approx(jar.translation())
    along = spheres[-1, :3] - spheres[0, :3]
    axis = jar.rotation().as_matrix()[:, 2]
    assert np.linalg.norm(np.cross(along, axis)) < 1e-12
    assert np.linalg.norm(along) + 2 * spheres[0, 3] >= JAR.length
    assert len(arm_body(scene.model, side).arrays.jar) == 0


def test_hand_and_jar_are_within_their_reach_of_the_wrist(side):
    scene = ArmScene(JARS["held"](side))
    body = body_with(arm_body(scene.model, side), scene.jars)
    for joints in random_joints(side, np.random.default_rng(3), 20):
        scene.put(side, joints)
        wrist = scene.data.body(names.arm_links(side)[5]).xpos
        jar = site_pose(scene.data, side) @ IN_HAND
        ends = [
            (jar @ mink.SE3.from_translation(np.array([r, 0, z]))).translation()
            for r in (-JAR.radius, JAR.radius)
            for z in (-JAR.length / 2, JAR.length / 2)
        ]
        assert max(np.linalg.norm(end - wrist) for end in ends) < body.reach
        tips = [scene.data.geom(name).xpos for name in names.fingertips(side)]
        assert max(np.linalg.norm(tip - wrist) for tip in tips) + 0.01 < body.reach


@pytest.mark.parametrize("jars", ["none", "held"])
def test_an_elbow_that_is_not_folded_keeps_the_hand_off_the_upper_arm(side, jars):
    """So occupancy need not look there, see `FOLDED`."""
    known = JARS[jars](side)
    body = body_with(arm_body(ArmScene().model, side), known).arrays
    rng = np.random.default_rng(4)
    joints = random_joints(side, rng, 20_000, margin=0.0)
    bent = np.sign(joints[:, 3]) * np.minimum(np.abs(joints[:, 3]), FOLDED)
    joints[:, 3] = np.where(np.arange(len(joints)) % 2, bent, FOLDED)
    least = min(own_clearance(body, each) for each in joints)
    assert least >= 0.04


@pytest.mark.parametrize("jars", ["none", "held"])
def test_a_folded_one_need_not(side, jars):
    """Otherwise the test above could not fail."""
    body = body_with(arm_body(ArmScene().model, side), JARS[jars](side)).arrays
    joints = random_joints(side, np.random.default_rng(5), 4000)
    joints[:, 3] = 3.0
    assert min(own_clearance(body, each) for each in joints) < 0.0


def own_clearance(body, joints):
    frames = link_frames(body, joints)
    own = upper_arm_solids(body, frames)
    return hand_clearance(body.hand, body.jar, frames, own, FAR)
