"""The law behind every hand motion: straight to a pose, at bounded speed."""

from dataclasses import dataclass

import mink
import mujoco
import numpy as np

from prospect_mj.control.arm_control import ArmControl
from prospect_mj.control.controller import CONTROL_PERIOD
from prospect_mj.robot.torso import ArmReading


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
    """Servo targets that take a hand to a pose.

    Args:
        arm: which arm, and its kinematics.
        posture: joint angles (7,) [rad] that resolve the redundancy.
        settings: speed, roll and wind-up.
    """

    def __init__(
        self, arm: ArmControl, posture: np.ndarray, settings: MotionSettings
    ) -> None:
        """Keep what the law needs."""
        self._arm, self._posture, self._settings = arm, posture, settings
        self._ticks = 0

    def error(self, target: mink.SE3) -> PoseError:
        """How far the hand is from `target`, roll left out where it is free."""
        offset, turn = _difference(self._arm.grasp_pose(), target)
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
        offset, turn = _difference(pose, target)
        near = pose.wxyz_xyz.copy()
        turn = _shortened(turn, self._settings.turn_speed * reach)
        mujoco.mju_quatIntegrate(near[:4], turn, 1.0)
        near[4:] += _shortened(offset, self._settings.speed * reach)
        return mink.SE3(wxyz_xyz=near)


def _difference(pose: mink.SE3, target: mink.SE3) -> tuple[np.ndarray, np.ndarray]:
    """Offset (3,) [m] in the world and turn (3,) [rad] in the hand that remain."""
    # MuJoCo's own quaternion calculus: these run in every control period.
    turn = np.empty(3)
    mujoco.mju_subQuat(turn, target.wxyz_xyz[:4], pose.wxyz_xyz[:4])
    return target.wxyz_xyz[4:] - pose.wxyz_xyz[4:], turn


def _shortened(vector: np.ndarray, length: float) -> np.ndarray:
    norm = float(np.linalg.norm(vector))
    return vector if norm <= length else vector * (length / norm)
