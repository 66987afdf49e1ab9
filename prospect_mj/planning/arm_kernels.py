"""Compiled geometry of one arm: forward kinematics and clearances.

Frames (8, 12) are those of the base and of what follows each joint; a row is a position
[m], then a rotation matrix row by row. Solids (n, 18) are rows of: MuJoCo's type of
geom, radius of a sphere round it [m], the links that it concerns (bits), centre [m],
rotation matrix row by row, size [m]. An arm is an `arm_body.Arrays`.
"""

import numpy as np
from numba import njit

COLUMNS = 18
SPHERE, CAPSULE, CYLINDER, BOX = 2, 3, 5, 6
"""As MuJoCo numbers them."""

UPPER_ARM, FOREARM, HAND, JAR = 0, 1, 2, 3
"""What moves as one: WAM's link 3; its links 4 to 6 as far as they lie on the wrist's
axis, so that the wrist does not move them; link 7 with the hand; a held jar."""
FRAME_OF = (3, 4, 7, 7)
"""Number of joints before each of them."""
FOLDED = 2.0
"""Elbow angle below which hand and jar are clear of the own upper arm [rad]."""
FOLDED_CLEARANCE = 0.04
"""By how much at least [m]."""


@njit(cache=True, error_model="numpy")
def distance(x, y, z, rows, i):  # noqa: ANN001, ANN201
    """Signed distance of a point to solid `i` [m], negative inside."""
    dx, dy, dz = x - rows[i, 3], y - rows[i, 4], z - rows[i, 5]
    square = dx * dx + dy * dy + dz * dz
    kind = int(rows[i, 0])
    if kind == SPHERE:
        return np.sqrt(square) - rows[i, 15]
    along = dx * rows[i, 8] + dy * rows[i, 11] + dz * rows[i, 14]
    across = np.sqrt(max(square - along * along, 0.0))
    if kind == CAPSULE:
        beyond = max(abs(along) - rows[i, 16], 0.0)
        return np.sqrt(across * across + beyond * beyond) - rows[i, 15]
    if kind == CYLINDER:
        return _beyond(across - rows[i, 15], abs(along) - rows[i, 16], -np.inf)
    a = abs(dx * rows[i, 6] + dy * rows[i, 9] + dz * rows[i, 12]) - rows[i, 15]
    b = abs(dx * rows[i, 7] + dy * rows[i, 10] + dz * rows[i, 13]) - rows[i, 16]
    return _beyond(a, b, abs(along) - rows[i, 17])


@njit(cache=True, error_model="numpy")
def _beyond(a, b, c):  # noqa: ANN001, ANN202
    """Distance from how far a point is beyond each of three pairs of faces [m]."""
    if max(a, b, c) <= 0.0:
        return max(a, b, c)
    a, b, c = max(a, 0.0), max(b, 0.0), max(c, 0.0)
    return np.sqrt(a * a + b * b + c * c)


@njit(cache=True, error_model="numpy", inline="always")
def advance(frames, joints, j, angle):  # noqa: ANN001, ANN201
    """Fill the frame behind joint `j` from the one before it (Rodrigues' formula)."""
    c, s = np.cos(angle), np.sin(angle)
    x, y, z = joints[j, 3], joints[j, 4], joints[j, 5]
    t = 1.0 - c
    r00, r01, r02 = c + t * x * x, t * x * y - s * z, t * x * z + s * y
    r10, r11, r12 = t * x * y + s * z, c + t * y * y, t * y * z - s * x
    r20, r21, r22 = t * x * z - s * y, t * y * z + s * x, c + t * z * z
    for row in range(3):
        k = 3 + 3 * row
        a, b, d = frames[j, k], frames[j, k + 1], frames[j, k + 2]
        frames[j + 1, row] = (
            frames[j, row] + a * joints[j, 0] + b * joints[j, 1] + d * joints[j, 2]
        )
        frames[j + 1, k] = a * r00 + b * r10 + d * r20
        frames[j + 1, k + 1] = a * r01 + b * r11 + d * r21
        frames[j + 1, k + 2] = a * r02 + b * r12 + d * r22


