"""From where people see an episode: the lamp's stand is out of the way."""

import mujoco
import numpy as np

TARGET = (0.28, 0.0, 0.40)
"""What is in the middle of the picture [m]."""
_DISTANCE = 1.40
"""[m]"""
_AZIMUTH, _ELEVATION = 155.4, -21.8
"""As MuJoCo counts them [degrees]."""
_NARROWER = 1.12
"""MuJoCo's cameras see less than Rerun's, and are as much farther away."""


def place() -> tuple[float, float, float]:
    """Where Rerun's eye is [m]."""
    turn, rise = np.deg2rad((_AZIMUTH, _ELEVATION))
    level = np.cos(rise)
    ahead = np.array([level * np.cos(turn), level * np.sin(turn), np.sin(rise)])
    x, y, z = TARGET - _DISTANCE * ahead
    return float(x), float(y), float(z)


def camera() -> mujoco.MjvCamera:
    """The same for MuJoCo's renderer."""
    view = mujoco.MjvCamera()
    view.lookat[:] = TARGET
    view.distance = _NARROWER * _DISTANCE
    view.azimuth, view.elevation = _AZIMUTH, _ELEVATION
    return view
