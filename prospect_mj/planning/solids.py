"""Solids: MuJoCo's collision geometry as plain numbers, and distances to it."""

import mujoco
import numpy as np
from numba import njit

from prospect_mj.errors import InvalidChoice

KIND, BOUND, PARTNERS, CENTRE, ROTATION, SIZE = 0, 1, 2, 3, 6, 15
"""Columns of a row of solids: MuJoCo's type of geom, radius of a sphere round it [m],
the links that it concerns (bits), centre [m], rotation matrix row by row, size [m]."""
COLUMNS = 18

_SPHERE = int(mujoco.mjtGeom.mjGEOM_SPHERE)
_CAPSULE = int(mujoco.mjtGeom.mjGEOM_CAPSULE)
_CYLINDER = int(mujoco.mjtGeom.mjGEOM_CYLINDER)
_BOX = int(mujoco.mjtGeom.mjGEOM_BOX)
_KNOWN = {_SPHERE, _CAPSULE, _CYLINDER, _BOX}


def solids(
    model: mujoco.MjModel, data: mujoco.MjData, geoms: list[int], partners: int
) -> np.ndarray:
    """Geoms where they are now, as rows (n, 18).

    Args:
        model: has the geoms.
        data: its kinematics up to date.
        geoms: their numbers.
        partners: bits of the links that they concern.

    Raises:
        InvalidChoice: if a geom is of another type than the primitives.
    """
    rows = np.empty((len(geoms), COLUMNS))
    for row, geom in zip(rows, geoms, strict=True):
        kind = int(model.geom_type[geom])
        if kind not in _KNOWN:
            names = [mujoco.mjtGeom(k).name for k in sorted(_KNOWN)]
            raise InvalidChoice("type of geom", mujoco.mjtGeom(kind).name, names)
        size = model.geom_size[geom]
        row[:] = solid(kind, data.geom_xpos[geom], data.geom_xmat[geom], size, partners)
    return rows


def cylinder(
    centre: np.ndarray, rotation: np.ndarray, radius: float, half: float, partners: int
) -> np.ndarray:
    """A cylinder along z of a rotation (3, 3), as a row (18,)."""
    size = np.array([radius, half, 0.0])
    return solid(_CYLINDER, centre, rotation.ravel(), size, partners)


def solid(
    kind: int,
    centre: np.ndarray,
    rotation: np.ndarray,
    size: np.ndarray,
    partners: int,
) -> np.ndarray:
    """One row (18,) of solids; `rotation` is (9,), row by row."""
    bound = {
        _SPHERE: size[0],
        _CAPSULE: size[0] + size[1],
        _CYLINDER: np.hypot(size[0], size[1]),
        _BOX: np.linalg.norm(size),
    }[kind]
    return np.concatenate([[kind, bound, partners], centre, rotation, size])


@njit(cache=True)
def distance(x: float, y: float, z: float, rows: np.ndarray, i: int) -> float:
    """Signed distance of a point to solid `i` [m], negative inside."""
    dx, dy, dz = x - rows[i, 3], y - rows[i, 4], z - rows[i, 5]
    kind = int(rows[i, 0])
    if kind == _SPHERE:
        return np.sqrt(dx * dx + dy * dy + dz * dz) - rows[i, 15]
    along = dx * rows[i, 8] + dy * rows[i, 11] + dz * rows[i, 14]
    if kind == _CAPSULE:
        nearest = min(max(along, -rows[i, 16]), rows[i, 16])
        square = dx * dx + dy * dy + dz * dz - along * along
        beyond = along - nearest
        return np.sqrt(max(square, 0.0) + beyond * beyond) - rows[i, 15]
    if kind == _CYLINDER:
        square = dx * dx + dy * dy + dz * dz - along * along
        return _corner(
            np.sqrt(max(square, 0.0)) - rows[i, 15], abs(along) - rows[i, 16], -1e9
        )
    first = dx * rows[i, 6] + dy * rows[i, 9] + dz * rows[i, 12]
    second = dx * rows[i, 7] + dy * rows[i, 10] + dz * rows[i, 13]
    return _corner(
        abs(first) - rows[i, 15], abs(second) - rows[i, 16], abs(along) - rows[i, 17]
    )


@njit(cache=True)
def _corner(a: float, b: float, c: float) -> float:
    """Distance from how far a point is beyond each of three pairs of faces [m]."""
    inside = max(a, b, c)
    if inside <= 0.0:
        return inside
    a, b, c = max(a, 0.0), max(b, 0.0), max(c, 0.0)
    return np.sqrt(a * a + b * b + c * c)
