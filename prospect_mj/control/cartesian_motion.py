"""Closed-loop Cartesian motion of one hand: what gross and fine motion share."""

from dataclasses import dataclass

import mink
import numpy as np

from prospect_mj.control.arm_control import ArmControl
from prospect_mj.control.controller import CONTROL_PERIOD, Controller
from prospect_mj.control.result import Status, Targets
from prospect_mj.robot.torso import ArmReading, Reading

MIN_CONTACTS = 2
"""Fingertips that must feel the object for it to count as held while moving."""
RELEASE_TIME = 0.1
"""For how long fewer contacts are put down to vibration [s]."""


@dataclass(frozen=True)
class MotionSettings:
    """How fast, how exactly and for how long a hand moves."""

    speed: float
    """Of the grasp site along a straight line [m/s]."""
    turn_speed: float
    """[rad/s]. MuJoCo's contacts leave out the centripetal term of relative motion, so
    a held object creeps outward by about 1.5 timestep x speed x radius x angle: 1 mm
    for a quarter turn at 1.7 rad/s."""
    position_tolerance: float
    """[m]"""
    angle_tolerance: float
    """[rad]"""
    free_roll: bool
    """Whether turning about the palm's axis is left open."""
    windup: float
    """Most that the servo target may lead the measured joint angle [rad]; times the
    servo stiffness it bounds the torque."""
    time_budget: float
    """[s]"""
    rest_speed: float = np.inf
    """Hand speed below which it has arrived [m/s]; infinite = passing by."""
    ramp_time: float = 0.2
    """From rest to full speed [s]; a jerk would shake a held object loose."""
    stall_time: float = 1.0
    """Without any progress for this long, it has stalled [s]."""


@dataclass(frozen=True)
class PoseError:
    """Distance of a hand from its target."""

    position: float
    """[m]"""
    angle: float
    """[rad]"""


class HandServo:
    """The control law itself: straight to a pose, at bounded speed, closed loop.

    Args:
        arm: which arm, and its kinematics.
        posture: joint angles (7,) [rad] that resolve the redundancy.
        settings: speed, roll and wind-up.

    Attributes:
        speed: of the hand over the last control period [m/s].
    """

    def __init__(
        self, arm: ArmControl, posture: np.ndarray, settings: MotionSettings
    ) -> None:
        """Keep what the law needs."""
        self._arm, self._posture, self._settings = arm, posture, settings
        self._ticks = 0
        self._place: np.ndarray | None = None
        self.speed = 0.0

    def error(self, target: mink.SE3) -> PoseError:
        """How far the hand is from `target`, roll left out where it is free."""
        pose = self._arm.grasp_pose()
        place = pose.translation()
        before = place if self._place is None else self._place
        moved = float(np.linalg.norm(place - before))
        self.speed, self._place = moved / CONTROL_PERIOD, place
        offset = target.translation() - place
        turn = (pose.rotation().inverse() @ target.rotation()).log()
        if self._settings.free_roll:
            turn[2] = 0.0
        return PoseError(float(np.linalg.norm(offset)), float(np.linalg.norm(turn)))

    def step(
        self, reading: ArmReading, target: mink.SE3, windup: float | None = None
    ) -> np.ndarray:
        """Joint servo targets (7,) [rad] for the next control period.

        Args:
            reading: of this arm.
            target: pose of the grasp site in the world.
            windup: bound on the servo lead [rad], instead of that of the settings.
        """
        near = self._saturated(target)
        free_roll = self._settings.free_roll
        velocity = self._arm.ik.solve(near, self._posture, free_roll)
        windup = self._settings.windup if windup is None else windup
        # Integrating the command, not the measured angle, removes the servos' steady
        # error; the bound on its lead is the cap on what a blocked arm pushes with.
        ahead = reading.joint_command + velocity * CONTROL_PERIOD
        return np.clip(ahead, reading.joints - windup, reading.joints + windup)

    def _saturated(self, target: mink.SE3) -> mink.SE3:
        """A pose on the straight way that the IK gain turns into the wanted speed."""
        pose = self._arm.grasp_pose()
        self._ticks += 1
        ramp = self._ticks * CONTROL_PERIOD / self._settings.ramp_time
        reach = min(1.0, ramp) * CONTROL_PERIOD / self._arm.ik.settings.gain
        offset = target.translation() - pose.translation()
        turn = (pose.rotation().inverse() @ target.rotation()).log()
        offset = _shortened(offset, self._settings.speed * reach)
        turn = _shortened(turn, self._settings.turn_speed * reach)
        rotation = pose.rotation() @ mink.SO3.exp(turn)
        return mink.SE3.from_rotation_and_translation(
            rotation, pose.translation() + offset
        )


def _shortened(vector: np.ndarray, length: float) -> np.ndarray:
    norm = float(np.linalg.norm(vector))
    return vector if norm <= length else vector * (length / norm)


class CartesianMotion(Controller):
    """Move a hand to a pose, empty or with an object in it.

    Converges when the pose error is within tolerance; stalls when the error stops
    falling; loses the object when the fingertips stop feeling it.

    Args:
        arm: which arm, and its kinematics.
        target: pose of the grasp site in the world.
        posture: joint angles (7,) [rad] that resolve the redundancy.
        settings: speed, tolerances and time budget.
        carrying: whether an object must stay in the hand.
    """

    def __init__(
        self,
        arm: ArmControl,
        target: mink.SE3,
        posture: np.ndarray,
        settings: MotionSettings,
        carrying: bool = False,
    ) -> None:
        """Start towards `target`."""
        super().__init__(arm.side, settings.time_budget)
        self._servo = HandServo(arm, posture, settings)
        self._target, self._settings = target, settings
        self._carrying = carrying
        self._best, self._idle, self._empty = np.inf, 0.0, 0.0

    def _law(self, reading: Reading) -> Targets:
        own = reading[self.side]
        error = self._servo.error(self._target)
        self._judge(error, own)
        if self.result is not None:
            return Targets()
        return Targets(joints=self._servo.step(own, self._target))

    def _judge(self, error: PoseError, own: ArmReading) -> None:
        settings = self._settings
        self._watch(error, own)
        if self._empty > RELEASE_TIME:
            self._finish(Status.LOST, "fewer than two fingertips feel the object")
        elif (
            error.position < settings.position_tolerance
            and error.angle < settings.angle_tolerance
            and self._servo.speed < settings.rest_speed
        ):
            self._finish(Status.CONVERGED)
        elif self._idle > settings.stall_time:
            millimetres, degrees = error.position * 1e3, np.rad2deg(error.angle)
            reason = f"{millimetres:.1f} mm and {degrees:.1f} deg short of the target"
            self._finish(Status.STALLED, reason)

    def _watch(self, error: PoseError, own: ArmReading) -> None:
        """Time since the last progress, and since the object was last felt."""
        length = error.position + 0.1 * error.angle
        progress = length < 0.99 * self._best - 1e-5
        self._best = min(self._best, length) if progress else self._best
        self._idle = 0.0 if progress else self._idle + CONTROL_PERIOD
        held = not self._carrying or own.touch.found.sum() >= MIN_CONTACTS
        self._empty = 0.0 if held else self._empty + CONTROL_PERIOD
