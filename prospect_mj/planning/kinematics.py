"""Forward kinematics of an arm body, compiled.

A frame is a row of twelve numbers: position [m], then a rotation matrix row by row.
"""

import numpy as np
from numba import njit

FRAME = 12


@njit(cache=True)
def advance(parent: np.ndarray, joint: np.ndarray, angle: float, out: np.ndarray):  # noqa: ANN201
    """Frame of the link behind a joint.

    Args:
        parent: frame of the link before it (12,).
        joint: its place in that link and its axis (6,).
        angle: of the joint [rad].
        out: takes the frame (12,).
    """
    c, s = np.cos(angle), np.sin(angle)
    x, y, z = joint[3], joint[4], joint[5]
    t = 1.0 - c
    r00, r01, r02 = c + t * x * x, t * x * y - s * z, t * x * z + s * y
    r10, r11, r12 = t * x * y + s * z, c + t * y * y, t * y * z - s * x
    r20, r21, r22 = t * x * z - s * y, t * y * z + s * x, c + t * z * z
    for row in range(3):
        a, b, d = parent[3 + 3 * row], parent[4 + 3 * row], parent[5 + 3 * row]
        out[row] = parent[row] + a * joint[0] + b * joint[1] + d * joint[2]
        out[3 + 3 * row] = a * r00 + b * r10 + d * r20
        out[4 + 3 * row] = a * r01 + b * r11 + d * r21
        out[5 + 3 * row] = a * r02 + b * r12 + d * r22


@njit(cache=True)
def link_frames(base: np.ndarray, joints: np.ndarray, angles: np.ndarray) -> np.ndarray:
    """Frames of all links (7, 12) at joint angles (7,) [rad]."""
    frames = np.empty((joints.shape[0], FRAME))
    advance(base, joints[0], angles[0], frames[0])
    for j in range(1, joints.shape[0]):
        advance(frames[j - 1], joints[j], angles[j], frames[j])
    return frames


@njit(cache=True)
def carry(frame: np.ndarray, local: np.ndarray, out: np.ndarray):  # noqa: ANN201
    """Solids (n, 18) of a link's frame, put where the frame (12,) is."""
    for i in range(local.shape[0]):
        out[i, :3] = local[i, :3]
        out[i, 15:] = local[i, 15:]
        for row in range(3):
            a, b, c = frame[3 + 3 * row], frame[4 + 3 * row], frame[5 + 3 * row]
            out[i, 3 + row] = (
                frame[row] + a * local[i, 3] + b * local[i, 4] + c * local[i, 5]
            )
            for column in range(3):
                out[i, 6 + 3 * row + column] = (
                    a * local[i, 6 + column]
                    + b * local[i, 9 + column]
                    + c * local[i, 12 + column]
                )
