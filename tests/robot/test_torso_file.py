"""models/torso.xml: as the script writes it, whole by itself, with everything named."""

import xml.etree.ElementTree as ET

import mujoco
import numpy as np
import pytest

from prospect_mj import paths
from prospect_mj.robot.description.torso import torso_xml

KINDS = {
    "body": mujoco.mjtObj.mjOBJ_BODY,
    "joint": mujoco.mjtObj.mjOBJ_JOINT,
    "geom": mujoco.mjtObj.mjOBJ_GEOM,
    "site": mujoco.mjtObj.mjOBJ_SITE,
    "camera": mujoco.mjtObj.mjOBJ_CAMERA,
    "actuator": mujoco.mjtObj.mjOBJ_ACTUATOR,
    "sensor": mujoco.mjtObj.mjOBJ_SENSOR,
    "material": mujoco.mjtObj.mjOBJ_MATERIAL,
    "exclude": mujoco.mjtObj.mjOBJ_EXCLUDE,
    "key": mujoco.mjtObj.mjOBJ_KEY,
}
COUNTS = dict(
    body="nbody",
    joint="njnt",
    geom="ngeom",
    site="nsite",
    camera="ncam",
    actuator="nu",
    sensor="nsensor",
    material="nmat",
    exclude="nexclude",
    key="nkey",
)


@pytest.fixture(scope="module")
def model():
    return mujoco.MjModel.from_xml_path(str(paths.torso_xml()))


def test_the_committed_file_is_what_the_script_writes():
    assert paths.torso_xml().read_text("utf-8") == torso_xml()


@pytest.mark.parametrize("kind", KINDS)
def test_everything_has_a_name_without_slash(model, kind):
    count = getattr(model, COUNTS[kind])
    assert count > 0
    for i in range(count):
        name = mujoco.mj_id2name(model, KINDS[kind], i)
        assert name, f"{kind} {i} has no name"
        assert "/" not in name


def test_what_pymjcf_refuses_is_not_in_the_file():
    tags = {element.tag for element in ET.parse(paths.torso_xml()).iter()}
    assert not tags & {"attach", "replicate", "include", "frame"}


def test_names_are_left_or_right_or_of_the_trunk(model):
    bodies = [model.body(i).name for i in range(1, model.nbody)]
    lefts = sorted(name for name in bodies if name.startswith("left_"))
    rights = sorted(name for name in bodies if name.startswith("right_"))
    assert [name.replace("left_", "right_") for name in lefts] == rights
    assert set(bodies) - set(lefts) - set(rights) == {"trunk", "head"}


def test_home_is_the_only_keyframe_and_the_servos_hold_it(model):
    """Within a minute of arc for 1 s, without contact, on its own in the world."""
    assert model.nkey == 1
    assert model.key("home").qpos == pytest.approx(model.key("home").ctrl)
    data = mujoco.MjData(model)
    mujoco.mj_resetDataKeyframe(model, data, model.key("home").id)
    for _ in range(round(1.0 / model.opt.timestep)):
        mujoco.mj_step(model, data)
        assert data.ncon == 0
    assert np.abs(data.qpos - model.key("home").qpos).max() < 3e-4
    assert not data.warning.number.any()


def test_every_joint_has_limits_armature_and_damping(model):
    assert model.jnt_limited.all()
    assert (model.dof_armature > 0).all()
    assert (model.dof_damping > 0).all()


def test_every_joint_has_one_position_servo_of_its_name(model):
    assert model.nu == model.njnt
    for i in range(model.nu):
        joint = model.actuator_trnid[i, 0]
        assert model.actuator(i).name == model.joint(joint).name
        # ctrl - q times stiffness: a servo, not an actuator that moves by itself.
        stiffness = model.actuator_gainprm[i, 0]
        assert stiffness > 0
        assert model.actuator_biasprm[i, 1] == -stiffness


def test_all_links_collide(model):
    assert (model.geom_contype == 1).all()
    assert (model.geom_conaffinity == 1).all()


def test_only_the_shoulders_are_excluded_from_collision(model):
    pairs = set()
    for signature in model.exclude_signature:
        bodies = (int(signature) >> 16, int(signature) & 0xFFFF)
        pairs.add(frozenset(model.body(i).name for i in bodies))
    assert pairs == {
        frozenset({"trunk", "left_link1"}),
        frozenset({"trunk", "right_link1"}),
    }
    assert model.neq == model.ntendon == model.npair == 0
