"""Poses of hands and jar that the actions aim for; pure geometry."""

import mink
import numpy as np

from prospect_mj.robot import names
from prospect_mj.robot.names import Side


def turned_to(rotation: mink.SO3, direction: np.ndarray) -> mink.SO3:
    """The rotation nearest to `rotation` whose z axis is the unit `direction` (3,)."""
    z = rotation.as_matrix()[:, 2]
    axis = np.cross(z, direction)
    sine, cosine = float(np.linalg.norm(axis)), float(z @ direction)
    if sine < 1e-9:
        # Parallel: nothing to turn. Opposite: any perpendicular axis will do.
        axis = np.zeros(3) if cosine > 0 else np.pi * rotation.as_matrix()[:, 0]
        return mink.SO3.exp(axis) @ rotation
    return mink.SO3.exp(axis / sine * np.arctan2(sine, cosine)) @ rotation


def pose(rotation: mink.SO3, position: np.ndarray) -> mink.SE3:
    """Pose with this rotation and position (3,) [m]."""
    return mink.SE3.from_rotation_and_translation(rotation, position)


def lying(position: np.ndarray, axis: np.ndarray) -> mink.SE3:
    """Pose of a jar at `position` (3,) [m] with its axis along a unit vector (3,)."""
    return pose(turned_to(mink.SO3.identity(), axis), position)


def backed_off(hand: mink.SE3, distance: float) -> mink.SE3:
    """A hand's pose `distance` [m] back along its own palm axis."""
    palm_axis = hand.rotation().as_matrix()[:, 2]
    return pose(hand.rotation(), hand.translation() - distance * palm_axis)


def raised(hand: mink.SE3, height: float) -> mink.SE3:
    """A hand's pose `height` [m] higher."""
    return pose(hand.rotation(), hand.translation() + [0, 0, height])


def end_of_jar(
    side: Side, position: np.ndarray, axis: np.ndarray, reach: float
) -> tuple[np.ndarray, np.ndarray]:
    """Where a hand grips a jar, and along which direction its palm then points.

    Args:
        side: the hand; left takes the end to which `axis` points.
        position: the jar's centre (3,) [m].
        axis: of the jar (3,), pointing left.
        reach: centre to grip plane along the axis [m].

    Returns:
        The point on the axis (3,) [m] and the palm direction (3,).
    """
    outward = names.sign(side) * axis
    return position + reach * outward, -outward


def jar_over(
    side: Side, hand: mink.SE3, held: mink.SE3, centre: np.ndarray, up: np.ndarray
) -> mink.SE3:
    """Hand pose that brings a held jar somewhere with its gripped end along `up`.

    Args:
        side: the hand that holds it.
        hand: its pose now; the turn about the jar's axis follows it.
        held: the jar in the hand's frame.
        centre: where the jar's centre goes (3,) [m].
        up: unit direction (3,) in which its gripped end points.
    """
    now = (hand @ held).rotation()
    jar = pose(turned_to(now, names.sign(side) * up), centre)
    return jar @ held.inverse()
