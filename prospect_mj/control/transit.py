"""Transit: the large part of a movement, along the streamline of a harmonic function."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from prospect_mj.control.arm_control import ArmControl
from prospect_mj.control.controller import CONTROL_PERIOD
from prospect_mj.control.result import Status
from prospect_mj.planning.planner import GrossPlan, World
from prospect_mj.planning.surroundings import KnownJars
from prospect_mj.robot.torso import ArmReading


@dataclass(frozen=True)
class TransitSettings:
    """How a streamline is followed."""

    ahead: float = 0.25
    """Arc length from the arm to the point that it heads for [rad]."""
    handover: float = 0.15
    """Distance from the goal at which the transit ends [rad]."""
    speed_share: float = 0.9
    """Of the joint velocity limits."""
    braking: float = 5.0
    """Speed per distance that is left [1/s]."""
    carrying_speed: float = 1.2
    """Of the fastest joint while an object is in the hand [rad/s]; see
    `MotionSettings.turn_speed`."""
    ramp_time: float = 0.2
    """From rest to full speed [s]."""
    windup: float = 0.15
    """Most that a servo target may lead the measured angle [rad]."""
    look_period: float = 0.2
    """Between two looks at where the arm is and what has moved [s]."""
    stall_time: float = 1.0
    """Without progress for this long, it has stalled [s]."""


class Transit:
    """Follow a streamline in closed loop, and plan anew when the world has moved.

    Args:
        arm: which arm, its kinematics and its planner.
        goals: tells the goal configurations (n, 7) [rad] when they are first needed.
        jars: where the jar is believed to be.
        carrying: whether an object is in the hand.
        settings: of the following.

    Attributes:
        plan: the way that it follows; None before the first look.
        arrived: whether a goal is near enough to hand over.
        failure: how and why it came to an end elsewhere.
    """

    def __init__(
        self,
        arm: ArmControl,
        goals: Callable[[], np.ndarray],
        jars: KnownJars,
        carrying: bool,
        settings: TransitSettings | None = None,
    ) -> None:
        """Plan nothing yet: the first look does."""
        self._arm, self._find_goals, self._jars = arm, goals, jars
        self._settings = TransitSettings() if settings is None else settings
        speed = np.array(arm.ik.settings.velocity) * self._settings.speed_share
        most = self._settings.carrying_speed if carrying else np.inf
        self._speed = np.minimum(speed, most)
        self._goals: np.ndarray | None = None
        self.plan: GrossPlan | None = None
        self.arrived, self._blocked = False, False
        self.failure: tuple[Status, str] | None = None
        self._ticks, self._shortest, self._idle = 0, np.inf, 0.0

    @property
    def goal(self) -> np.ndarray:
        """Joint angles (7,) [rad] to which its plan leads."""
        return self.plan.path[-1]

    @property
    def _seconds(self) -> float:
        return self._ticks * CONTROL_PERIOD

    def step(self, own: ArmReading) -> np.ndarray | None:
        """Joint servo targets (7,) [rad] for the next control period, if it goes on."""
        if self._ticks % round(self._settings.look_period / CONTROL_PERIOD) == 0:
            self._look(own.joints)
        self._ticks += 1
        if self.plan is None:
            self.failure = Status.UNREACHABLE, "no way to the goal"
            return None
        left = np.linalg.norm(self.goal - own.joints)
        self.arrived = bool(left < self._settings.handover)
        self._watch(self.plan.length_left(own.joints))
        if self.arrived or self.failure:
            return None
        return own.joint_command if self._blocked else self._towards(own)

    def _look(self, joints: np.ndarray) -> None:
        """Take the streamline from where the arm is; plan if that way is blocked.

        If there is none, it waits for the way to become free.
        """
        planner, world = self._arm.planner, World(self._arm.twin.data, self._jars)
        plan = None if self.plan is None else planner.resume(self.plan, joints, world)
        if plan is None:
            if self._goals is None:
                self._goals = self._find_goals()
            plan = planner.plan(joints, self._goals, world)
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
        """Servo targets (7,) [rad] for full speed towards the path ahead."""
        settings = self._settings
        ahead = self.plan.ahead(own.joints, settings.ahead)
        left = float(np.linalg.norm(self.goal - own.joints))
        direction = (ahead - own.joints) / np.linalg.norm(ahead - own.joints)
        pace = (self._speed / np.maximum(np.abs(direction), 1e-9)).min()
        pace *= min(1.0, self._seconds / settings.ramp_time)
        velocity = direction * min(pace, settings.braking * left)
        velocity = self._arm.ik.solve_velocity(velocity)
        target = own.joint_command + velocity * CONTROL_PERIOD
        windup = settings.windup
        return np.clip(target, own.joints - windup, own.joints + windup)
