"""Named postures of an arm and a hand, written for the left and reflected."""

import numpy as np
from scipy.optimize import brentq, fsolve

from prospect_mj.robot import barrett_hand, names, wam
from prospect_mj.robot.barrett_hand import grasp_centre
from prospect_mj.robot.names import Side

# Found by following each wrist flip from home over grasp and presentation to the well:
# this one turns the least on the way and keeps 0.33 rad from every joint limit.
_HOME = (0.60, 0.77, -0.52, 1.55, -2.59, -1.01, 0.94)
_PRESENTING = (0.26, 0.79, -0.19, 2.16, -2.33, -0.32, 0.46)
_OVER_WELL = (-0.21, 1.50, 0.42, 2.29, -1.44, -1.23, 0.20)

OPEN = (0.95, 0.95, 0.60)
"""Proximal angle of each open finger [rad]: fingertips 0.09 m from the axis. The thumb,
nearer to the grasp centre, opens wider, so that all three reach a cylinder at the same
time and none pushes it away."""

_CLOSED = 1.5
"""Beyond this the fingertips have passed the nominal cylinder's axis side [rad]."""

NOMINAL_GRASP_RADIUS = 0.0385
"""Half-way between the jar's body and its lid [m]: where the preshape is exact."""


def reflected(angles: tuple[float, ...], side: Side) -> np.ndarray:
    """Joint angles (7,) [rad] of a side, from those of the left arm."""
    mirror = np.where(np.array(wam.MIRROR) < 0, names.sign(side), 1)
    return mirror * np.array(angles)


def home(side: Side) -> np.ndarray:
    """At rest beside the presentation area, palm inward, out of the eyes' view."""
    return reflected(_HOME, side)


def presenting(side: Side) -> np.ndarray:
    """Holding a jar in front of the chest, where it can be handed over."""
    return reflected(_PRESENTING, side)


def over_well(side: Side) -> np.ndarray:
    """Palm down over the receptacle, elbow high; no wrist joint near its limit."""
    return reflected(_OVER_WELL, side)


def grasp_frame() -> tuple[np.ndarray, float]:
    """Frame of a preshaped grasp: where contacts with a nominal cylinder balance.

    The thumb is nearer to the grasp centre than fingers 1 and 2, so it meets a
    cylinder higher above the palm. A cylinder whose axis leans about y and stands a
    little aside is met with no net force or moment of the three unit normals.

    Returns:
        The frame's origin (3,) [m] in the left hand's palm frame, and its lean about
        y [rad].
    """
    start = np.array([grasp_centre()[0], 0.0])
    offset, lean = fsolve(_imbalance, start)
    tips = _contacts(offset, lean)[0]
    origin = np.array([offset, 0.0, grasp_centre()[2]])
    along = float(np.mean((tips - origin) @ _axis(lean)))
    return origin + along * _axis(lean), float(lean)


def _axis(lean: float) -> np.ndarray:
    return np.array([np.sin(lean), 0.0, np.cos(lean)])


def _imbalance(place: np.ndarray) -> np.ndarray:
    """Net force along x and moment about y of unit normals, (2,) [1, m]."""
    tips, normals = _contacts(*place)
    moment = np.cross(tips - tips.mean(axis=0), normals).sum(axis=0)
    return np.array([normals.sum(axis=0)[0], moment[1]])


def _contacts(offset: float, lean: float) -> tuple[np.ndarray, np.ndarray]:
    """Fingertip centres (3, 3) [m] on a leaning nominal cylinder, and the normals."""
    foot = np.array([offset, 0.0, grasp_centre()[2]])
    tips = np.array([_tip_on(f, foot, _axis(lean)) for f in barrett_hand.FINGERS])
    across = tips - foot
    across -= np.outer(across @ _axis(lean), _axis(lean))
    return tips, -across / np.linalg.norm(across, axis=1, keepdims=True)


def _tip_on(finger: int, foot: np.ndarray, axis: np.ndarray) -> np.ndarray:
    """Fingertip centre (3,) [m] when it touches the nominal cylinder about an axis."""
    target = NOMINAL_GRASP_RADIUS + barrett_hand.TIP_RADIUS

    def gap(angle: float) -> float:
        offset = barrett_hand.fingertip(finger, angle) - foot
        return float(np.linalg.norm(np.cross(axis, offset))) - target

    return barrett_hand.fingertip(finger, float(brentq(gap, 0.5, _CLOSED)))
