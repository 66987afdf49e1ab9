"""Published facts of the three-finger BarrettHand, in SI units, and what they imply.

Sources: BH8-262 manual p. 75 (Craig DH parameters Aw, A1, A2, A3, D3); OpenRAVE
BarrettHand (distal bend Phi3, mass); GraspIt, barrett_model, OpenRAVE (ranges).

The palm frame has its origin on the wrist plate and z out of the palm. Finger 3 is
the thumb on the -x side; fingers 1 and 2 turn about the spread axes, which are locked
here at 60 degrees so that the three closing planes meet 120 degrees apart. One motor
drives both joints of a finger; the servos' commands are coupled, the joints are not,
and the TorqueSwitch, which lets the distal link close on alone, is not modelled.
"""

from dataclasses import dataclass

import numpy as np

FINGERS = (1, 2, 3)
FINGER_BASE = 0.050
"""DH A1 [m]: spread axis to proximal joint."""
SPREAD_AXIS = 0.025
"""DH Aw [m]: spread axes of fingers 1 and 2 from the hand's midline."""
PROXIMAL = 0.070
"""DH A2 [m]."""
DISTAL = 0.050
"""DH A3 [m]: distal joint to the centre of the fingertip sphere."""
TIP_RADIUS = 0.0095
"""DH D3 [m]."""
DISTAL_BEND = np.deg2rad(50.0)
"""DH Phi3 [rad]: the distal link's angle when the finger is fully open."""
COUPLING = 1.0 / 3.0
"""Distal angle per proximal angle: one motor drives both (375/125 of the worm)."""
PROXIMAL_RANGE = (0.0, np.deg2rad(140.0))
DISTAL_RANGE = (0.0, np.deg2rad(48.0))
SPREAD = np.deg2rad(60.0)
"""Where the spread joint is locked [rad]; its range is 0 to 180 degrees."""
MASS = 1.18
"""Whole hand [kg]."""
PALM_HEIGHT = 0.076
"""Dw [m], of the BH8-280: wrist plate to palm surface, where the fingers stand."""


@dataclass(frozen=True)
class FingerServo:
    """Worm-driven finger; ours, not published.

    A stiff position servo whose command stays put is what makes the hand
    non-backdrivable.
    """

    stiffness: float = 25.0
    """[N m / rad], both joints."""
    damping: float = 0.6
    """[N m s / rad]"""
    torque_limit: float = 2.5
    """[N m]: about 20 N at the fingertip."""
    armature: float = 0.002
    """[kg m^2]"""


SERVO = FingerServo()


def finger_base(finger: int) -> tuple[np.ndarray, float]:
    """Place of a finger's proximal joint on the palm of the left hand.

    Args:
        finger: 1, 2 or 3.

    Returns:
        The joint's position (3,) [m] in the palm frame and the direction in which the
        open finger points, an angle about z from x [rad].
    """
    if finger == 3:
        return np.array([-FINGER_BASE, 0.0, PALM_HEIGHT]), np.pi
    side = 1.0 if finger == 1 else -1.0
    heading = side * SPREAD
    outward = np.array([np.cos(heading), np.sin(heading), 0.0])
    axis = np.array([0.0, side * SPREAD_AXIS, PALM_HEIGHT])
    return axis + FINGER_BASE * outward, heading


def fingertip(finger: int, proximal: float) -> np.ndarray:
    """Centre of a fingertip of the left hand, distal joint coupled.

    Args:
        finger: 1, 2 or 3.
        proximal: proximal joint angle [rad], 0 = pointing outward along the palm.

    Returns:
        Position (3,) [m] in the palm frame.
    """
    base, heading = finger_base(finger)
    distal = proximal * (1.0 + COUPLING) + DISTAL_BEND
    reach = PROXIMAL * np.cos(proximal) + DISTAL * np.cos(distal)
    height = PROXIMAL * np.sin(proximal) + DISTAL * np.sin(distal)
    return base + [reach * np.cos(heading), reach * np.sin(heading), height]


def grasp_centre() -> np.ndarray:
    """Point of the palm where the three closing planes meet, (3,) [m]."""
    return np.array([-SPREAD_AXIS / np.tan(SPREAD), 0.0, PALM_HEIGHT])
