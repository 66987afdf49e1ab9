"""Streamlines of a harmonic function: the way that a configuration takes to a goal."""

from dataclasses import dataclass

import numpy as np
from numba import njit

from prospect_mj.errors import InvalidValue
from prospect_mj.planning.ascent import ascend, nearest_cell
from prospect_mj.planning.harmonic_field import FieldArrays, HarmonicField

# Largest step as a share of the narrowest cell.
_CELL_SHARE = 0.25
# Steps without a higher cell, as a share of those that cross a cell corner to corner.
_PATIENCE = 2.0


@dataclass(frozen=True)
class Streamline:
    """The way from a configuration up a harmonic function."""

    points: np.ndarray
    """Joint angles (m, n_joints) [rad], at equal arc lengths, the first where it began;
    all of them, and the segments between them, lie in connected cells."""
    reached: bool
    """Whether the last point lies in a goal cell."""


def direction(field: HarmonicField, joints: np.ndarray) -> np.ndarray:
    """Direction of steepest ascent of u at a configuration.

    Args:
        field: the harmonic function.
        joints: joint angles (n_joints,) [rad].

    Returns:
        Unit vector (n_joints,) [rad/rad]; zeros where neither the cell nor one that it
        shares a corner with is connected to a goal.
    """
    ascent = np.zeros(field.grid.n_joints)
    step = _CELL_SHARE * field.grid.spacing.min()
    ascend(field.arrays, _configuration(field, joints), step, False, ascent)
    return ascent


def streamline(
    field: HarmonicField, joints: np.ndarray, step: float, max_length: float
) -> Streamline:
    """Follow u upwards from a configuration to a goal cell.

    From a connected cell it always arrives, if `max_length` is enough and the field has
    converged; from another one it does not start.

    Args:
        field: the harmonic function.
        joints: joint angles (n_joints,) [rad].
        step: arc length between points [rad]; a quarter of the narrowest cell where
            that is less.
        max_length: arc length after which it is given up [rad].

    Raises:
        InvalidValue: for a step or a length that isn't positive.
    """
    for what, value in (("step", step), ("longest streamline", max_length)):
        if not value > 0:
            raise InvalidValue(f"{what} [rad]", value, "a positive number")
    spacing = field.grid.spacing
    step = min(step, _CELL_SHARE * spacing.min())
    points = np.empty((int(max_length / step) + 1, field.grid.n_joints))
    points[0] = _configuration(field, joints)
    patience = int(_PATIENCE * np.linalg.norm(spacing) / step) + 1
    count, reached = follow(field.arrays, step, patience, points)
    return Streamline(points[:count].copy(), reached)


def _configuration(field: HarmonicField, joints: np.ndarray) -> np.ndarray:
    """The joint angles (n_joints,) [rad], as compiled code trusts them to be."""
    joints = np.ascontiguousarray(joints, float)
    if joints.shape != (field.grid.n_joints,) or not np.isfinite(joints).all():
        expected = f"{field.grid.n_joints} finite angles"
        raise InvalidValue("configuration [rad]", joints.tolist(), expected)
    return joints


@njit(cache=True, error_model="numpy")
def follow(
    field: FieldArrays, step: float, patience: int, points: np.ndarray
) -> tuple[int, bool]:
    """Fill points (m, n_joints) [rad] from the first on.

    Where `patience` steps have brought no higher cell, it climbs from cell to cell
    until one is higher than all before. So each round ends in a higher cell, of which
    there are finitely many.

    Returns:
        Number of points, and whether the last one lies in a goal cell.
    """
    ascent = np.zeros(points.shape[1])
    best = field.log_u[nearest_cell(field, points[0])]
    if best == -np.inf:
        return 1, False
    waited = 0
    for i in range(points.shape[0]):
        value = field.log_u[nearest_cell(field, points[i])]
        if value == 0.0:
            return i + 1, True
        waited = 0 if value > best else waited + 1
        best = max(best, value)
        if i + 1 == points.shape[0]:
            break
        ascend(field, points[i], step, waited > patience, ascent)
        if not ascent.any():
            return i + 1, False
        points[i + 1] = points[i] + step * ascent
    return points.shape[0], False
