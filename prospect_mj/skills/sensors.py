"""What the robot senses of itself, at one instant and all along a skill."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from prospect_mj.robot.names import SIDES, Side
from prospect_mj.robot.torso import ArmReading, Reading

PerSide: TypeAlias = dict[Side, NDArray[Any]]
"""An array for each arm, by `"left"` and `"right"`."""


@dataclass(frozen=True, eq=False)
class Sensors:
    """What both arms sense at one instant; each field is a dictionary by side.

    Rows of the fingertips follow fingers 1, 2, 3. What the servos were told is that of
    the control period before.
    """

    joints: PerSide
    """Joint angles, shoulder to wrist (7,) [rad]."""
    joint_targets: PerSide
    """What the joint servos were last told (7,) [rad]."""
    velocities: PerSide
    """Joint velocities (7,) [rad/s]."""
    fingers: PerSide
    """Proximal angle of each finger (3,) [rad]."""
    finger_targets: PerSide
    """What the finger motors were last told (3,) [rad]."""
    hand: PerSide
    """Pose of the grasp site in the world, by the encoders (7,): quaternion, w first,
    and position [m]."""
    wrist_force: PerSide
    """What the flange exerts on the hand, to carry its weight and load (3,) [N], in
    the wrist's frame."""
    wrist_torque: PerSide
    """The same for the moment about the wrist (3,) [N m]."""
    touching: PerSide
    """Whether each fingertip touches anything (3,) bool."""
    touch_force: PerSide
    """Normal force of each fingertip (3,) [N]."""
    touch_shear: PerSide
    """Tangential force of each fingertip (3,) [N]."""
    touch_position: PerSide
    """Place of each contact in the world (3, 3) [m]."""
    touch_normal: PerSide
    """Unit normal of each contact into what is touched, in the world (3, 3)."""


@dataclass(frozen=True, eq=False)
class Trajectory(Sensors):
    """What both arms sensed in each of n control periods, and after the last one.

    The arrays are those of `Sensors` with one more axis in front, of length n + 1.
    """

    times: NDArray[np.float64]
    """Since the skill began (n + 1,) [s]."""


def sensors(reading: Reading, hands: Mapping[Side, NDArray[np.float64]]) -> Sensors:
    """Put together what is sensed at one instant.

    Args:
        reading: of both arms.
        hands: pose of each grasp site in the world (7,), as `Sensors.hand`.
    """
    arms = {side: _arm(reading[side], hands[side]) for side in SIDES}
    names = [field.name for field in fields(Sensors)]
    return Sensors(**{n: {side: arms[side][n] for side in SIDES} for n in names})


def _arm(own: ArmReading, hand: NDArray[np.float64]) -> dict[str, NDArray[Any]]:
    return {
        "joints": own.joints,
        "joint_targets": own.joint_command,
        "velocities": own.velocities,
        "fingers": own.fingers,
        "finger_targets": own.finger_command,
        "hand": hand.copy(),
        "wrist_force": own.wrist_force,
        "wrist_torque": own.wrist_torque,
        "touching": own.touch.found,
        "touch_force": own.touch.force,
        "touch_shear": own.touch.shear,
        "touch_position": own.touch.position,
        "touch_normal": own.touch.normal,
    }


def trajectory(times: NDArray[np.float64], rows: Sequence[Sensors]) -> Trajectory:
    """Stack what was sensed, a row for each of the times (n + 1,) [s]."""
    stacked = {
        field.name: {
            side: np.stack([getattr(row, field.name)[side] for row in rows])
            for side in SIDES
        }
        for field in fields(Sensors)
    }
    return Trajectory(**stacked, times=times)
