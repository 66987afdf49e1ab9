"""Every solid is in exactly one place: of the arm, fixed, or moving."""

import copy

import mink
import mujoco
import numpy as np
import pytest
from arm_scene import (
    IN_HAND,
    JAR,
    NO_JAR,
    ArmScene,
    in_hand,
    random_joints,
    site_pose,
)

from prospect_mj.planning.arm_body import BEYOND_ELBOW, EVERY_LINK, geoms_of
from prospect_mj.planning.arm_kernels import CYLINDER, FOREARM, UPPER_ARM
from prospect_mj.planning.surroundings import KnownJars, Surroundings
from prospect_mj.robot import names, posture
from prospect_mj.sim.scene import OBSTACLE, PEDESTAL


@pytest.fixture
def scene():
    return ArmScene()


def geoms_at(scene, rows):
    """The model's geom behind each row, by its place and size."""
    model, data = scene.model, scene.data
    found = []
    for row in rows:
        same = (
            (model.geom_type == int(row[0]))
            & np.isclose(data.geom_xpos, row[3:6], atol=1e-9).all(axis=1)
            & np.isclose(data.geom_xmat, row[6:15], atol=1e-9).all(axis=1)
            & np.isclose(model.geom_size, row[15:18]).all(axis=1)
        )
        assert same.sum() == 1
        found.append(int(np.flatnonzero(same)[0]))
    return found


def test_no_solid_is_forgotten_and_none_counted_twice(scene, side):
    """With every joint and every placed thing where it is not by default."""
    around = Surroundings(scene.model, side)
    rng = np.random.default_rng(0)
    for each in names.SIDES:
        scene.put(each, random_joints(each, rng, 1)[0])
    scene.data.mocap_pos[:, :2] += rng.uniform(-0.1, 0.1, (scene.model.nmocap, 2))
    mujoco.mj_kinematics(scene.model, scene.data)
    fixed = geoms_at_rest(scene, around.fixed)
    moving = geoms_at(scene, around.moving(scene.data, NO_JAR))
    own = geoms_of(scene.model, side)
    together = sorted(fixed + moving + own)
    floor = [scene.model.geom("table/floor").id]
    assert sorted(together + floor) == list(range(scene.model.ngeom))


def geoms_at_rest(scene, rows):
    """Of rows that were read off the model at its zero angles."""
    rest = copy.copy(scene)
    rest.data = mujoco.MjData(scene.model)
    mujoco.mj_kinematics(rest.model, rest.data)
    return geoms_at(rest, rows)


def test_what_is_fixed_stands_still_at_any_joint_angles(scene, side):
    rows = Surroundings(scene.model, side).fixed
    fixed = geoms_at_rest(scene, rows)
    rng = np.random.default_rng(1)
    for each in names.SIDES:
        scene.put(each, random_joints(each, rng, 1)[0])
    assert scene.data.geom_xpos[fixed] == pytest.approx(rows[:, 3:6], abs=1e-12)


def test_only_the_own_shoulder_is_spared_and_only_by_the_upper_arm(scene, side):
    around = Surroundings(scene.model, side)
    shoulder = {f"{side}_motor", f"{side}_shoulder"}
    for geom, row in zip(geoms_at_rest(scene, around.fixed), around.fixed, strict=True):
        own = scene.model.geom(geom).name in shoulder
        assert int(row[2]) == (BEYOND_ELBOW if own else EVERY_LINK)
    moving = around.moving(scene.data, NO_JAR)
    assert (moving[:, 2] == EVERY_LINK).all()
    assert not (BEYOND_ELBOW >> UPPER_ARM) & 1
    assert (BEYOND_ELBOW >> FOREARM) & 1


def test_what_can_be_placed_and_the_other_arm_are_where_they_are_now(scene, side):
    around, other = Surroundings(scene.model, side), names.other(side)
    scene.place_post([0.4, 0.3])
    scene.put(other, posture.over_well(other))
    moving = geoms_at(scene, around.moving(scene.data, NO_JAR))
    expected = geoms_of(scene.model, other)
    for name in (PEDESTAL, OBSTACLE):
        body = scene.model.body(f"{name}/").id
        expected += np.flatnonzero(scene.model.geom_bodyid == body).tolist()
    assert sorted(moving) == sorted(expected)


def test_what_does_not_collide_is_no_solid(scene, side):
    model = copy.copy(scene.model)
    before = len(Surroundings(model, side).fixed)
    shade = model.geom("lamp/shade").id
    model.geom_contype[shade] = 0
    assert len(Surroundings(model, side).fixed) == before
    model.geom_conaffinity[shade] = 0
    assert len(Surroundings(model, side).fixed) == before - 1


def is_jar(row):
    shape = [JAR.radius, JAR.length / 2]
    return int(row[0]) == CYLINDER and row[15:17] == pytest.approx(shape)


def jars_among(rows):
    return [row for row in rows if is_jar(row)]


def test_a_jar_in_the_other_hand_moves_with_it(scene, side):
    around, other = Surroundings(scene.model, side), names.other(side)
    known = in_hand(other)
    for joints in random_joints(other, np.random.default_rng(2), 3):
        scene.put(other, joints)
        (row,) = jars_among(around.moving(scene.data, known))
        pose = site_pose(scene.data, other) @ IN_HAND
        assert row[3:6] == pytest.approx(pose.translation())
        assert row[6:15] == pytest.approx(pose.rotation().as_matrix().ravel())
        assert int(row[2]) == EVERY_LINK


def test_a_lying_jar_is_where_it_lies(scene, side):
    turn = mink.SO3.from_x_radians(1.2)
    pose = mink.SE3.from_rotation_and_translation(turn, np.array([0.6, 0.1, 0.2]))
    rows = Surroundings(scene.model, side).moving(
        scene.data, KnownJars(JAR, placed=pose)
    )
    (row,) = jars_among(rows)
    assert row[3:6] == pytest.approx(pose.translation())
    assert row[6:15] == pytest.approx(turn.as_matrix().ravel())


def test_a_jar_in_the_own_hand_is_not_in_its_way(scene, side):
    around = Surroundings(scene.model, side)
    assert not jars_among(around.moving(scene.data, in_hand(side)))
    assert not jars_among(around.moving(scene.data, NO_JAR))
