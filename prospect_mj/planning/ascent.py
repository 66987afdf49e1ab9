"""Compiled: how a configuration climbs a harmonic function.

u is interpolated between the centres of cells (multilinear), scaled by its largest
value near by, which leaves the gradient's direction and takes away its underflow. A
step that this direction would take past the corner of a wall goes to the highest
neighbouring cell instead. By the maximum principle that cell's value is higher than the
own one, and the straight way to its centre lies in the two cells.
"""

import numpy as np
from numba import njit

from prospect_mj.planning.harmonic_field import FieldArrays

# Half a central difference, in cells.
_HALF = 0.5


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
    best = field.log_u[_cell(field, points[0])]
    if best == -np.inf:
        return 1, False
    waited = 0
    for i in range(points.shape[0]):
        value = field.log_u[_cell(field, points[i])]
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


@njit(cache=True, error_model="numpy")
def ascend(
    field: FieldArrays,
    joints: np.ndarray,
    step: float,
    by_cells: bool,
    ascent: np.ndarray,
) -> None:
    """Fill `ascent` (n_joints,) with the direction of the next step from `joints`.

    Args:
        field: the harmonic function.
        joints: joint angles (n_joints,) [rad].
        step: its length [rad].
        by_cells: go to the centre of the highest neighbour, whatever the gradient is.
        ascent: where the unit vector goes; zeros if there is none.
    """
    _gradient(field, joints, ascent)
    if not by_cells and _normalise(ascent):
        own = field.log_u[_cell(field, joints)]
        if own == -np.inf or _is_clear(field, joints, step, ascent):
            return
    _to_highest(field, joints, ascent)


@njit(cache=True, error_model="numpy")
def _index(field: FieldArrays, joints: np.ndarray, axis: int) -> int:
    """Index of the nearest cell along one joint, where 0 is the border."""
    x = (joints[axis] - field.low[axis]) / field.spacing[axis]
    return int(min(max(np.floor(x), 0.0), field.cells[axis] - 1.0)) + 1


@njit(cache=True, error_model="numpy")
def _cell(field: FieldArrays, joints: np.ndarray) -> int:
    """Where the nearest cell's value lies."""
    cell = 0
    for axis in range(joints.size):
        cell += _index(field, joints, axis) * field.strides[axis]
    return cell


@njit(cache=True, error_model="numpy")
def _gradient(field: FieldArrays, joints: np.ndarray, gradient: np.ndarray) -> None:
    """Central differences over one cell of interpolated u, up to a common factor."""
    n = joints.size
    corners = np.empty((n, 2, 2**n))
    weights = np.empty((n, 2, 2**n))
    x = np.empty(n)
    for axis in range(n):
        # The centre of the border's cell has coordinate 0.
        x[axis] = (joints[axis] - field.low[axis]) / field.spacing[axis] + 0.5
        x[axis] = min(max(x[axis], _HALF), field.cells[axis] + 1.0 - _HALF)
    for axis in range(n):
        for side in range(2):
            centre = x[axis]
            x[axis] += _HALF * (2 * side - 1)
            _corners(field, x, corners[axis, side], weights[axis, side])
            x[axis] = centre
    top = -np.inf
    for corner in corners.flat:
        top = max(top, corner)
    for axis in range(n):
        gradient[axis] = 0.0
        if top == -np.inf:
            continue
        for k in range(2**n):
            high = weights[axis, 1, k] * np.exp(corners[axis, 1, k] - top)
            low = weights[axis, 0, k] * np.exp(corners[axis, 0, k] - top)
            gradient[axis] += (high - low) / field.spacing[axis]


@njit(cache=True, error_model="numpy")
def _corners(
    field: FieldArrays, x: np.ndarray, log_u: np.ndarray, weights: np.ndarray
) -> None:
    """The 2^n centres around a point, and their multilinear weights."""
    for k in range(log_u.size):
        cell = 0
        weight = 1.0
        for axis in range(x.size):
            below = min(int(x[axis]), field.cells[axis])
            upper = (k >> axis) & 1
            share = x[axis] - below
            weight *= share if upper else 1.0 - share
            cell += (below + upper) * field.strides[axis]
        log_u[k] = field.log_u[cell] if weight > 0.0 else -np.inf
        weights[k] = weight


@njit(cache=True, error_model="numpy")
def _is_clear(
    field: FieldArrays, joints: np.ndarray, step: float, ascent: np.ndarray
) -> bool:
    """Whether all cells of the smallest box around a step are connected."""
    first = _cell(field, joints)
    moved = np.zeros(joints.size, np.int64)
    n_moved = 0
    for axis in range(joints.size):
        before = (joints[axis] - field.low[axis]) / field.spacing[axis]
        after = before + step * ascent[axis] / field.spacing[axis]
        if not 0.0 <= after <= field.cells[axis]:
            return False
        change = int(np.floor(after)) - int(np.floor(before))
        if change:
            moved[n_moved] = change * field.strides[axis]
            n_moved += 1
    for k in range(1, 2**n_moved):
        cell = first
        for j in range(n_moved):
            cell += moved[j] * ((k >> j) & 1)
        if field.log_u[cell] == -np.inf:
            return False
    return True


@njit(cache=True, error_model="numpy")
def _to_highest(field: FieldArrays, joints: np.ndarray, ascent: np.ndarray) -> None:
    """Direction to the centre of the highest neighbouring cell; zeros if none is."""
    own = _cell(field, joints)
    best = field.log_u[own]
    along = -1
    sign = 0
    for axis in range(joints.size):
        for turn in (-1, 1):
            value = field.log_u[own + turn * field.strides[axis]]
            if value > best:
                best, along, sign = value, axis, turn
    for axis in range(joints.size):
        ascent[axis] = 0.0
        if along < 0:
            continue
        index = _index(field, joints, axis) + (sign if axis == along else 0)
        centre = field.low[axis] + (index - 0.5) * field.spacing[axis]
        ascent[axis] = centre - joints[axis]
    _normalise(ascent)


@njit(cache=True, error_model="numpy")
def _normalise(vector: np.ndarray) -> bool:
    """Scale a vector to length 1; whether it has a length."""
    square = 0.0
    for component in vector:
        square += component * component
    if square > 0.0:
        for axis in range(vector.size):
            vector[axis] /= np.sqrt(square)
    return square > 0.0
