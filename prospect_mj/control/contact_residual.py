"""Force and moment residuals of a grasp, from contact positions and normals.

After Coelho & Grupen (1997): unit frictionless forces along the inward contact normals
n_i at positions x_i have the net wrench

    rho_f = sum_i n_i,        rho_m = sum_i (x_i - c) x n_i / l

with c the centroid of the contacts and l a characteristic length. Both vanish exactly
if these forces balance; then any friction closes the grasp. The residual is
eps = |rho_f|^2 + |rho_m|^2.
"""

from dataclasses import dataclass

import numpy as np

CHARACTERISTIC_LENGTH = 0.04
"""Makes moments comparable with forces: about the object's radius [m]."""


@dataclass(frozen=True)
class ContactResidual:
    """How far a set of contacts is from static balance."""

    force: np.ndarray
    """rho_f (3,) [1]."""
    moment: np.ndarray
    """rho_m (3,) [1]."""
    value: float
    """eps = |rho_f|^2 + |rho_m|^2 [1]."""


def contact_residual(positions: np.ndarray, normals: np.ndarray) -> ContactResidual:
    """Residual of contacts at `positions` (k, 3) [m] with inward `normals` (k, 3)."""
    force = normals.sum(axis=0)
    arms = (positions - positions.mean(axis=0)) / CHARACTERISTIC_LENGTH
    moment = np.cross(arms, normals).sum(axis=0)
    return ContactResidual(force, moment, float(force @ force + moment @ moment))


def meeting_point(positions: np.ndarray, normals: np.ndarray) -> np.ndarray:
    """The point (3,) [m] nearest to all contact normals' lines, in least squares."""
    across = np.eye(3) - normals[:, :, None] * normals[:, None, :]
    moments = np.einsum("kij,kj->i", across, positions)
    return np.linalg.lstsq(across.sum(axis=0), moments, rcond=None)[0]


def required_friction(positions: np.ndarray, normals: np.ndarray) -> float:
    """Friction coefficient that the contacts need to hold an object by squeezing.

    Three forces in equilibrium lie in a plane and meet in a point. With that point
    where the contact normals come nearest to meeting (least squares), a contact needs
    the tangent of the angle between its normal and its line to the point.

    Args:
        positions: of three contacts, (3, 3) [m].
        normals: inward units, (3, 3).

    Returns:
        The largest of the three tangents, and infinity if the forces would all have
        to pull to one side.
    """
    lines = meeting_point(positions, normals) - positions
    lines /= np.linalg.norm(lines, axis=1, keepdims=True)
    cosines = np.einsum("ki,ki->k", lines, normals)
    if (cosines <= 0).any() or not _balance(lines):
        return float("inf")
    sines = np.linalg.norm(np.cross(lines, normals), axis=1)
    return float((sines / cosines).max())


def _balance(lines: np.ndarray) -> bool:
    """Whether positive forces along three (nearly coplanar) lines can cancel.

    They can if going round the plane every next line is less than half a turn away.
    """
    normal = np.linalg.svd(lines)[2][2]
    turns = [np.cross(lines[i], lines[(i + 1) % 3]) @ normal for i in range(3)]
    return bool(np.all(np.array(turns) > 0) or np.all(np.array(turns) < 0))
