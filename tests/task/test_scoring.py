"""The referee: jars placed by hand in and about the receptacle."""

import mujoco
import numpy as np
import pytest
from rig import shared_rig
from scipy.spatial.transform import Rotation

from prospect_mj.task.scoring import is_inserted

UPRIGHT = Rotation.identity()
STANDING = np.array([0.45, 0.0, 0.02 + 0.085])
"""Centre of a jar that stands on the receptacle's floor [m]."""


@pytest.fixture
def rig():
    rig = shared_rig()
    rig.present()
    return rig


def place(rig, position, rotation=UPRIGHT, settle=0.0):
    """A test may write where the project may not."""
    address = rig.model.joint("jar/").qposadr[0]
    rig.data.qpos[address : address + 3] = position
    quaternion = rotation.as_quat(scalar_first=True)
    rig.data.qpos[address + 3 : address + 7] = quaternion
    rig.data.qvel[:] = 0
    mujoco.mj_forward(rig.model, rig.data)
    if settle:
        rig.wait(settle)
    return is_inserted(rig.simulation)


def test_an_upright_jar_on_the_floor_of_the_well_is_in(rig):
    assert place(rig, STANDING)
    assert place(rig, STANDING + [0, 0, 0.003], settle=0.5)
    assert rig.simulation.jar_position[2] == pytest.approx(STANDING[2], abs=1e-3)


@pytest.mark.parametrize("offset", [(0.003, 0), (-0.003, 0.003), (0, -0.003)])
def test_it_may_lean_on_a_wall(rig, offset):
    assert place(rig, STANDING + [*offset, 0])


def test_turning_about_its_axis_does_not_matter(rig):
    assert place(rig, STANDING, Rotation.from_euler("z", 2.0))


def test_a_jar_in_the_cradle_is_not_in(rig):
    assert not is_inserted(rig.simulation)


@pytest.mark.parametrize("offset", [(0.15, 0), (0, 0.15), (-0.15, 0), (0.06, 0.06)])
def test_a_jar_beside_the_well_is_not_in(rig, offset):
    on_the_table = [STANDING[0] + offset[0], STANDING[1] + offset[1], 0.085]
    assert not place(rig, on_the_table)


@pytest.mark.parametrize("height", [0.015, 0.05, 0.1, 0.3])
def test_a_jar_held_above_the_floor_is_not_in(rig, height):
    assert not place(rig, STANDING + [0, 0, height])


def test_a_jar_that_stands_on_its_lid_would_be_in(rig):
    """Which end gets there is up to walls, rim and post, and not to the referee."""
    assert place(rig, STANDING, Rotation.from_euler("x", np.pi))
    assert place(rig, STANDING, Rotation.from_euler("xz", [np.pi, 2.0]))


def test_an_upside_down_jar_cannot_stay_there_anyway(rig):
    """Dropped lid first from 1 mm above where the lid wedges, it stops on the rim."""
    above = [0.45, 0.0, 0.10 + 0.006 + 0.085]
    assert not place(rig, above, Rotation.from_euler("x", np.pi), settle=0.4)
    assert rig.simulation.jar_position[2] > 0.10 + 0.07


@pytest.mark.parametrize("degrees", [15, 45, 90])
@pytest.mark.parametrize("from_end", [0, 180])
def test_a_leaning_jar_is_not_in(rig, degrees, from_end):
    leaning = Rotation.from_euler("x", from_end + degrees, degrees=True)
    assert not place(rig, STANDING, leaning)
