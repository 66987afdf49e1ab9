"""The torso as its controllers see it: encoders, wrist and touch sensors, servos."""

from dataclasses import dataclass

import mujoco
import numpy as np

from prospect_mj.robot import barrett_hand, names
from prospect_mj.robot.names import SIDES, Side


@dataclass(frozen=True)
class Touch:
    """What the three fingertips of a hand feel; rows follow fingers 1, 2, 3."""

    found: np.ndarray
    """Whether the tip touches anything, (3,) bool."""
    force: np.ndarray
    """Normal force (3,) [N]."""
    shear: np.ndarray
    """Magnitude of the tangential force (3,) [N]."""
    position: np.ndarray
    """Place of the contact (3, 3) [m], world frame."""
    normal: np.ndarray
    """Unit normal into the touched object (3, 3), world frame."""


@dataclass(frozen=True)
class ArmReading:
    """All that one arm and its hand sense at one instant."""

    joints: np.ndarray
    """Joint angles (7,) [rad]."""
    velocities: np.ndarray
    """Joint velocities (7,) [rad/s]."""
    fingers: np.ndarray
    """Proximal angle of each finger (3,) [rad]."""
    wrist_force: np.ndarray
    """What the flange exerts on the hand, to carry its weight and load (3,) [N], in
    the wrist's frame."""
    wrist_torque: np.ndarray
    """The same for the moment about the wrist (3,) [N m]."""
    touch: Touch
    joint_command: np.ndarray
    """What the joint servos were last told (7,) [rad]."""
    finger_command: np.ndarray
    """What the finger motors were last told (3,) [rad]."""


Reading = dict[Side, ArmReading]


class Arm:
    """One arm with its hand: index views into MjData, and the servos' commands.

    Args:
        model: the scene.
        data: its live state.
        side: which arm.
    """

    def __init__(self, model: mujoco.MjModel, data: mujoco.MjData, side: Side) -> None:
        """Look up every index once."""
        self.side = side
        self._data = data
        joints = [model.joint(name).id for name in names.arm_joints(side)]
        self._qpos = model.jnt_qposadr[joints]
        self._qvel = model.jnt_dofadr[joints]
        self._servo = np.array([model.actuator(n).id for n in names.arm_joints(side)])
        fingers = np.array(names.finger_joints(side))
        proximal = [model.joint(name).id for name in fingers[:, 0]]
        self._finger_qpos = model.jnt_qposadr[proximal]
        self._finger_servo = np.array(
            [[model.actuator(name).id for name in pair] for pair in fingers]
        )
        self._force = _sensor(model, names.wrist_force(side))
        self._torque = _sensor(model, names.wrist_torque(side))
        self._touch = np.array([_sensor(model, n) for n in names.touches(side)])

    def read(self) -> ArmReading:
        """Sample all sensors; the arrays are copies."""
        data = self._data
        return ArmReading(
            joints=data.qpos[self._qpos],
            velocities=data.qvel[self._qvel],
            fingers=data.qpos[self._finger_qpos],
            wrist_force=data.sensordata[self._force],
            wrist_torque=data.sensordata[self._torque],
            touch=self._feel(),
            joint_command=data.ctrl[self._servo],
            finger_command=data.ctrl[self._finger_servo[:, 0]],
        )

    def _feel(self) -> Touch:
        rows = self._data.sensordata[self._touch]  # found, force, position, normal
        return Touch(
            found=rows[:, 0] > 0,
            force=np.abs(rows[:, 1]),
            shear=np.hypot(rows[:, 2], rows[:, 3]),
            position=rows[:, 4:7],
            normal=rows[:, 7:10],
        )

    def command_joints(self, angles: np.ndarray) -> None:
        """Set the position servos' targets, (7,) [rad]."""
        self._data.ctrl[self._servo] = angles

    def command_fingers(self, angles: np.ndarray) -> None:
        """Set the fingers' motors, (3,) [rad]; one motor drives both joints."""
        low, high = barrett_hand.PROXIMAL_RANGE
        motors = np.clip(angles, low, high)
        self._data.ctrl[self._finger_servo[:, 0]] = motors
        self._data.ctrl[self._finger_servo[:, 1]] = barrett_hand.COUPLING * motors


class Torso:
    """Both arms.

    Attributes:
        arms: each `Arm` by its side.
    """

    def __init__(self, model: mujoco.MjModel, data: mujoco.MjData) -> None:
        """Make the views of both sides."""
        self.arms: dict[Side, Arm] = {side: Arm(model, data, side) for side in SIDES}

    def read(self) -> Reading:
        """Sample all sensors of both arms."""
        return {side: arm.read() for side, arm in self.arms.items()}


def _sensor(model: mujoco.MjModel, name: str) -> np.ndarray:
    sensor = model.sensor(name)
    return np.arange(sensor.adr[0], sensor.adr[0] + sensor.dim[0])
