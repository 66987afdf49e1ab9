"""Controllers of gross motion in physics, on pairs of start and goal.

Every physics step is watched for contacts of arms and hands. A controller gets an arm
without a planner; one that plans brings its own.
"""

import functools
import time
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import mink
import mujoco
import numpy as np
from joblib import Parallel, delayed
from reach_pairs import POST, SCENE, ReachPair
from rig import angle_between

from prospect_mj.control.arm_control import ArmControl
from prospect_mj.control.controller import CONTROL_PERIOD, Controller
from prospect_mj.control.differential_ik import DifferentialIK
from prospect_mj.control.kinematics import KinematicTwin
from prospect_mj.control.result import Status
from prospect_mj.robot import names, posture
from prospect_mj.robot.names import Side
from prospect_mj.robot.torso import Torso
from prospect_mj.sim.audit import Audit
from prospect_mj.sim.placement import JarPlacement
from prospect_mj.sim.scene import JAR
from prospect_mj.sim.simulation import Simulation

POSITION_TOLERANCE, ANGLE_TOLERANCE = 0.015, 0.10
"""Of the true hand at its arrival [m, rad]."""
SETTLING, COASTING = 0.3, 0.3
"""Before a controller begins, and watched after its result [s]."""
_AWAY = (-1.2, 0.0, -0.75 + SCENE.props.jar.length / 2)
"""Of the jar: upright on the floor behind the torso [m]."""

Make = Callable[[ArmControl, mink.SE3, np.ndarray], Controller]
"""Arm, pose of the grasp site in the world, reference posture (7,) [rad]."""


@dataclass(frozen=True)
class Reach:
    """What a controller made of a pair."""

    pair: ReachPair
    status: Status
    reason: str
    seconds: float
    """Simulated, until its result."""
    position_error: float
    """Of the true hand when the controller had its result [m]."""
    angle_error: float
    """The same, roll left out [rad]."""
    contacts: dict[tuple[str, str], int]
    """Physics steps with a contact of an arm or hand, by pair of geoms."""
    load: float
    """Largest share of a torque limit [1]."""
    slowest_update: float
    """Of the controller [s], by the clock on the wall: where it plans, the plan."""

    @property
    def arrived(self) -> bool:
        return (
            self.status is Status.CONVERGED
            and self.position_error <= POSITION_TOLERANCE
            and self.angle_error <= ANGLE_TOLERANCE
        )


class Sighting(NamedTuple):
    """Of the grasp site."""

    position: np.ndarray
    """(3,) [m]"""
    rotation: np.ndarray
    """(3, 3)"""


class Bench:
    """Live physics with an arm to control, and none of the actions."""

    def __init__(self) -> None:
        self.simulation = Simulation(SCENE)
        self.model, self.data = self.simulation.model, self.simulation.data
        self.torso, self.twin = Torso(self.model, self.data), KinematicTwin(SCENE)
        self.arms = {
            side: ArmControl(side, self.twin, DifferentialIK(self.twin, side))
            for side in names.SIDES
        }
        self._true = mujoco.MjData(self.model)

    def begin(self, pair: ReachPair) -> None:
        """Arm at rest at the start, the other one at home, the jar out of the way."""
        props = SCENE.props
        self.simulation.reset(JarPlacement(props.pedestal.nominal, 0.0, lid_left=True))
        joints = names.arm_joints(pair.side)
        for joint, angle in zip(joints, pair.start, strict=True):
            self.data.joint(joint).qpos = angle
        self.torso.arms[pair.side].command_joints(pair.start)
        self.data.joint(f"{JAR}/").qpos[:] = [*_AWAY, 1.0, 0.0, 0.0, 0.0]
        self.data.qvel[:] = 0.0
        place = POST.position if pair.obstacle is None else pair.obstacle
        self.twin.place_pedestal(props.pedestal.nominal, 0.0)
        for owner in (self.simulation, self.twin):
            owner.place_obstacle(np.array(place))

    def wait(self, seconds: float) -> None:
        self.simulation.step(self.simulation.substeps(seconds))
        self.twin.update(self.torso.read())

    def drive(self, controller: Controller) -> tuple[Sighting, float]:
        """Where the hand is when the controller ends, and its slowest update [s]."""
        slowest = 0.0
        while True:
            reading = self.torso.read()
            self.twin.update(reading)
            begun = time.perf_counter()
            targets = controller.update(reading)
            slowest = max(slowest, time.perf_counter() - begun)
            if controller.result is not None:
                return self.hand(controller.side), slowest
            if targets.joints is not None:
                self.torso.arms[controller.side].command_joints(targets.joints)
            self.simulation.step(self.simulation.substeps(CONTROL_PERIOD))

    def hand(self, side: Side) -> Sighting:
        """The grasp site's true place; what the live data derives lags by one step."""
        self._true.qpos[:] = self.data.qpos
        mujoco.mj_kinematics(self.model, self._true)
        site = self._true.site(names.grasp_site(side))
        return Sighting(site.xpos.copy(), site.xmat.reshape(3, 3).copy())


