"""Presentations in the real scene, each with the truth that only tests may know."""

from typing import NamedTuple

import numpy as np
import pytest

from prospect_mj.sim.camera import StereoCamera, StereoPair
from prospect_mj.sim.placement import JarPlacement
from prospect_mj.sim.props import Props, Table
from prospect_mj.sim.scene import SceneSettings
from prospect_mj.sim.simulation import Simulation
from prospect_mj.vision.look import Look
from prospect_mj.vision.vision_controller import VisionController

NOMINAL = np.array([0.62, 0.0, 0.20])
SPREAD = np.array([0.02, 0.02, 0.01])


class Presentation(NamedTuple):
    pair: StereoPair
    look: Look
    position: np.ndarray
    axis: np.ndarray
    lid_left: bool


class Stage:
    """Simulation, eyes and vision controller, set up as in a trial."""

    def __init__(self, scene=None):
        self.simulation = Simulation(scene)
        self.camera = StereoCamera(self.simulation.model)
        self.vision = VisionController(self.camera.left, self.camera.right)

    def present(self, rng, lid_left, lamp_gain=1.0):
        offset = SPREAD * rng.uniform(-1, 1, 3)
        yaw = np.radians(10) * rng.uniform(-1, 1)
        placement = JarPlacement(NOMINAL + offset, yaw, lid_left)
        self.simulation.reset(placement, lamp_gain)
        return self.seen(rng, lid_left)

    def seen(self, rng, lid_left=True):
        pair = self.camera.capture(self.simulation.data, rng)
        axis = self.simulation.jar_axis * (1 if lid_left else -1)
        position = self.simulation.jar_position
        return Presentation(pair, self.vision.look(pair), position, axis, lid_left)


@pytest.fixture(scope="session")
def stage():
    stage = Stage()
    yield stage
    stage.camera.close()


@pytest.fixture
def stage_on_table():
    """Make a stage whose table has a colour of one's own."""
    stages = []

    def make(colour):
        props = Props(table=Table(colour=colour))
        stages.append(Stage(SceneSettings(props=props)))
        return stages[-1]

    yield make
    for stage in stages:
        stage.camera.close()


@pytest.fixture(scope="session")
def gallery(stage):
    """200 random presentations with sensor noise, both orientations in turn."""
    rng = np.random.default_rng(2002)
    return [stage.present(rng, lid_left=i % 2 == 0) for i in range(200)]
