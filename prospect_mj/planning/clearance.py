"""How near an arm is to the solids around it, at one configuration or at many."""

from typing import NamedTuple

import numpy as np
from numba import njit

from prospect_mj.planning.arm_body import FOREARM, HAND, N_LINKS, UPPER_ARM, ArmBody
from prospect_mj.planning.kinematics import FRAME, advance, carry, link_frames
from prospect_mj.planning.solids import COLUMNS, distance


class Arrays(NamedTuple):
    """What the compiled code needs of an arm body."""

    base: np.ndarray
    joints: np.ndarray
    spheres: np.ndarray
    first: np.ndarray
    hulls: np.ndarray
    upper: np.ndarray


class Chart(NamedTuple):
    """Wrist angles (n, 3) [rad] known at gross joint angles (n, 4) [rad]."""

    gross: np.ndarray
    wrists: np.ndarray


def arrays(body: ArmBody) -> Arrays:
    """The arrays of an arm body."""
    return Arrays(
        body.base, body.joints, body.spheres, body.first, body.hulls, body.upper
    )


@njit(cache=True)
def link_clearance(arm, link, frame, rows, ceiling):  # noqa: ANN001, ANN201
    """Least distance of a link to the solids that concern it [m].

    Args:
        arm: `Arrays`.
        link: number of the link.
        frame: of the link (12,).
        rows: solids (n, 18).
        ceiling: larger distances are not told apart [m].
    """
    least = ceiling
    first, end = arm.first[link], arm.first[link + 1]
    radius = arm.hulls[link, 3]
    x, y, z = _point(frame, arm.hulls[link])
    for i in range(rows.shape[0]):
        dx, dy, dz = x - rows[i, 3], y - rows[i, 4], z - rows[i, 5]
        reach = radius + rows[i, 1] + least
        if dx * dx + dy * dy + dz * dz > reach * reach:
            continue
        if not (int(rows[i, 2]) >> link) & 1:
            continue
        if distance(x, y, z, rows, i) - radius > least:
            continue
        for k in range(first, end):
            px, py, pz = _point(frame, arm.spheres[k])
            gap = distance(px, py, pz, rows, i) - arm.spheres[k, 3]
            least = min(least, gap)
    return least


@njit(cache=True)
def _point(frame, local):  # noqa: ANN001, ANN202
    """A link's point (3,) in the world."""
    a, b, c = local[0], local[1], local[2]
    return (
        frame[0] + frame[3] * a + frame[4] * b + frame[5] * c,
        frame[1] + frame[6] * a + frame[7] * b + frame[8] * c,
        frame[2] + frame[9] * a + frame[10] * b + frame[11] * c,
    )


@njit(cache=True)
def clearance(arm, angles, rows, ceiling):  # noqa: ANN001, ANN201
    """Least distance of the whole arm to solids and to its own upper arm [m].

    Args:
        arm: `Arrays`.
        angles: joint angles (7,) [rad].
        rows: solids (n, 18).
        ceiling: larger distances are not told apart [m].
    """
    frames = link_frames(arm.base, arm.joints, angles)
    own = np.empty((arm.upper.shape[0], COLUMNS))
    carry(frames[2], arm.upper, own)
    least = link_clearance(arm, UPPER_ARM, frames[2], rows, ceiling)
    least = link_clearance(arm, FOREARM, frames[3], rows, least)
    for link in range(HAND, N_LINKS):
        if arm.first[link + 1] > arm.first[link]:
            least = link_clearance(arm, link, frames[6], rows, least)
            least = link_clearance(arm, link, frames[6], own, least)
    return least


@njit(cache=True)
def clearances(arm, configurations, rows, ceiling):  # noqa: ANN001, ANN201
    """`clearance` (n,) [m] of configurations (n, 7) [rad]."""
    found = np.empty(configurations.shape[0])
    for i in range(configurations.shape[0]):
        found[i] = clearance(arm, configurations[i], rows, ceiling)
    return found


@njit(cache=True)
def wrist_at(chart, gross, out):  # noqa: ANN001, ANN201
    """Wrist angles (3,) [rad] at gross joints (4,), between those that are known.

    Shepard's interpolation: the mean weighted by the inverse squared distance.
    """
    total = 0.0
    out[:] = 0.0
    for k in range(chart.gross.shape[0]):
        square = 1e-9
        for j in range(chart.gross.shape[1]):
            square += (chart.gross[k, j] - gross[j]) ** 2
        weight = 1.0 / square
        total += weight
        for j in range(3):
            out[j] += weight * chart.wrists[k, j]
    for j in range(3):
        out[j] /= total
