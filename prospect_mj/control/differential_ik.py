"""Differential inverse kinematics of one arm: mink's QP with limits.

At the measured configuration q it solves

    min_v  |J v dt + gain e(q)|^2_W + posture + damping
    s.t.   joint limits, velocity limits, collision avoidance, other arm at rest

(Zakka, mink; Kanoun 2011). The QP may have no solution, for instance when an arm
is pushed beyond a limit: then it is solved again without velocity limits, and failing
that the arm holds still; both are counted.
"""

from dataclasses import dataclass

import mink
import numpy as np
from mink.limits.limit import Constraint

from prospect_mj.control.controller import CONTROL_PERIOD
from prospect_mj.control.kinematics import KinematicTwin
from prospect_mj.robot import names
from prospect_mj.robot.names import Side
from prospect_mj.sim.scene import LAMP, OBSTACLE, PEDESTAL, TABLE, WELL


@dataclass(frozen=True)
class IKSettings:
    """Weights and limits of the QP."""

    gain: float = 0.20
    """Share of the pose error to remove per control period; above 0.5 it jitters."""
    orientation_cost: float = 0.5
    """[1/rad] against a position cost of 1 [1/m]."""
    posture_cost: float = 5e-3
    """Pull towards the reference posture; 3e-2 would bias the palm by 2.5 mm."""
    posture_gain: float = 0.05
    damping_cost: float = 1e-2
    limit_margin: float = 0.03
    """Kept from every joint limit [rad]."""
    velocity: tuple[float, ...] = (1.2, 1.2, 1.6, 1.6, 1.8, 1.8, 1.8)
    """Joint velocity limits [rad/s]: the WAM's 2.0 less what the servos overshoot, and
    slower at the shoulder, which carries the most."""
    clearance: float = 0.01
    """Least distance between links and anything else [m]."""
    approach_gain: float = 0.10
    """Share of the distance beyond the clearance that may be closed per control
    period; the servos lag by 0.12 s, so a larger one would overshoot into contact."""
    detection: float = 0.12
    """Distance from which on approaching is slowed [m]."""


@dataclass
class IKCounters:
    """How often the QP had no solution."""

    without_velocity_limit: int = 0
    held_still: int = 0


class _ActiveCollisionLimit(mink.CollisionAvoidanceLimit):
    """Only the rows of pairs that are near; the QP solver need not see the others."""

    def compute_qp_inequalities(
        self, configuration: mink.Configuration, dt: float
    ) -> Constraint:
        full = super().compute_qp_inequalities(configuration, dt)
        near = np.isfinite(full.h)
        if not near.any():
            return Constraint()
        # mink bounds a speed here, but its QP is over displacements: without the
        # period a hand may come gain / dt = 15 times as near in one step as is left.
        return Constraint(G=full.G[near], h=full.h[near] * dt)


