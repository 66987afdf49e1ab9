"""The right side is the exact reflection of the left in the sagittal plane y = 0.

The file rounds to nanometres, hence the tolerance of 10 nm.
"""

import mujoco
import numpy as np
import pytest

from prospect_mj import paths

MIRROR = np.diag([1.0, -1.0, 1.0])


@pytest.fixture(scope="module")
def model():
    return mujoco.MjModel.from_xml_path(str(paths.torso_xml()))


def pairs(model, kind):
    """(left, right) ids of all elements of a kind that have a side."""
    count = {"body": "nbody", "joint": "njnt", "geom": "ngeom", "site": "nsite"}[kind]
    view = getattr(model, kind)
    names = [view(i).name for i in range(getattr(model, count))]
    lefts = [name for name in names if name.startswith("left_")]
    assert lefts
    return [(view(n).id, view(n.replace("left_", "right_")).id) for n in lefts]


def mirrored_states(model, n):
    """Random configurations that are their own mirror image."""
    rng = np.random.default_rng(7)
    for _ in range(n):
        data = mujoco.MjData(model)
        for left, right in pairs(model, "joint"):
            low, high = model.jnt_range[left]
            angle = rng.uniform(low, high)
            flips = model.joint(left).name[-1] in "1357"
            data.qpos[model.jnt_qposadr[left]] = angle
            data.qpos[model.jnt_qposadr[right]] = -angle if flips else angle
        mujoco.mj_forward(model, data)
        yield data


def test_ranges_and_servos_mirror(model):
    for left, right in pairs(model, "joint"):
        low, high = model.jnt_range[left]
        flips = model.joint(left).name[-1] in "1357"
        expected = (-high, -low) if flips else (low, high)
        assert model.jnt_range[right] == pytest.approx(expected)
        assert model.jnt_actfrcrange[right] == pytest.approx(
            model.jnt_actfrcrange[left]
        )
        for field in ("dof_armature", "dof_damping"):
            values = getattr(model, field)[model.jnt_dofadr[[left, right]]]
            assert values[0] == values[1]
        servos = [model.actuator(model.joint(i).name).id for i in (left, right)]
        assert model.actuator_ctrlrange[servos[1]] == pytest.approx(expected)
        for field in ("gainprm", "biasprm", "forcerange"):
            gains = getattr(model, f"actuator_{field}")[servos]
            assert np.array_equal(gains[0], gains[1])


def test_bodies_mirror_at_any_mirrored_configuration(model):
    for data in mirrored_states(model, 10):
        for left, right in pairs(model, "body"):
            assert np.allclose(data.xpos[right], MIRROR @ data.xpos[left], atol=1e-8)
            turn = data.xmat[[left, right]].reshape(2, 3, 3)
            assert np.allclose(turn[1], MIRROR @ turn[0] @ MIRROR, atol=1e-7)


def test_masses_and_inertias_mirror(model):
    """The whole inertia tensor in the world, so that no choice of axes matters."""
    data = next(mirrored_states(model, 1))
    for left, right in pairs(model, "body"):
        assert model.body_mass[left] == model.body_mass[right]
        assert np.allclose(data.xipos[right], MIRROR @ data.xipos[left], atol=1e-8)
        tensors = []
        for body in (left, right):
            axes = data.ximat[body].reshape(3, 3)
            tensors.append(axes @ np.diag(model.body_inertia[body]) @ axes.T)
        assert np.allclose(tensors[1], MIRROR @ tensors[0] @ MIRROR, atol=1e-9)


def test_shapes_mirror(model):
    data = next(mirrored_states(model, 1))
    for left, right in pairs(model, "geom"):
        assert model.geom_type[left] == model.geom_type[right]
        assert np.allclose(model.geom_size[left], model.geom_size[right], atol=1e-9)
        assert np.allclose(
            data.geom_xpos[right], MIRROR @ data.geom_xpos[left], atol=1e-8
        )
        # Capsules, cylinders and spheres: the axis, in either sense.
        axes = data.geom_xmat[[left, right]].reshape(2, 3, 3)[:, :, 2]
        assert abs(axes[1] @ MIRROR @ axes[0]) == pytest.approx(1.0)


def test_sites_mirror(model):
    for data in mirrored_states(model, 10):
        for left, right in pairs(model, "site"):
            places = data.site_xpos[[left, right]]
            assert np.allclose(places[1], MIRROR @ places[0], atol=1e-8)
            turns = data.site_xmat[[left, right]].reshape(2, 3, 3)
            assert np.allclose(turns[1], MIRROR @ turns[0] @ MIRROR, atol=1e-7)


def test_joint_torques_mirror(model):
    """Same motion in the mirror, same torques up to sign: dynamics, not just places."""
    data = next(mirrored_states(model, 1))
    rng = np.random.default_rng(3)
    signs = []
    for left, right in pairs(model, "joint"):
        flips = -1 if model.joint(left).name[-1] in "1357" else 1
        signs.append(flips)
        for field in (data.qvel, data.qacc):
            value = rng.normal()
            field[model.jnt_dofadr[left]] = value
            field[model.jnt_dofadr[right]] = flips * value
    mujoco.mj_inverse(model, data)
    dofs = model.jnt_dofadr[np.array(pairs(model, "joint"))]
    torque = data.qfrc_inverse[dofs]
    assert np.abs(torque[:, 0]).max() > 1.0
    assert np.allclose(torque[:, 1], signs * torque[:, 0], atol=1e-6)
