"""All joint angles with which an arm can hold its grasp site at a pose, in closed form.

Singh and Claassens, "An analytical solution for the inverse kinematics of a redundant
7DoF manipulator with link offsets" (IROS 2010), for the WAM. Shoulder (J1 to J3) and
wrist (J5 to J7) are spherical, so the distance between their centres alone decides the
elbow J4. What is left of the seven joints is the swivel: the angle of the elbow about
the line from shoulder to wrist. At swivel 0 this line, the elbow's plane and J1's axis
are in one plane. Elbow, shoulder and wrist have two branches each.

All is computed for the left arm; a pose of the right one is reflected in the sagittal
plane, and its joint angles are reflected back.
"""

from functools import cache
from typing import NamedTuple

import numpy as np
from scipy.spatial.transform import Rotation

from prospect_mj.robot import mounting, names, posture, wam
from prospect_mj.robot.names import Side

_REFLECTION = np.array([1.0, -1.0, 1.0])
_MIRROR = np.array(wam.MIRROR)
_LOW, _HIGH = np.array(wam.JOINT_LIMITS).T


class _Offset(NamedTuple):
    """The grasp site in the frame of the wrist centre, left arm."""

    position: np.ndarray
    rotation: np.ndarray


def solutions(
    side: Side,
    position: np.ndarray,
    rotation: np.ndarray,
    swivels: np.ndarray,
    margin: float = 0.0,
) -> np.ndarray:
    """Joint angles that bring an arm's grasp site to a pose.

    Args:
        side: which arm.
        position: of the grasp site in the world (3,) [m].
        rotation: of the grasp site in the world (3, 3).
        swivels: angles of the elbow about the line from shoulder to wrist (k,) [rad],
            for the right arm those of its reflection.
        margin: kept from every joint limit [rad].

    Returns:
        Joint angles (n, 7) [rad], n <= 8 k; none where the pose is out of reach.
    """
    return _all_solutions(side, position, rotation[None], swivels, margin)


def solutions_free_roll(
    side: Side,
    position: np.ndarray,
    rotation: np.ndarray,
    swivels: np.ndarray,
    rolls: np.ndarray,
    margin: float = 0.0,
) -> np.ndarray:
    """The same, for a hand that may also turn about the palm's axis.

    Args:
        side: which arm.
        position: of the grasp site in the world (3,) [m].
        rotation: of the grasp site in the world at roll 0 (3, 3).
        swivels: as in `solutions` (k,) [rad].
        rolls: turns about the site's z axis (m,) [rad].
        margin: kept from every joint limit [rad].

    Returns:
        Joint angles (n, 7) [rad], n <= 8 k m.
    """
    turned = rotation @ _about("z", rolls)
    return _all_solutions(side, position, turned, swivels, margin)


def swivel(side: Side, joints: np.ndarray) -> float:
    """Swivel [rad] of joint angles (7,) [rad], in (-pi, pi]."""
    q = _reflected(side, joints)
    upper = _about("z", q[0]) @ _about("y", q[1]) @ _about("z", q[2])
    wrist = upper @ _wrist_in_upper_arm(q[3])
    turn = _frame(wrist, _unswivelled_normal(wrist)).T @ upper[:, 1]
    return float(np.arctan2(turn[2], turn[1]))


def _all_solutions(
    side: Side,
    position: np.ndarray,
    rotations: np.ndarray,
    swivels: np.ndarray,
    margin: float,
) -> np.ndarray:
    """Solutions (n, 7) of the poses `position` (3,), `rotations` (m, 3, 3)."""
    centre, hand = _wrist_in_base(side, position, rotations)
    elbow, reached = _elbow(np.linalg.norm(centre, axis=-1))
    if not reached.any():
        return np.empty((0, wam.N_JOINTS))
    upper = _upper_arm(centre[reached], elbow, swivels)
    forearm = upper @ _about("y", elbow)[:, :, None]
    wrist = np.swapaxes(forearm, -1, -2) @ hand[reached][:, None, None]
    angles = _combined(_zyz(upper), elbow, _zyz(wrist))
    return _reflected(side, _within_limits(angles, margin))


