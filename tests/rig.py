"""A live scene with the robot's controllers and no eyes, for tests with physics.

Where the robot needs to know of the jar it is told the truth plus a bias of the test's
choice, so that no test of control depends on rendering.
"""

import functools
from collections.abc import Callable
from typing import NamedTuple

import mujoco
import numpy as np

from prospect_mj.actions.action import Action, ActionOutcome
from prospect_mj.actions.belief import Belief, SeenJar
from prospect_mj.actions.runner import ActionRunner
from prospect_mj.control.controller import CONTROL_PERIOD
from prospect_mj.robot import names, posture
from prospect_mj.robot.torso import Torso
from prospect_mj.sim.placement import JarPlacement
from prospect_mj.sim.scene import SceneSettings
from prospect_mj.sim.simulation import Simulation

SIDES = ("left", "right")
OTHER = {"left": "right", "right": "left"}
GRASP = {"left": Action.GRASP_LEFT, "right": Action.GRASP_RIGHT}
SWAP_FROM = {"left": Action.SWAP_LEFT_TO_RIGHT, "right": Action.SWAP_RIGHT_TO_LEFT}
INSERT = {"left": Action.INSERT_LEFT, "right": Action.INSERT_RIGHT}


class Snapshot(NamedTuple):
    state: np.ndarray
    belief: Belief


class JarInHand(NamedTuple):
    """Truth in the frame of a hand: what slip is measured by."""

    position: np.ndarray
    axis: np.ndarray


class Rig:
    def __init__(self, scene: SceneSettings | None = None) -> None:
        self.simulation = Simulation(scene)
        self.model, self.data = self.simulation.model, self.simulation.data
        self.torso = Torso(self.model, self.data)
        self.runner = ActionRunner(self.simulation)
        self.twin, self.arms = self.runner.twin, self.runner.arms

    @property
    def nominal(self) -> np.ndarray:
        return self.simulation.settings.props.pedestal.nominal

    @property
    def belief(self) -> Belief:
        return self.runner.belief

    def present(self, lid="left", offset=(0, 0, 0), yaw=0.0, bias=(0, 0, 0)) -> None:
        """Begin a trial in which the jar is believed to lie `bias` beside its place."""
        place = JarPlacement(self.nominal + offset, yaw, lid == "left")
        self.simulation.reset(place)
        axis = self.simulation.jar_axis
        seen = SeenJar(self.simulation.jar_position + bias, np.sign(axis[1]) * axis)
        self.runner.begin(Belief(seen))

    def act(self, *actions: Action) -> list[ActionOutcome]:
        return [self.runner.execute(action) for action in actions]

    def tick(self, *controllers, hook: Callable[[], None] | None = None) -> None:
        """One control period: sense, let controllers think, step the physics."""
        reading = self.torso.read()
        self.twin.update(reading)
        for controller in controllers:
            targets = controller.update(reading)
            arm = self.torso.arms[controller.side]
            if targets.joints is not None:
                arm.command_joints(targets.joints)
            if targets.fingers is not None:
                arm.command_fingers(targets.fingers)
        if hook is not None:
            hook()
        self.simulation.step(self.simulation.substeps(CONTROL_PERIOD))

    def drive(self, controller, hook: Callable[[], None] | None = None):
        """Run one controller to its result."""
        while controller.result is None:
            self.tick(controller, hook=hook)
        self.sense()
        return controller.result

    def wait(self, seconds: float) -> None:
        """Let physics go on with the servos told nothing new."""
        self.simulation.step(round(seconds / self.simulation.timestep))
        self.sense()

    def sense(self) -> None:
        # Derived quantities lag one physics step behind qpos; tests compare both.
        mujoco.mj_forward(self.model, self.data)
        self.twin.update(self.torso.read())

    def save(self) -> Snapshot:
        return Snapshot(self.simulation.save(), self.belief.copy())

    def restore(self, snapshot: Snapshot) -> None:
        self.simulation.restore(snapshot.state)
        self.runner.begin(snapshot.belief.copy())
        self.sense()

    def joints(self, side: str) -> np.ndarray:
        return self.torso.arms[side].read().joints

    def jar_in_hand(self, side: str) -> JarInHand:
        site = self.data.site(names.grasp_site(side))
        turn = site.xmat.reshape(3, 3).T
        offset = self.simulation.jar_position - site.xpos
        return JarInHand(turn @ offset, turn @ self.simulation.jar_axis)

    def is_home(self, side: str) -> bool:
        own = self.torso.arms[side].read()
        arm = np.abs(own.joints - posture.home(side)).max()
        return arm < 0.03 and np.abs(own.fingers - posture.OPEN).max() < 0.05

    def is_presenting(self, side: str) -> bool:
        error = np.abs(self.joints(side) - posture.presenting(side)).max()
        return error < 0.03


@functools.cache
def shared_rig() -> Rig:
    """One rig for all tests of a process: every test begins with `present`."""
    return Rig()


@functools.cache
def holding(side: str) -> Snapshot:
    """After a grasp by the hand on the lid's side, from the nominal presentation."""
    rig = shared_rig()
    rig.present(lid=side)
    (outcome,) = rig.act(GRASP[side])
    assert outcome.result == "success"
    # What is left of the last motion would be taken for slip.
    rig.wait(0.5)
    return rig.save()


@functools.cache
def holding_wrong(side: str) -> Snapshot:
    """The same by the other end: the lid goes down first into the receptacle."""
    rig = shared_rig()
    rig.present(lid=OTHER[side])
    (outcome,) = rig.act(GRASP[side])
    assert outcome.result == "success"
    rig.wait(0.5)
    return rig.save()


def angle_between(first: np.ndarray, second: np.ndarray) -> float:
    """[rad]"""
    sine = np.linalg.norm(np.cross(first, second))
    return float(np.arctan2(sine, first @ second))
