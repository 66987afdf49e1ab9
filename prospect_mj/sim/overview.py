"""The scene as people like to see it: by daylight, from in front of the torso."""

import mujoco
import numpy as np

LOOK_AT, DISTANCE, AZIMUTH, ELEVATION = (0.38, -0.02, 0.40), 1.55, 203.0, -26.0


def camera() -> mujoco.MjvCamera:
    """A camera that shows both arms, the jar and the receptacle."""
    view = mujoco.MjvCamera()
    view.lookat[:] = LOOK_AT
    view.distance, view.azimuth, view.elevation = DISTANCE, AZIMUTH, ELEVATION
    return view


def light_for_people(model: mujoco.MjModel, size: tuple[int, int]) -> None:
    """Daylight, a wooden table and smooth edges; only once the eyes have looked.

    Args:
        model: changed in place.
        size: rows and columns of the largest picture to render [pixels].
    """
    look = model.vis
    look.global_.offheight, look.global_.offwidth = size
    look.quality.offsamples, look.quality.shadowsize = 8, 4096
    look.headlight.ambient[:], look.headlight.diffuse[:] = 0.50, 0.30
    # A narrow shadow map is a fine one; a coarse one speckles the arms.
    look.map.shadowscale = 0.4
    model.light_diffuse[:] *= 0.4
    model.geom("table/top").rgba[:3] = 0.52, 0.40, 0.28
    model.geom("table/floor").rgba[:3] = 0.62, 0.64, 0.66


def place() -> tuple[float, float, float]:
    """Where that camera stands [m]."""
    turn, rise = np.deg2rad((AZIMUTH, ELEVATION))
    ahead = np.array([np.cos(rise) * np.cos(turn), np.cos(rise) * np.sin(turn)])
    x, y = LOOK_AT[:2] - DISTANCE * ahead
    return float(x), float(y), float(LOOK_AT[2] - DISTANCE * np.sin(rise))
