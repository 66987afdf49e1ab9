"""The composed scene: only gravity and contact act on the jar; all links collide."""

import importlib.util
from dataclasses import replace
from pathlib import Path

import mujoco
import numpy as np
import pytest
import trimesh

from prospect_mj import paths
from prospect_mj.errors import MissingFile
from prospect_mj.robot import posture
from prospect_mj.sim.props import Jar, Pedestal, Props, Well
from prospect_mj.sim.scene import (
    PhysicsSettings,
    SceneSettings,
    compile_scene,
    compile_twin,
)

ROOT = Path(__file__).resolve().parents[2]
JOINTS_OF_A_SIDE = 7 + 6


@pytest.fixture(scope="module")
def model():
    return compile_scene(SceneSettings())


@pytest.fixture(scope="module")
def home(model):
    data = mujoco.MjData(model)
    mujoco.mj_resetDataKeyframe(model, data, model.key("home").id)
    mujoco.mj_forward(model, data)
    return data


def geoms_of(model, prefix):
    names = [model.geom(i).name for i in range(model.ngeom)]
    return [i for i, name in enumerate(names) if name.startswith(prefix)]


def test_the_jar_comes_last_so_that_no_keyframe_writes_into_its_pose(model):
    assert model.nq == 2 * JOINTS_OF_A_SIDE + 7
    free = model.joint("jar/")
    assert free.type[0] == mujoco.mjtJoint.mjJNT_FREE
    assert free.qposadr[0] == model.nq - 7
    assert free.id == model.njnt - 1
    assert model.body("jar/").id == model.nbody - 1


def test_the_home_keyframe_puts_the_jar_into_its_cradle(model, home):
    jar = home.body("jar/")
    assert jar.xpos == pytest.approx([0.62, 0.0, 0.20])
    assert jar.xmat.reshape(3, 3)[:, 2] == pytest.approx([0, 1, 0], abs=1e-9)
    for side in ("left", "right"):
        joints = [home.joint(f"{side}_joint{i}").qpos[0] for i in range(1, 8)]
        assert joints == pytest.approx(posture.home(side))


def test_in_the_home_keyframe_nothing_touches_but_jar_and_cradle(model, home):
    for pair in home.contact.geom[: home.ncon]:
        kinds = {model.geom(i).name.partition("/")[0] for i in pair}
        assert kinds == {"jar", "pedestal"}


def test_nothing_but_gravity_and_contact_can_act_on_the_jar(model):
    assert model.neq == 0, "an equality could weld the jar"
    assert model.ntendon == 0
    assert model.nflex == 0
    assert model.nplugin == 0
    jar = model.body("jar/")
    assert model.body_gravcomp[jar.id] == 0
    assert model.opt.gravity == pytest.approx([0, 0, -9.81])
    dofs = range(jar.dofadr[0], jar.dofadr[0] + 6)
    for i in dofs:
        assert model.dof_damping[i] == model.dof_frictionloss[i] == 0
        assert model.dof_armature[i] == 0
    assert not model.jnt_stiffness[model.joint("jar/").id]
    # The medium is vacuum: no drag, no lift, no wind.
    assert model.opt.density == model.opt.viscosity == 0
    assert not model.opt.wind.any()


def test_every_actuator_turns_a_joint_of_an_arm(model):
    """So there is no adhesion, no force at a body and no actuator of the jar."""
    for i in range(model.nu):
        assert model.actuator_trntype[i] == mujoco.mjtTrn.mjTRN_JOINT
        name = model.joint(model.actuator_trnid[i, 0]).name
        assert name.startswith(("left_", "right_"))
    assert model.nu == 2 * JOINTS_OF_A_SIDE


def test_actuators_have_no_moment_about_the_jar(model, home):
    moment = np.zeros((model.nu, model.nv))
    mujoco.mju_sparse2dense(
        moment,
        home.actuator_moment.reshape(-1),
        home.moment_rownnz,
        home.moment_rowadr,
        home.moment_colind.reshape(-1),
    )
    assert moment[:, : model.nv - 6].any()
    assert not moment[:, model.nv - 6 :].any()


def test_all_links_and_fixtures_collide_and_only_the_picture_of_the_jar_does_not(model):
    ghosts = {
        model.geom(i).name
        for i in range(model.ngeom)
        if not (model.geom_contype[i] and model.geom_conaffinity[i])
    }
    assert ghosts == {"jar/visual"}
    assert model.geom("jar/visual").type[0] == mujoco.mjtGeom.mjGEOM_MESH
    # Everything else meets everything else: one common bit.
    others = [i for i in range(model.ngeom) if model.geom(i).name != "jar/visual"]
    assert (model.geom_contype[others] == 1).all()
    assert (model.geom_conaffinity[others] == 1).all()


def test_the_list_of_excluded_pairs_is_the_shoulders(model):
    pairs = set()
    for signature in model.exclude_signature:
        bodies = (int(signature) >> 16, int(signature) & 0xFFFF)
        pairs.add(frozenset(model.body(i).name for i in bodies))
    assert pairs == {frozenset({"trunk", f"{s}_link1"}) for s in ("left", "right")}
    assert model.npair == 0
    assert not model.opt.disableflags & mujoco.mjtDisableBit.mjDSBL_CONTACT
    assert not model.opt.disableflags & mujoco.mjtDisableBit.mjDSBL_GRAVITY


