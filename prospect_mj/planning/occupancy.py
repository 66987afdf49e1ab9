"""Compiled maps of an arm's gross joints: which cells are free."""

import numpy as np
from numba import njit

from prospect_mj.planning.arm_kernels import (
    FOLDED,
    FOREARM,
    FRAME_OF,
    UPPER_ARM,
    advance,
    distance,
    hand_clearance,
    link_clearance,
    link_frames,
    point,
    upper_arm_solids,
)


@njit(cache=True, error_model="numpy")
def _wrist_room(wrist, frames, rows, ceiling):  # noqa: ANN001, ANN202
    """Distance of the wrist's centre to the nearest solid [m], or the ceiling."""
    x, y, z = point(frames, FRAME_OF[FOREARM], wrist, 0)
    least = ceiling
    for i in range(rows.shape[0]):
        dx, dy, dz = x - rows[i, 3], y - rows[i, 4], z - rows[i, 5]
        reach = rows[i, 1] + least
        if dx * dx + dy * dy + dz * dz < reach * reach:
            least = min(least, distance(x, y, z, rows, i))
    return least


@njit(cache=True, error_model="numpy")
def room_among(arm, shoulders, elbows, rows, margin, most):  # noqa: ANN001, ANN201
    """Room that solids leave to the wrist, wherever upper arm and forearm are clear.

    Args:
        arm: its geometry.
        shoulders: angles of joints 1 to 3 (m, 3) [rad].
        elbows: angles of joint 4 (n,) [rad].
        rows: solids (k, 18).
        margin: that upper arm and forearm must keep [m].
        most: larger distances are not told apart [m].

    Returns:
        Distance of the wrist's centre to the nearest solid (m, n) [m]; -1 where upper
        arm or forearm is not clear.
    """
    room = np.full((shoulders.shape[0], elbows.shape[0]), -1.0)
    for i in range(shoulders.shape[0]):
        frames = link_frames(arm, shoulders[i])
        if link_clearance(arm.upper_arm, UPPER_ARM, frames, rows, margin) < margin:
            continue
        for k in range(elbows.shape[0]):
            advance(frames, arm.joints, 3, elbows[k])
            if link_clearance(arm.forearm, FOREARM, frames, rows, margin) >= margin:
                room[i, k] = _wrist_room(arm.wrist, frames, rows, most)
    return room


# Of several signatures: not cached, see `kernel_cache`.
@njit(error_model="numpy")
def wrist_at(chart, gross, k, out):  # noqa: ANN001, ANN201
    """Wrist (3,) [rad] at shoulder and elbow: row `k` of `gross` (n, 4) [rad].

    Shepard's interpolation: the mean of what the chart knows, weighted by the inverse
    squared distance.
    """
    total = 0.0
    out[:] = 0.0
    for i in range(chart.gross.shape[0]):
        square = 1e-9
        for j in range(4):
            square += (chart.gross[i, j] - gross[k, j]) ** 2
        total += 1.0 / square
        for j in range(3):
            out[j] += chart.wrists[i, j] / square
    for j in range(3):
        out[j] /= total


@njit(cache=True, error_model="numpy")
def free_cells(arm, shoulders, elbows, fixed, moving, room, chart, reach, margin):  # noqa: ANN001, ANN201
    """Cells whose arm, hand and held jar keep a margin from everything.

    Args:
        arm: its geometry.
        shoulders: angles of joints 1 to 3 (m, 3) [rad].
        elbows: angles of joint 4 (n,) [rad].
        fixed: solids that never move (k, 18).
        moving: those that do (l, 18).
        room: result of `room_among` the fixed ones (m, n) [m].
        chart: tells the wrist at each cell.
        reach: of hand and jar from the wrist's centre [m].
        margin: [m].

    Returns:
        Whether a cell is free (m, n).
    """
    free = room >= 0.0
    gross, far = np.empty((1, 4)), reach + margin
    for i in range(shoulders.shape[0]):
        frames = link_frames(arm, shoulders[i])
        if link_clearance(arm.upper_arm, UPPER_ARM, frames, moving, margin) < margin:
            free[i] = False
            continue
        here = free[i]
        gross[0, :3] = shoulders[i]
        _close(
            arm, frames, gross, elbows, fixed, moving, room[i], chart, far, margin, here
        )
    return free


# As a call of its own it would take a fifth longer.
@njit(cache=True, error_model="numpy", inline="always")
def _close(arm, frames, gross, elbows, fixed, moving, room, chart, far, margin, free):  # noqa: ANN001, ANN202
    """Take from one shoulder's free cells (n,) those where forearm or hand is not."""
    # Handing over the whole arm each time would cost more than what is done with it.
    joints, forearm, hand, jar = arm.joints, arm.forearm, arm.hand, arm.jar
    own, wrist = upper_arm_solids(arm, frames), np.empty(3)
    for k in range(elbows.shape[0]):
        if not free[k]:
            continue
        advance(frames, joints, 3, elbows[k])
        if link_clearance(forearm, FOREARM, frames, moving, margin) < margin:
            free[k] = False
            continue
        tight = room[k] < far
        near = _wrist_room(arm.wrist, frames, moving, far) < far
        folded = elbows[k] > FOLDED
        # Where the hand can't reach anything, its place need not be known.
        if tight or near or folded:
            gross[0, 3] = elbows[k]
            wrist_at(chart, gross, 0, wrist)
            for j in range(3):
                advance(frames, joints, 4 + j, wrist[j])
            free[k] = (
                (not near or _keeps(hand, jar, frames, moving, margin))
                and (not folded or _keeps(hand, jar, frames, own, margin))
                and (not tight or _keeps(hand, jar, frames, fixed, margin))
            )


@njit(cache=True, error_model="numpy")
def _keeps(hand, jar, frames, rows, margin):  # noqa: ANN001, ANN202
    """Whether the hand and what it holds keep a margin from solids."""
    return hand_clearance(hand, jar, frames, rows, margin) >= margin