class DifferentialIK:
    """Joint velocities that take one hand towards a pose.

    Args:
        twin: kept up to date by the caller.
        side: the arm to move; the other one is held still.
        settings: weights and limits.

    Attributes:
        counters: of infeasible problems.
    """

    def __init__(
        self, twin: KinematicTwin, side: Side, settings: IKSettings | None = None
    ) -> None:
        """Set up tasks and limits once."""
        self.settings = settings = IKSettings() if settings is None else settings
        self.counters = IKCounters()
        self._twin, self._side = twin, side
        model = twin.model
        self._own = twin.columns(side)
        self._frame = mink.FrameTask(
            names.grasp_site(side),
            "site",
            position_cost=1.0,
            orientation_cost=settings.orientation_cost,
            gain=settings.gain,
            lm_damping=1e-3,
        )
        self._posture = mink.PostureTask(
            model, cost=settings.posture_cost, gain=settings.posture_gain
        )
        self._tasks = [
            self._frame,
            self._posture,
            mink.DampingTask(model, cost=settings.damping_cost),
        ]
        self._rest = mink.PostureTask(model, cost=1.0, gain=settings.gain)
        others = np.setdiff1d(np.arange(model.nv), self._own)
        self._frozen = [mink.DofFreezingTask(model, dof_indices=others.tolist())]
        limits = zip(names.arm_joints(side), settings.velocity, strict=True)
        self._speed = mink.VelocityLimit(model, dict(limits))
        self._limits = [
            mink.ConfigurationLimit(
                model, gain=0.5, min_distance_from_limits=settings.limit_margin
            ),
            _collision_limit(twin, side, settings),
        ]

    def solve(
        self, target: mink.SE3, posture: np.ndarray, free_roll: bool
    ) -> np.ndarray:
        """Joint velocities (7,) [rad/s] towards a target pose of the grasp site.

        Args:
            target: pose in the world.
            posture: reference joint angles (7,) [rad] that resolve the redundancy.
            free_roll: whether turning about the site's z axis is left open.
        """
        cost = self.settings.orientation_cost
        self._frame.set_orientation_cost([cost, cost, 0.0 if free_roll else cost])
        self._frame.set_target(target)
        reference = self._twin.configuration.q.copy()
        reference[self._own] = posture
        self._posture.set_target(reference)
        return self._solve(self._tasks)[self._own]

    def solve_posture(self, posture: np.ndarray) -> np.ndarray:
        """Joint velocities (7,) [rad/s] towards joint angles (7,) [rad]."""
        reference = self._twin.configuration.q.copy()
        reference[self._own] = posture
        self._rest.set_target(reference)
        return self._solve([self._rest])[self._own]

    def solve_velocity(self, velocity: np.ndarray) -> np.ndarray:
        """The nearest admissible to joint velocities (7,) [rad/s] that are wanted."""
        here = self._twin.configuration.q[self._own]
        return self.solve_posture(here + velocity * CONTROL_PERIOD / self.settings.gain)

    def _solve(self, tasks: list[mink.Task]) -> np.ndarray:
        try:
            return self._attempt(tasks, [*self._limits, self._speed])
        except mink.NoSolutionFound:
            self.counters.without_velocity_limit += 1
        try:
            velocity = self._attempt(tasks, self._limits)
        except mink.NoSolutionFound:
            self.counters.held_still += 1
            return np.zeros(self._twin.model.nv)
        scale = np.abs(velocity[self._own]) / np.array(self.settings.velocity)
        return velocity / max(1.0, float(scale.max()))

    def _attempt(self, tasks: list[mink.Task], limits: list[mink.Limit]) -> np.ndarray:
        return mink.solve_ik(
            self._twin.configuration,
            tasks,
            CONTROL_PERIOD,
            solver="daqp",
            damping=1e-6,
            limits=limits,
            constraints=self._frozen,
        )


def _collision_limit(
    twin: KinematicTwin, side: Side, settings: IKSettings
) -> _ActiveCollisionLimit:
    """Own arm and hand against trunk, head, fixtures and the other arm."""
    model = twin.model
    arm = _geoms(twin, *names.arm_links(side)[2:], names.palm(side))
    hand = _fingers(side)
    other = names.other(side)
    rival = _geoms(twin, *names.arm_links(other)[2:], names.palm(other))
    rival += _fingers(other)
    whole = (f"{PEDESTAL}/", f"{WELL}/wall", f"{OBSTACLE}/")
    fixtures = [
        model.geom(i).name
        for i in range(model.ngeom)
        if model.geom(i).name.startswith(whole)
    ] + [f"{LAMP}/shade", f"{TABLE}/top"]
    body = _geoms(twin, "trunk", "head")
    own = _geoms(twin, *names.arm_links(side)[1:3])
    return _ActiveCollisionLimit(
        model,
        [(arm + hand, fixtures), (arm + hand, rival), (arm + hand, body), (hand, own)],
        gain=settings.approach_gain,
        minimum_distance_from_collisions=settings.clearance,
        collision_detection_distance=settings.detection,
    )


def _geoms(twin: KinematicTwin, *bodies: str) -> list[str]:
    model = twin.model
    ids = [model.body(name).id for name in bodies]
    geoms = range(model.ngeom)
    return [model.geom(i).name for i in geoms if model.geom_bodyid[i] in ids]


def _fingers(side: Side) -> list[str]:
    """Both links of every finger; the fingertips are within the clearance of them."""
    return [joint for pair in names.finger_joints(side) for joint in pair]
