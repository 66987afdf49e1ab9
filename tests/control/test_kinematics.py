"""The twin's dynamics are MuJoCo's, of the arm alone."""

import mujoco
import numpy as np
import pytest

from prospect_mj.control.kinematics import KinematicTwin
from prospect_mj.robot import names, wam
from prospect_mj.sim.scene import SceneSettings


@pytest.fixture(scope="module")
def twin():
    return KinematicTwin(SceneSettings())


@pytest.mark.parametrize("side", names.SIDES)
def test_torques_by_inertia_and_motion_are_those_of_inverse_dynamics(twin, side):
    """M(q) a + bias(q, v) + friction, for any q, v and a of one arm."""
    rng = np.random.default_rng(0)
    model, own = twin.model, twin.columns(side)
    low, high = model.jnt_range.T
    for _ in range(20):
        twin.configuration.update(rng.uniform(low + 0.1, high - 0.1))
        velocity, acceleration = rng.uniform(-2, 2, (2, wam.N_JOINTS))
        inertia, motion = twin.dynamics(side, velocity)
        assert inertia == pytest.approx(inertia.T)
        assert np.linalg.eigvalsh(inertia).min() > 0
        data = mujoco.MjData(model)
        data.qpos[:] = twin.configuration.q
        data.qvel[own], data.qacc[own] = velocity, acceleration
        # Contacts and limits would add forces of their own.
        model.opt.disableflags |= int(mujoco.mjtDisableBit.mjDSBL_CONSTRAINT)
        mujoco.mj_inverse(model, data)
        model.opt.disableflags &= ~int(mujoco.mjtDisableBit.mjDSBL_CONSTRAINT)
        expected = data.qfrc_inverse[own]
        assert inertia @ acceleration + motion == pytest.approx(expected, abs=1e-9)


@pytest.mark.parametrize("side", names.SIDES)
def test_it_leaves_the_twins_places_as_they_are(twin, side):
    before = twin.configuration.q.copy(), twin.grasp_pose(side).as_matrix()
    twin.dynamics(side, np.full(wam.N_JOINTS, 1.5))
    assert np.array_equal(twin.configuration.q, before[0])
    assert np.array_equal(twin.grasp_pose(side).as_matrix(), before[1])