def test_everything_is_named(model):
    kinds = mujoco.mjtObj
    for kind, count in (
        (kinds.mjOBJ_BODY, model.nbody),
        (kinds.mjOBJ_JOINT, model.njnt),
        (kinds.mjOBJ_GEOM, model.ngeom),
        (kinds.mjOBJ_SITE, model.nsite),
        (kinds.mjOBJ_CAMERA, model.ncam),
        (kinds.mjOBJ_LIGHT, model.nlight),
        (kinds.mjOBJ_ACTUATOR, model.nu),
        (kinds.mjOBJ_SENSOR, model.nsensor),
        (kinds.mjOBJ_MESH, model.nmesh),
        (kinds.mjOBJ_EXCLUDE, model.nexclude),
        (kinds.mjOBJ_KEY, model.nkey),
    ):
        assert count > 0
        assert all(mujoco.mj_id2name(model, kind, i) for i in range(count)), kind


def test_the_jar_has_the_mass_and_balance_of_its_settings(model):
    jar = Jar()
    body = model.body("jar/")
    assert body.mass[0] == pytest.approx(0.40)
    assert model.geom("jar/visual").contype[0] == 0
    # Two cylinders: centre of mass of 3/4 in the body and 1/4 in the lid.
    centres = (-jar.lid_length / 2, jar.length / 2 - jar.lid_length / 2)
    expected = 0.75 * centres[0] + 0.25 * centres[1]
    assert body.ipos == pytest.approx([0, 0, expected], abs=1e-6)
    across, along = body.inertia[0], body.inertia[2]
    solid = [
        (0.30, jar.body_radius, jar.body_length, centres[0]),
        (0.10, jar.lid_radius, jar.lid_length, centres[1]),
    ]
    assert along == pytest.approx(sum(m * r**2 / 2 for m, r, _, _ in solid))
    assert across == pytest.approx(
        sum(
            m * (3 * r**2 + h**2) / 12 + m * (z - expected) ** 2 for m, r, h, z in solid
        )
    )


def test_physics_options_are_those_of_the_settings(model):
    settings = PhysicsSettings()
    assert model.opt.timestep == settings.timestep
    assert model.opt.integrator == mujoco.mjtIntegrator.mjINT_IMPLICITFAST
    assert model.opt.cone == mujoco.mjtCone.mjCONE_ELLIPTIC
    assert model.opt.impratio == settings.impratio
    assert model.opt.noslip_iterations == settings.noslip_iterations
    assert model.opt.iterations == settings.iterations
    for name in ("jar/body", "jar/lid"):
        geom = model.geom(name)
        assert geom.condim[0] == 4
        assert geom.solref == pytest.approx(settings.solref)
        assert geom.solimp[:3] == pytest.approx(settings.solimp)
        assert geom.friction == pytest.approx(Jar().friction)
    # A contact stiffer than two timesteps would not be resolved.
    assert settings.solref[0] >= 2 * settings.timestep


def test_the_jar_decides_about_friction_except_in_the_well(model):
    for i in geoms_of(model, ("left_", "right_", "pedestal/", "table/")):
        assert model.geom_priority[i] < model.geom("jar/body").priority[0]
    for i in geoms_of(model, "well/"):
        assert model.geom_priority[i] > model.geom("jar/lid").priority[0]
        assert model.geom_friction[i, 0] == Well().friction


def test_settings_reach_the_model():
    props = Props(
        jar=Jar(friction=(0.2, 0.001, 1e-5), mass=0.5),
        pedestal=Pedestal(position=(0.60, 0.01)),
        well=Well(position=(0.44, 0.02)),
    )
    model = compile_scene(
        replace(SceneSettings(), props=props, physics=PhysicsSettings(timestep=0.002))
    )
    assert model.opt.timestep == 0.002
    assert model.body("jar/").mass[0] == pytest.approx(0.5)
    assert model.geom("jar/body").friction == pytest.approx((0.2, 0.001, 1e-5))
    data = mujoco.MjData(model)
    mujoco.mj_kinematics(model, data)
    assert data.geom("well/floor").xpos[:2] == pytest.approx((0.44, 0.02))
    assert model.key("home").qpos[-7:-4] == pytest.approx((0.60, 0.01, 0.20))


def test_base_first_fits_and_lid_first_does_not(model, home):
    """The free inner square, measured on the compiled walls, and both radii."""
    faces = {}
    for name, axis in (("far", 0), ("near", 0), ("left", 1), ("right", 1)):
        wall = home.geom(f"well/wall_{name}")
        offset = abs(wall.xpos[axis] - home.geom("well/floor").xpos[axis])
        faces[name] = offset - model.geom(f"well/wall_{name}").size[0]
    assert all(face == pytest.approx(0.040) for face in faces.values())
    assert model.geom("jar/body").size[0] < min(faces.values()) - 0.003
    assert model.geom("jar/lid").size[0] > max(faces.values()) + 0.003


