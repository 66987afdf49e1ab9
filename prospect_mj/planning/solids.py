"""Solids: MuJoCo's collision geometry as rows of plain numbers, for compiled code."""

import mujoco
import numpy as np

from prospect_mj.errors import InvalidChoice
from prospect_mj.planning.arm_kernels import BOX, CAPSULE, COLUMNS, CYLINDER, SPHERE

_KNOWN = (SPHERE, CAPSULE, CYLINDER, BOX)


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
            names = [mujoco.mjtGeom(k).name for k in _KNOWN]
            raise InvalidChoice("type of geom", mujoco.mjtGeom(kind).name, names)
        size = model.geom_size[geom]
        row[:] = solid(kind, data.geom_xpos[geom], data.geom_xmat[geom], size, partners)
    return rows


def cylinder(
    centre: np.ndarray, rotation: np.ndarray, radius: float, half: float, partners: int
) -> np.ndarray:
    """A cylinder along z of a rotation (3, 3), as a row (18,)."""
    size = np.array([radius, half, 0.0])
    return solid(CYLINDER, centre, rotation.ravel(), size, partners)


def solid(
    kind: int,
    centre: np.ndarray,
    rotation: np.ndarray,
    size: np.ndarray,
    partners: int,
) -> np.ndarray:
    """One row (18,) of solids; `rotation` is (9,), row by row."""
    bound = {
        SPHERE: size[0],
        CAPSULE: size[0] + size[1],
        CYLINDER: np.hypot(size[0], size[1]),
        BOX: np.linalg.norm(size),
    }[kind]
    return np.concatenate([[kind, bound, partners], centre, rotation, size])
