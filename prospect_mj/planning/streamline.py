"""Streamlines of a harmonic function: the way that a configuration takes to a goal."""

from dataclasses import dataclass

import numpy as np

from prospect_mj.errors import InvalidValue
from prospect_mj.planning.ascent import follow
from prospect_mj.planning.harmonic_field import HarmonicField

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
