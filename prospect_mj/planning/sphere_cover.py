"""Covers of primitive geoms by spheres that contain them."""

import mujoco
import numpy as np

from prospect_mj.errors import InvalidChoice

_SLENDERNESS = 0.8
"""Distance of neighbouring spheres in radii of the geom: the cover stands out by a
thirteenth of the radius, and by more at the ends of a cylinder."""

_SPACING = 0.02
"""Where this is more, it is taken instead [m]: a finger needs no fine cover."""


def cover(kind: int, size: np.ndarray) -> np.ndarray:
    """Spheres that together contain a geom.

    Args:
        kind: MuJoCo's type of geom: a sphere, or a capsule or cylinder along z.
        size: of the geom as MuJoCo has it (3,) [m].

    Returns:
        Centres on the geom's z axis and radii (n, 2) [m].

    Raises:
        InvalidChoice: on another type of geom.
    """
    radius, half = float(size[0]), float(size[1])
    if kind == mujoco.mjtGeom.mjGEOM_SPHERE:
        return np.array([[0.0, radius]])
    spacing = max(_SLENDERNESS * radius, _SPACING)
    n = max(1, int(np.ceil(2 * half / spacing)))
    if kind == mujoco.mjtGeom.mjGEOM_CAPSULE:
        # One more than intervals: the round ends are the first and the last sphere.
        heights = np.linspace(-half, half, n + 1)
    elif kind == mujoco.mjtGeom.mjGEOM_CYLINDER:
        heights = (np.arange(n) - (n - 1) / 2) * 2 * half / n
    else:
        valid = ["sphere", "capsule", "cylinder"]
        raise InvalidChoice("geom to cover", mujoco.mjtGeom(kind).name, valid)
    reach = np.hypot(radius, half / n)
    return np.column_stack([heights, np.full(len(heights), reach)])


def bounding_sphere(spheres: np.ndarray) -> np.ndarray:
    """One sphere (4,) round spheres (n, 4), each a centre and a radius [m]."""
    centre = (
        (spheres[:, :3] - spheres[:, 3:]).min(axis=0)
        + (spheres[:, :3] + spheres[:, 3:]).max(axis=0)
    ) / 2
    away = np.linalg.norm(spheres[:, :3] - centre, axis=1)
    return np.array([*centre, (away + spheres[:, 3]).max()])
