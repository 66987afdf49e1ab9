"""Transit: the large part of a movement, along a harmonic function's streamline."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from prospect_mj.control.arm_control import ArmControl
from prospect_mj.control.controller import CONTROL_PERIOD
from prospect_mj.control.posture_motion import PostureSettings
from prospect_mj.control.result import Status
from prospect_mj.planning.goals import GoalSet
from prospect_mj.planning.gross_plan import GrossPlan
from prospect_mj.planning.planner import World
from prospect_mj.planning.surroundings import KnownJars
from prospect_mj.robot import wam
from prospect_mj.robot.torso import ArmReading

_STIFFNESS, _DAMPING = np.array(wam.SERVO.stiffness), np.array(wam.SERVO.damping)
_LAG = (_DAMPING + wam.SERVO.friction_damping) / _STIFFNESS
"""By which a joint follows its command at constant speed [s]."""


@dataclass(frozen=True)
class TransitSettings:
    """How a streamline is followed."""

    ahead: float = 0.25
    """Arc length from the arm to the point that it heads for [rad]."""
    handover: float = 0.06
    """Distance from the goal at which the transit ends [rad]."""
    speed_share: float = 0.9
    """Of the joint velocity limits."""
    braking: float = 5.0
    """Speed per distance that is left [1/s]."""
    carrying_speed: float = PostureSettings.carrying_speed
    """Of the fastest joint while an object is in the hand [rad/s]; see
    `MotionSettings.turn_speed`."""
    acceleration: float = 5.0
    """Most that the wanted velocity of a joint changes [rad/s^2]."""
    torque_share: float = 0.85
    """Of the joints' torque limits that gravity, motion and acceleration may take."""
    slack: float = 0.10
    """Most that the reference may be ahead of the arm [rad]."""
    windup: float = 0.25
    """Most that a servo target may lead the measured angle [rad]."""
    look_period: float = 0.2
    """Between two looks at where the arm is and what has moved [s]."""
    stall_time: float = 1.0
    """Without progress for this long, it has stalled [s]."""


