"""The live physics is deterministic, restorable, and says when it breaks down."""

import mujoco
import numpy as np
import pytest
from rig import GRASP, INSERT, SIDES, SWAP_FROM, holding

from prospect_mj.errors import InvalidValue, SimulationDiverged
from prospect_mj.sim.placement import JarPlacement
from prospect_mj.sim.simulation import Simulation

PLACE = JarPlacement(np.array([0.63, -0.01, 0.205]), 0.1, lid_left=True)


def test_two_resets_give_the_same_state(rig):
    rig.simulation.reset(PLACE)
    first = rig.simulation.save()
    rig.simulation.reset(PLACE)
    assert np.array_equal(rig.simulation.save(), first)


def test_a_reset_after_an_episode_equals_that_of_a_new_simulation(rig):
    rig.present(lid="right")
    rig.act(GRASP["left"], INSERT["left"], SWAP_FROM["left"])
    rig.simulation.reset(PLACE)
    fresh = Simulation()
    fresh.reset(PLACE)
    assert np.array_equal(rig.simulation.save(), fresh.save())
    assert np.array_equal(rig.data.sensordata, fresh.data.sensordata)
    assert np.array_equal(rig.data.xpos, fresh.data.xpos)


def test_stepping_goes_on_from_a_saved_state_bit_by_bit(rig):
    rig.restore(holding("left"))
    rig.torso.arms["left"].command_joints(rig.joints("left") + 0.1)
    state = rig.simulation.save()
    rig.simulation.step(100)
    after = rig.simulation.save()
    rig.simulation.step(50)
    rig.simulation.restore(state)
    assert np.array_equal(rig.simulation.save(), state)
    rig.simulation.step(100)
    assert np.array_equal(rig.simulation.save(), after)
    assert not np.array_equal(state, after)


def test_one_call_of_many_steps_equals_many_calls_of_one(rig):
    rig.simulation.reset(PLACE)
    state = rig.simulation.save()
    rig.simulation.step(40)
    at_once = rig.simulation.save()
    rig.simulation.restore(state)
    for _ in range(40):
        rig.simulation.step(1)
    assert np.array_equal(rig.simulation.save(), at_once)


@pytest.mark.parametrize("lid_left", [True, False])
@pytest.mark.parametrize("yaw", [-0.17, 0.0, 0.17])
def test_the_jar_lies_at_rest_where_it_was_placed(rig, lid_left, yaw):
    position = np.array([0.61, 0.02, 0.195])
    rig.simulation.reset(JarPlacement(position, yaw, lid_left))
    assert rig.simulation.jar_position == pytest.approx(position, abs=5e-4)
    left = np.array([-np.sin(yaw), np.cos(yaw), 0.0])
    axis = left if lid_left else -left
    assert rig.simulation.jar_axis == pytest.approx(axis, abs=2e-3)
    assert np.abs(rig.data.qvel[-6:]).max() < 1e-3
    rig.simulation.step(400)
    assert rig.simulation.jar_position == pytest.approx(position, abs=5e-4)


def test_the_pedestal_moves_with_the_jar_and_the_lamp_can_dim(rig):
    rig.simulation.reset(PLACE, lamp_gain=0.9)
    assert rig.data.body("pedestal/").xpos == pytest.approx(PLACE.position)
    dim = rig.model.light_diffuse.copy()
    rig.simulation.reset(PLACE)
    assert dim == pytest.approx(0.9 * rig.model.light_diffuse)


@pytest.mark.parametrize("lid", SIDES)
def test_only_physics_moves_the_jar_after_reset(rig, lid):
    """Replay of an episode's servo commands alone gives the jar's path, bit by bit.

    Whoever wrote into its pose or velocity, or pushed it, would not be in the replay.
    """
    other = "right" if lid == "left" else "left"
    rig.present(lid=lid, offset=(0.01, -0.01, 0.005), yaw=0.1)
    start = rig.simulation.save()
    ctrl, jar = [], []

    def record(data):
        ctrl.append(data.ctrl.copy())
        jar.append(np.concatenate([data.qpos[-7:], data.qvel[-6:]]))
        assert not data.xfrc_applied.any()
        assert not data.qfrc_applied.any()

    rig.simulation.observer = record
    try:
        outcomes = rig.act(GRASP[other], INSERT[other], SWAP_FROM[other], INSERT[lid])
    finally:
        rig.simulation.observer = None
    results = [outcome.result for outcome in outcomes]
    assert results == ["success", "jammed", "success", "success"]
    data = mujoco.MjData(rig.model)
    mujoco.mj_setState(rig.model, data, start, mujoco.mjtState.mjSTATE_INTEGRATION)
    for command, expected in zip(ctrl, jar, strict=True):
        data.ctrl[:] = command
        mujoco.mj_step(rig.model, data)
        assert np.array_equal(
            np.concatenate([data.qpos[-7:], data.qvel[-6:]]), expected
        )


def test_the_observer_sees_every_step_and_changes_nothing(rig):
    rig.simulation.reset(PLACE)
    state = rig.simulation.save()
    rig.simulation.step(30)
    unseen = rig.simulation.save()
    times = []
    rig.simulation.restore(state)
    rig.simulation.observer = lambda data: times.append(data.time)
    try:
        rig.simulation.step(30)
    finally:
        rig.simulation.observer = None
    assert len(times) == 30
    assert np.diff(times) == pytest.approx(rig.simulation.timestep)
    assert np.array_equal(rig.simulation.save(), unseen)


def test_a_warning_of_the_physics_is_an_error_that_names_it():
    simulation = Simulation()
    simulation.reset(PLACE)
    simulation.data.qvel[0] = np.inf
    with pytest.raises(SimulationDiverged, match="mjWARN_BADQVEL"):
        simulation.step(1)
    simulation.reset(PLACE)
    simulation.step(10)


@pytest.mark.parametrize("period", [0.02, 0.0025, 0.05])
def test_a_control_period_is_a_whole_number_of_steps(rig, period):
    n = rig.simulation.substeps(period)
    assert n * rig.simulation.timestep == pytest.approx(period, abs=1e-12)


@pytest.mark.parametrize("period", [0.001, 0.003, 0.021, 0.0, -0.02])
def test_other_control_periods_are_refused(rig, period):
    with pytest.raises(InvalidValue, match=rf"control period is {period}.*0\.0025"):
        rig.simulation.substeps(period)