@functools.cache
def _bench() -> Bench:
    return Bench()


def run(pair: ReachPair, make: Make) -> Reach:
    """Let a controller do it in physics, watched at every step."""
    bench = _bench()
    bench.begin(pair)
    joints = [name for side in names.SIDES for name in names.arm_joints(side)]
    bench.simulation.observer = audit = Audit(bench.model, joints)
    try:
        bench.wait(SETTLING)
        controller = make(bench.arms[pair.side], _target(pair), posture.home(pair.side))
        hand, slowest = bench.drive(controller)
        bench.wait(COASTING)
    finally:
        bench.simulation.observer = None
    result, found = controller.result, audit.findings
    return Reach(
        pair,
        result.status,
        result.reason,
        result.seconds,
        *_errors(pair, hand),
        _of_arms(found.contacts),
        found.load,
        slowest,
    )


def _target(pair: ReachPair) -> mink.SE3:
    rotation = mink.SO3.from_matrix(pair.rotation)
    return mink.SE3.from_rotation_and_translation(rotation, pair.position)


def _errors(pair: ReachPair, hand: Sighting) -> tuple[float, float]:
    """Distance [m] and angle between the palm's axes [rad]."""
    offset = float(np.linalg.norm(hand.position - pair.position))
    return offset, angle_between(hand.rotation[:, 2], pair.rotation[:, 2])


def _of_arms(contacts: Counter[tuple[str, str]]) -> dict[tuple[str, str], int]:
    arms = tuple(f"{side}_" for side in names.SIDES)
    return {
        pair: steps
        for pair, steps in contacts.items()
        if any(name.startswith(arms) for name in pair)
    }


def run_in_parallel(
    pairs: Sequence[ReachPair], make: Make, jobs: int = 2
) -> list[Reach]:
    """All pairs, in their order."""
    return Parallel(n_jobs=jobs)(delayed(run)(pair, make) for pair in pairs)


def table(reaches: Sequence[Reach]) -> str:
    """A line for each arm, without and with the obstacle."""
    lines = [
        "arm   post   plannable  arrived  without contact  stalled  other  mean s"
        "  update ms"
    ]
    for side in names.SIDES:
        for post in (False, True):
            group = [
                r
                for r in reaches
                if r.pair.side == side and (r.pair.obstacle is not None) is post
            ]
            if group:
                lines.append(_line(side, post, group))
    return "\n".join(lines)


def _line(side: Side, post: bool, group: list[Reach]) -> str:
    """Of the plannable ones: how they ended, mean time, median slowest update."""
    able = [reach for reach in group if reach.pair.plannable]
    arrived = [reach for reach in able if reach.arrived]
    clean = sum(not reach.contacts for reach in arrived)
    stalled = sum(reach.status is Status.STALLED for reach in able)
    seconds = np.mean([reach.seconds for reach in arrived]) if arrived else np.nan
    slowest = np.median([reach.slowest_update for reach in able]) if able else np.nan
    return (
        f"{side:5} {'yes' if post else 'no':4} {len(able):5}/{len(group):<5}"
        f" {len(arrived):7} {clean:16} {stalled:8}"
        f" {len(able) - len(arrived) - stalled:6} {seconds:7.2f} {1e3 * slowest:10.1f}"
    )