class Transit:
    """Follow a streamline in closed loop, and plan anew when the world has moved.

    Args:
        arm: which arm, its kinematics and its planner.
        goal_sets: each tells goal configurations, see `GrossPlanner.plan`.
        jars: where the jar is believed to be.
        carrying: whether an object is in the hand.
        settings: of the following.

    Attributes:
        plan: the way that it follows; None before the first look.
        arrived: whether a goal is near enough to hand over.
        way_left: arc length to the goal along the plan [rad]; None before there is one.
        failure: how and why it came to an end elsewhere.
    """

    def __init__(
        self,
        arm: ArmControl,
        goal_sets: Sequence[GoalSet],
        jars: KnownJars,
        carrying: bool,
        settings: TransitSettings | None = None,
    ) -> None:
        """Plan nothing yet: the first look does."""
        self._arm, self._goal_sets, self._jars = arm, goal_sets, jars
        self._settings = TransitSettings() if settings is None else settings
        speed = np.array(arm.ik.settings.velocity) * self._settings.speed_share
        most = self._settings.carrying_speed if carrying else np.inf
        self._speed = np.minimum(speed, most)
        self.plan: GrossPlan | None = None
        self.arrived, self._blocked = False, False
        self.failure: tuple[Status, str] | None = None
        self.way_left: float | None = None
        self._velocity = np.zeros_like(speed)
        self._reference: np.ndarray | None = None
        self._ticks, self._shortest, self._idle = 0, np.inf, 0.0

    @property
    def goal(self) -> np.ndarray:
        """Joint angles (7,) [rad] to which its plan leads."""
        return self.plan.path[-1]

    def step(self, own: ArmReading) -> np.ndarray | None:
        """Joint servo targets (7,) [rad] for the next control period, if it goes on."""
        if self._ticks % round(self._settings.look_period / CONTROL_PERIOD) == 0:
            self._look(own.joints)
        self._ticks += 1
        if self._reference is None:
            self._reference = own.joint_command.copy()
        if self.plan is None:
            self.failure = Status.UNREACHABLE, "no way to the goal"
            return None
        left = np.linalg.norm(self.goal - own.joints)
        self.arrived = bool(left < self._settings.handover)
        self.way_left = self.plan.length_left(own.joints)
        self._watch(self.way_left)
        if self.arrived or self.failure:
            return None
        return self._towards(own)

    def _look(self, joints: np.ndarray) -> None:
        """Take the streamline from where the arm is; plan if that way is blocked.

        If there is none, it waits for the way to become free.
        """
        planner, world = self._arm.planner, World(self._arm.twin.data, self._jars)
        plan = None if self.plan is None else planner.resume(self.plan, joints, world)
        if plan is None:
            # Under way there is no time to search for long.
            first = self.plan is None
            plan = planner.plan(joints, self._goal_sets, world, first)
            self._shortest = np.inf if plan is not None else self._shortest
        elif plan.goal != self.plan.goal:
            self._shortest = np.inf
        self._blocked = plan is None
        self.plan = self.plan if self._blocked else plan

    def _watch(self, left: float) -> None:
        """Give up when the way that is left no longer becomes shorter [rad]."""
        progress = left < self._shortest - 1e-3
        self._shortest = min(self._shortest, left)
        self._idle = 0.0 if progress else self._idle + CONTROL_PERIOD
        if self._idle > self._settings.stall_time:
            self.failure = Status.STALLED, f"{left:.2f} rad short of the goal"

    def _towards(self, own: ArmReading) -> np.ndarray:
        """Servo targets (7,) [rad] that take the arm along the path.

        A reference runs along the path, at most a little ahead of the arm; the servos,
        which follow a moving command with a constant lag, are told where it will be
        after that lag. So the arm itself is where the reference is, in bends as well.
        """
        slack = self._settings.slack
        self._reference = np.clip(
            self._reference, own.joints - slack, own.joints + slack
        )
        wanted = self._velocity + self._change(own)
        self._velocity = self._arm.ik.solve_velocity(wanted)
        self._reference += self._velocity * CONTROL_PERIOD
        target = self._reference + _LAG * self._velocity
        windup = self._settings.windup
        return np.clip(target, own.joints - windup, own.joints + windup)

    def _change(self, own: ArmReading) -> np.ndarray:
        """Change of velocity (7,) [rad/s] towards full speed along the path."""
        settings = self._settings
        ahead = self.plan.ahead(self._reference, settings.ahead) - self._reference
        direction = ahead / max(float(np.linalg.norm(ahead)), 1e-9)
        pace = (self._speed / np.maximum(np.abs(direction), 1e-9)).min()
        left = self.plan.length_left(self._reference)
        pace = 0.0 if self._blocked else min(pace, settings.braking * left)
        wanted = direction * pace
        change = wanted - self._velocity
        steepest = float(np.abs(change).max()) / CONTROL_PERIOD
        change *= min(1.0, settings.acceleration / max(steepest, 1e-9))
        return change * self._affordable(change / CONTROL_PERIOD, own)

    def _affordable(self, acceleration: np.ndarray, own: ArmReading) -> float:
        """Share of an acceleration (7,) [rad/s^2] that the joints have torque for."""
        twin, side = self._arm.twin, self._arm.side
        inertia, motion = twin.dynamics(side, own.velocities)
        # A command that stands still for a control period and then jumps takes more
        # than the smooth motion: by half a period's way, and by the change of speed.
        motion = motion + _STIFFNESS * self._velocity * CONTROL_PERIOD / 2
        torque = inertia @ acceleration + _DAMPING * acceleration * CONTROL_PERIOD
        most = self._settings.torque_share * np.array(wam.TORQUE_LIMITS)
        left = np.maximum(most - np.sign(torque) * motion, 0.05 * most)
        return min(1.0, float((left / np.maximum(np.abs(torque), 1e-9)).min()))