@njit(cache=True, error_model="numpy")
def link_frames(arm, angles):  # noqa: ANN001, ANN201
    """Frames (8, 12) at the first few, or all, joint angles (n,) [rad]."""
    frames = np.empty((8, 12))
    frames[0] = arm.base
    for j in range(angles.shape[0]):
        advance(frames, arm.joints, j, angles[j])
    return frames


@njit(cache=True, error_model="numpy")
def upper_arm_solids(arm, frames):  # noqa: ANN001, ANN201
    """The own upper arm where it is, as solids (n, 18)."""
    rows = arm.upper_solids.copy()
    for i in range(rows.shape[0]):
        x, y, z = point(frames, FRAME_OF[UPPER_ARM], arm.upper_solids[:, 3:6], i)
        rows[i, 3], rows[i, 4], rows[i, 5] = x, y, z
        for row in range(3):
            for column in range(3):
                rows[i, 6 + 3 * row + column] = 0.0
                for k in range(3):
                    turn = frames[FRAME_OF[UPPER_ARM], 3 + 3 * row + k]
                    own = arm.upper_solids[i, 6 + 3 * k + column]
                    rows[i, 6 + 3 * row + column] += turn * own
    return rows


# Of several signatures: not cached, see `kernel_cache`.
@njit(error_model="numpy")
def point(frames, at, local, k):  # noqa: ANN001, ANN201
    """Row `k` of points in a frame, in the world (3,)."""
    a, b, c = local[k, 0], local[k, 1], local[k, 2]
    return (
        frames[at, 0] + frames[at, 3] * a + frames[at, 4] * b + frames[at, 5] * c,
        frames[at, 1] + frames[at, 6] * a + frames[at, 7] * b + frames[at, 8] * c,
        frames[at, 2] + frames[at, 9] * a + frames[at, 10] * b + frames[at, 11] * c,
    )


# Of several signatures: not cached, see `kernel_cache`.
@njit(error_model="numpy")
def link_clearance(spheres, link, frames, rows, ceiling):  # noqa: ANN001, ANN201
    """Least distance of a link to the solids that concern it [m], or the ceiling.

    Args:
        spheres: the link's cover, a sphere round all of it first (m, 4) [m].
        link: its number.
        frames: of the arm (8, 12).
        rows: solids (n, 18).
        ceiling: larger distances are not told apart [m].
    """
    least = ceiling
    at = FRAME_OF[link]
    radius = spheres[0, 3]
    x, y, z = point(frames, at, spheres, 0)
    for i in range(rows.shape[0]):
        dx, dy, dz = x - rows[i, 3], y - rows[i, 4], z - rows[i, 5]
        reach = radius + rows[i, 1] + least
        if dx * dx + dy * dy + dz * dz > reach * reach:
            continue
        if not (int(rows[i, 2]) >> link) & 1:
            continue
        if distance(x, y, z, rows, i) - radius > least:
            continue
        for k in range(1, spheres.shape[0]):
            px, py, pz = point(frames, at, spheres, k)
            least = min(least, distance(px, py, pz, rows, i) - spheres[k, 3])
    return least


@njit(cache=True, error_model="numpy")
def hand_clearance(hand, jar, frames, rows, ceiling):  # noqa: ANN001, ANN201
    """The same for the hand and what it holds."""
    least = link_clearance(hand, HAND, frames, rows, ceiling)
    if jar.shape[0] == 0:
        return least
    return link_clearance(jar, JAR, frames, rows, least)


@njit(cache=True, error_model="numpy")
def clearances(arm, configurations, rows, ceiling):  # noqa: ANN001, ANN201
    """Least distances of an arm to solids, and of its hand to its own upper arm.

    Args:
        arm: its geometry.
        configurations: joint angles (n, 7) [rad].
        rows: solids (m, 18).
        ceiling: larger distances are not told apart [m].

    Returns:
        Clearance of each configuration (n,) [m].
    """
    found = np.empty(configurations.shape[0])
    for i in range(configurations.shape[0]):
        frames = link_frames(arm, configurations[i])
        least = link_clearance(arm.upper_arm, UPPER_ARM, frames, rows, ceiling)
        least = link_clearance(arm.forearm, FOREARM, frames, rows, least)
        least = hand_clearance(arm.hand, arm.jar, frames, rows, least)
        found[i] = hand_clearance(
            arm.hand, arm.jar, frames, upper_arm_solids(arm, frames), least
        )
    return found