def _wrist_in_base(
    side: Side, position: np.ndarray, rotations: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Wrist centre (m, 3) [m] and rotation of the flange (m, 3, 3), left base frame."""
    if names.sign(side) < 0:
        position = _REFLECTION * position
        rotations = _REFLECTION[:, None] * rotations * _REFLECTION
    site = _grasp_site()
    base = mounting.shoulder_rotation("left").as_matrix()
    hand = base.T @ rotations @ site.rotation.T
    origin = base.T @ (position - mounting.shoulder_position("left"))
    return origin - hand @ site.position, hand


@cache
def _grasp_site() -> _Offset:
    origin, lean = posture.grasp_frame()
    return _Offset(origin + [0.0, 0.0, wam.WRIST_TO_FLANGE], _about("y", lean))


def _elbow(distance: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Elbow angles (r, 2) [rad] of both branches, and which (m,) of m are in reach.

    With the wrist at `_wrist_in_upper_arm(q4)`, |wrist|^2 = 2 a^2 + d3^2 + d5^2
    + 2 [(d3 d5 - a^2) cos q4 + a (d3 + d5) sin q4].
    """
    a, d3, d5 = wam.ELBOW_OFFSET, wam.UPPER_ARM, wam.FOREARM
    along, across = d3 * d5 - a**2, a * (d3 + d5)
    cosine = (distance**2 - 2 * a**2 - d3**2 - d5**2) / (2 * np.hypot(along, across))
    reached = np.abs(cosine) <= 1.0
    bend = np.arccos(cosine[reached])
    middle = np.arctan2(across, along)
    return np.stack([middle + bend, middle - bend], axis=-1), reached


def _wrist_in_upper_arm(elbow: np.ndarray | float) -> np.ndarray:
    """Wrist centre (..., 3) [m] in the frame of the upper arm, which starts at J3."""
    to_elbow = np.array([wam.ELBOW_OFFSET, 0.0, wam.UPPER_ARM])
    beyond = np.array([-wam.ELBOW_OFFSET, 0.0, wam.FOREARM])
    return to_elbow + _about("y", elbow) @ beyond


def _upper_arm(
    centre: np.ndarray, elbow: np.ndarray, swivels: np.ndarray
) -> np.ndarray:
    """Rotations (r, 2, k, 3, 3) of the upper arm that put the wrist at `centre`."""
    # The normal of the elbow's plane is J4's axis.
    seen_from_arm = _frame(_wrist_in_upper_arm(elbow), np.array([0.0, 1.0, 0.0]))
    seen_from_base = _frame(centre, _unswivelled_normal(centre))
    turned = seen_from_base[:, None, None] @ _about("x", swivels)
    return turned @ np.swapaxes(seen_from_arm, -1, -2)[:, :, None]


def _unswivelled_normal(wrist: np.ndarray) -> np.ndarray:
    """Normal (..., 3) of the plane of J1's axis and the wrist (..., 3) [m]."""
    normal = np.cross([0.0, 0.0, 1.0], wrist)
    length = np.linalg.norm(normal, axis=-1, keepdims=True)
    on_axis = length < 1e-9
    return np.where(on_axis, [0.0, 1.0, 0.0], normal / np.where(on_axis, 1.0, length))


def _frame(wrist: np.ndarray, normal: np.ndarray) -> np.ndarray:
    """Frame (..., 3, 3): x towards the wrist (..., 3), y along a normal to it."""
    x = wrist / np.linalg.norm(wrist, axis=-1, keepdims=True)
    y = np.broadcast_to(normal, x.shape)
    return np.stack([x, y, np.cross(x, y)], axis=-1)


def _zyz(rotation: np.ndarray) -> np.ndarray:
    """Both triples (..., 2, 3) [rad] with Rz Ry Rz = rotation (..., 3, 3).

    scipy's `as_euler` knows one of them, and none where first and third coincide.
    """
    first = np.arctan2(rotation[..., 1, 2], rotation[..., 0, 2])
    c, s = np.cos(first), np.sin(first)
    x = c[..., None] * rotation[..., 0, :] + s[..., None] * rotation[..., 1, :]
    y = c[..., None] * rotation[..., 1, :] - s[..., None] * rotation[..., 0, :]
    second = np.arctan2(x[..., 2], rotation[..., 2, 2])
    # From the turned y axis, which is good even where first and third coincide.
    third = np.arctan2(y[..., 0], y[..., 1])
    one = np.stack([first, second, third], axis=-1)
    other = np.stack([first + np.pi, -second, third + np.pi], axis=-1)
    return np.stack([one, other], axis=-2)


def _combined(shoulder: np.ndarray, elbow: np.ndarray, wrist: np.ndarray) -> np.ndarray:
    """All branches (n, 7): shoulder and wrist (r, 2, k, 2, 3), elbow (r, 2) [rad]."""
    shape = (*shoulder.shape[:-1], wrist.shape[-2])
    angles = np.empty((*shape, wam.N_JOINTS))
    angles[..., :3] = shoulder[..., :, None, :]
    angles[..., 3] = elbow[:, :, None, None, None]
    angles[..., 4:] = wrist[..., None, :, :]
    return angles.reshape(-1, wam.N_JOINTS)


def _within_limits(angles: np.ndarray, margin: float) -> np.ndarray:
    """Those (n, 7) [rad] of the left arm that whole turns bring within the limits."""
    wrapped = _LOW + np.mod(angles - _LOW, 2 * np.pi)
    inside = (wrapped >= _LOW + margin) & (wrapped <= _HIGH - margin)
    return wrapped[inside.all(axis=-1)]


def _reflected(side: Side, angles: np.ndarray) -> np.ndarray:
    return angles if names.sign(side) > 0 else _MIRROR * angles


def _about(axis: str, angle: np.ndarray | float) -> np.ndarray:
    """Rotation matrices (..., 3, 3) by angles (...) [rad] about a coordinate axis."""
    flat = Rotation.from_euler(axis, np.reshape(angle, (-1, 1))).as_matrix()
    return flat.reshape(*np.shape(angle), 3, 3)