def test_the_well_has_a_chamfer_that_starts_at_the_inner_edge_of_its_rim(model, home):
    for name, direction in (("far", (1, 0, 0)), ("left", (0, 1, 0))):
        plate = home.geom(f"well/chamfer_{name}")
        turn = plate.xmat.reshape(3, 3)
        half_length, _, half_thickness = model.geom(f"well/chamfer_{name}").size
        outward = turn[:, 0] if turn[:, 0] @ direction > 0 else -turn[:, 0]
        assert outward @ direction == pytest.approx(np.cos(np.pi / 4))
        assert outward[2] == pytest.approx(np.sin(np.pi / 4))
        up = turn[:, 2] if turn[2, 2] > 0 else -turn[:, 2]
        edge = plate.xpos + half_thickness * up - half_length * outward
        offset = edge - home.geom("well/floor").xpos
        assert offset @ direction == pytest.approx(0.040)
        assert edge[2] == pytest.approx(0.10)


def test_what_the_eyes_see_is_what_the_fingers_touch(model):
    """Visual mesh and collision cylinders agree within 1.5 mm, everywhere."""
    mesh = trimesh.load(paths.jar_obj(), process=False)
    radius = np.hypot(mesh.vertices[:, 0], mesh.vertices[:, 1])
    along = mesh.vertices[:, 2]
    assert along.min() == pytest.approx(-0.085, abs=1e-6)
    assert along.max() == pytest.approx(0.085, abs=1e-6)
    bevel = 0.0015 + 1e-6
    for name in ("jar/body", "jar/lid"):
        geom = model.geom(name)
        low, high = geom.pos[2] - geom.size[1], geom.pos[2] + geom.size[1]
        inside = (along > low + bevel) & (along < high - bevel)
        ring = np.abs(along - low) < bevel
        ring |= np.abs(along - high) < bevel
        outer = radius[(inside | ring) & (radius > 1e-3)]
        assert outer.size > 0
        largest = radius[(along >= low - 1e-6) & (along <= high - 1e-6)].max()
        assert largest == pytest.approx(geom.size[0], abs=1.5e-3)
    # The compiled mesh sits where the file says, not at its centre of mass.
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    start = model.mesh_vertadr[0]
    vertices = model.mesh_vert[start : start + model.mesh_vertnum[0]]
    visual, jar = data.geom("jar/visual"), data.body("jar/")
    placed = visual.xpos + vertices @ visual.xmat.reshape(3, 3).T
    local = (placed - jar.xpos) @ jar.xmat.reshape(3, 3)
    assert local[:, 2].min() == pytest.approx(-0.085, abs=1e-5)
    assert local[:, 2].max() == pytest.approx(0.085, abs=1e-5)
    lid = local[:, 2] > 0.085 - 0.040 + 0.002
    assert np.hypot(*local[lid, :2].T).max() == pytest.approx(0.045, abs=1e-5)
    assert np.hypot(*local[~lid, :2].T).max() <= 0.045 + 1e-5


def test_the_committed_jar_is_what_the_script_writes(tmp_path):
    place = ROOT / "scripts" / "make_jar.py"
    spec = importlib.util.spec_from_file_location("make_jar", place)
    script = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(script)
    script.write(tmp_path)
    for name in ("jar.obj", "jar.png"):
        assert (tmp_path / name).read_bytes() == (ROOT / "assets" / name).read_bytes()


def test_the_twin_has_both_arms_and_no_jar():
    twin = compile_twin(SceneSettings(), posture.OPEN)
    assert twin.nq == twin.nv == 14
    assert twin.nu == twin.nsensor == twin.nkey == 0
    names = [twin.body(i).name for i in range(twin.nbody)]
    assert not [name for name in names if name.startswith("jar")]
    assert {"table/", "well/", "lamp/", "pedestal/"} <= set(names)


def test_the_twin_is_the_scene_with_its_fingers_open(model, home):
    """Every link and fixture of the twin is where it is in the scene at home."""
    twin = compile_twin(SceneSettings(), posture.OPEN)
    data = mujoco.MjData(twin)
    for side in ("left", "right"):
        for i, angle in enumerate(posture.home(side), start=1):
            data.joint(f"{side}_joint{i}").qpos = angle
    mujoco.mj_kinematics(twin, data)
    for i in range(twin.ngeom):
        name = twin.geom(i).name
        assert data.geom(name).xpos == pytest.approx(home.geom(name).xpos, abs=1e-7)
        assert data.geom(name).xmat == pytest.approx(home.geom(name).xmat, abs=1e-7)
    missing = {model.geom(i).name for i in range(model.ngeom)}
    missing -= {twin.geom(i).name for i in range(twin.ngeom)}
    assert missing == {"jar/visual", "jar/body", "jar/lid"}


def test_a_missing_file_is_named_with_its_remedy(tmp_path, monkeypatch):
    monkeypatch.setattr(paths, "MODELS", tmp_path)
    with pytest.raises(MissingFile, match=r"torso\.xml is missing.*make_torso\.py"):
        compile_scene(SceneSettings())
