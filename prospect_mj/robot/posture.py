"""Named postures of an arm and a hand, written for the left and reflected."""

import numpy as np
from scipy.optimize import brentq

from prospect_mj.robot import barrett_hand, names, wam
from prospect_mj.robot.names import Side

_HOME = (0.60, 0.75, -0.45, 1.6, 0.45, 0.9, -0.6)
_OVER_WELL = (-0.5, 1.5, 0.65, 2.2, 1.4, 0.8, -0.2)

OPEN = 0.6
"""Proximal angle of an open finger [rad]: fingertips about 0.11 m from the axis."""

NOMINAL_GRASP_RADIUS = 0.0405
"""Half-way between the jar's body and its lid [m]: where the preshape is exact."""


def reflected(angles: tuple[float, ...], side: Side) -> np.ndarray:
    """Joint angles (7,) [rad] of a side, from those of the left arm."""
    mirror = np.where(np.array(wam.MIRROR) < 0, names.sign(side), 1)
    return mirror * np.array(angles)


def home(side: Side) -> np.ndarray:
    """At rest beside the presentation area, palm inward, out of the eyes' view."""
    return reflected(_HOME, side)


def over_well(side: Side) -> np.ndarray:
    """Palm down over the receptacle, elbow high; no wrist joint near its limit."""
    return reflected(_OVER_WELL, side)


def grasp_frame() -> tuple[np.ndarray, float]:
    """Frame of a preshaped grasp: the plane of the fingertips on a nominal cylinder.

    The thumb is nearer to the grasp centre than fingers 1 and 2, so it meets a
    cylinder higher above the palm; leaning the grasp frame by that much about y makes
    the contact moments cancel from the first touch on.

    Returns:
        The frame's origin (3,) [m] in the left hand's palm frame, and its lean about
        y [rad].
    """
    centre = barrett_hand.grasp_centre()
    tips = [_tip_on_cylinder(finger) for finger in barrett_hand.FINGERS]
    thumb, pair = tips[2], (tips[0] + tips[1]) / 2
    lean = np.arctan2(thumb[2] - pair[2], pair[0] - thumb[0])
    share = (centre[0] - thumb[0]) / (pair[0] - thumb[0])
    height = thumb[2] + share * (pair[2] - thumb[2])
    return np.array([centre[0], 0.0, height]), float(lean)


def _tip_on_cylinder(finger: int) -> np.ndarray:
    """Fingertip centre (3,) [m] when it touches the nominal cylinder."""
    centre = barrett_hand.grasp_centre()
    target = NOMINAL_GRASP_RADIUS + barrett_hand.TIP_RADIUS

    def gap(angle: float) -> float:
        offset = barrett_hand.fingertip(finger, angle) - centre
        base, heading = barrett_hand.finger_base(finger)
        outward = np.array([np.cos(heading), np.sin(heading), 0.0])
        return float(offset @ outward) - target

    return barrett_hand.fingertip(finger, float(brentq(gap, OPEN, 1.8)))
