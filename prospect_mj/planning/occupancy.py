"""Which cells of the gross joints' space are free, for the arm's links and its hand."""

import numpy as np
from numba import njit

from prospect_mj.planning.arm_body import FOREARM, HAND, N_LINKS, UPPER_ARM
from prospect_mj.planning.clearance import link_clearance, wrist_at
from prospect_mj.planning.kinematics import FRAME, advance, carry
from prospect_mj.planning.solids import COLUMNS, distance

_FOLDED = 1.2
"""Elbow angle below which the hand can't reach its own upper arm [rad]."""


@njit(cache=True)
def room_among(arm, axes, rows, margin, most):  # noqa: ANN001, ANN201
    """Room that fixtures leave to the arm's wrist, wherever its links are clear.

    Args:
        arm: `Arrays`.
        axes: cell centres of the four gross joints, each (n_j,) [rad].
        rows: solids (n, 18).
        margin: that upper arm and forearm must keep [m].
        most: larger distances are not told apart [m].

    Returns:
        Distance of the wrist's centre to the nearest solid, for each cell
        (n_1, n_2, n_3, n_4) [m]; -1 where a link is not clear.
    """
    shape = (len(axes[0]), len(axes[1]), len(axes[2]), len(axes[3]))
    room = np.full(shape, -1.0)
    frames = np.empty((7, FRAME))
    for a in range(shape[0]):
        advance(arm.base, arm.joints[0], axes[0][a], frames[0])
        for b in range(shape[1]):
            advance(frames[0], arm.joints[1], axes[1][b], frames[1])
            for c in range(shape[2]):
                advance(frames[1], arm.joints[2], axes[2][c], frames[2])
                if link_clearance(arm, UPPER_ARM, frames[2], rows, margin) < margin:
                    continue
                for d in range(shape[3]):
                    advance(frames[2], arm.joints[3], axes[3][d], frames[3])
                    if link_clearance(arm, FOREARM, frames[3], rows, margin) < margin:
                        continue
                    room[a, b, c, d] = _wrist_distance(arm, frames[3], rows, most)
    return room


@njit(cache=True)
def _wrist_distance(arm, forearm, rows, ceiling):  # noqa: ANN001, ANN202
    """From the wrist's centre to the nearest solid [m]."""
    least = ceiling
    height = arm.joints[5, 2]
    x = forearm[0] + forearm[3] * arm.joints[4, 0] + forearm[5] * height
    y = forearm[1] + forearm[6] * arm.joints[4, 0] + forearm[8] * height
    z = forearm[2] + forearm[9] * arm.joints[4, 0] + forearm[11] * height
    for i in range(rows.shape[0]):
        dx, dy, dz = x - rows[i, 3], y - rows[i, 4], z - rows[i, 5]
        reach = rows[i, 1] + least
        if dx * dx + dy * dy + dz * dz < reach * reach:
            least = min(least, distance(x, y, z, rows, i))
    return least


@njit(cache=True)
def free_cells(arm, axes, fixed, moving, room, reach, chart, margin):  # noqa: ANN001, ANN201
    """Cells whose arm, hand and held jar keep a margin from everything.

    Args:
        arm: `Arrays`.
        axes: cell centres of the four gross joints, each (n_j,) [rad].
        fixed: solids that never move (n, 18).
        moving: those that do (m, 18).
        room: result of `room_among` the fixed solids.
        reach: of hand and jar from the wrist's centre [m].
        chart: tells the wrist at each cell.
        margin: [m].
    """
    free = room >= 0.0
    shape = room.shape
    frames = np.empty((7, FRAME))
    own = np.empty((arm.upper.shape[0], COLUMNS))
    gross, wrist = np.empty(4), np.empty(3)
    far = reach + margin
    for a in range(shape[0]):
        gross[0] = axes[0][a]
        advance(arm.base, arm.joints[0], gross[0], frames[0])
        for b in range(shape[1]):
            gross[1] = axes[1][b]
            advance(frames[0], arm.joints[1], gross[1], frames[1])
            for c in range(shape[2]):
                gross[2] = axes[2][c]
                advance(frames[1], arm.joints[2], gross[2], frames[2])
                if link_clearance(arm, UPPER_ARM, frames[2], moving, margin) < margin:
                    free[a, b, c] = False
                    continue
                carry(frames[2], arm.upper, own)
                for d in range(shape[3]):
                    if not free[a, b, c, d]:
                        continue
                    gross[3] = axes[3][d]
                    advance(frames[2], arm.joints[3], gross[3], frames[3])
                    if link_clearance(arm, FOREARM, frames[3], moving, margin) < margin:
                        free[a, b, c, d] = False
                        continue
                    tight = room[a, b, c, d] < far
                    near = _wrist_distance(arm, frames[3], moving, far) < far
                    folded = gross[3] > _FOLDED
                    if not (tight or near or folded):
                        continue
                    wrist_at(chart, gross, wrist)
                    for j in range(3):
                        advance(
                            frames[3 + j], arm.joints[4 + j], wrist[j], frames[4 + j]
                        )
                    free[a, b, c, d] = (
                        (not near or _hand_keeps(arm, frames[6], moving, margin))
                        and (not folded or _hand_keeps(arm, frames[6], own, margin))
                        and (not tight or _hand_keeps(arm, frames[6], fixed, margin))
                    )
    return free


@njit(cache=True)
def _hand_keeps(arm, frame, rows, margin):  # noqa: ANN001, ANN202
    for link in range(HAND, N_LINKS):
        if arm.first[link + 1] > arm.first[link]:
            if link_clearance(arm, link, frame, rows, margin) < margin:
                return False
    return True
