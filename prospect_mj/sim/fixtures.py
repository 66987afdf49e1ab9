"""What stands around the torso, added to empty models that the scene then attaches."""

from typing import Any

import mujoco
import numpy as np
from numpy.typing import ArrayLike

from prospect_mj.sim.props import Jar, Lamp, Obstacle, Pedestal, Recess, Table, Well

Element = Any
"""An MJCF element of PyMJCF, which only the scene imports."""

SLOPE = np.pi / 4
"""Of the cradle's plates and of the well's chamfer [rad]."""
_BRASS = (0.75, 0.62, 0.25, 1)
_CHAMFER_THICKNESS = 0.002
"""Half thickness of the sloping plates [m]."""
_FACETS = 12
"""Plates round a recess."""
_RECESS_THICKNESS = 0.002
"""Half thickness of these [m]."""

# A cylinder has no hole in MuJoCo. So the lid with a recess does not touch the post,
# but for the plates that line its recess, which touch nothing else.
_HOLLOW = {"contype": 4, "conaffinity": 1}
_POST = {"contype": 2, "conaffinity": 3}
_LINING = {"contype": 2, "conaffinity": 0}
_SOLID = {"contype": 1, "conaffinity": 3}
"""Of a jar's body: it meets the post like everything else."""


def build_table(root: Element, table: Table) -> None:
    """A table and the floor that it stands on."""
    rgba = [*table.colour, 1]
    root.worldbody.add(
        "geom",
        name="top",
        type="box",
        pos=[*table.centre, -0.02],
        size=[*table.half_size, 0.02],
        rgba=rgba,
    )
    root.worldbody.add(
        "geom",
        name="floor",
        type="plane",
        pos=[0, 0, -0.75],
        size=[4, 4, 0.1],
        rgba=rgba,
    )


def _plate(
    body: Element, name: str, pos: ArrayLike, quat: np.ndarray, **geom: object
) -> None:
    body.add("geom", name=name, type="box", pos=pos, quat=quat, **geom)


def _turned(angle: float, lean: float) -> np.ndarray:
    """Quaternion (4,) of a lean about y, then a turn about z [rad]."""
    turn, leaning, quat = np.empty(4), np.empty(4), np.empty(4)
    mujoco.mju_axisAngle2Quat(turn, np.array([0, 0, 1.0]), angle)
    mujoco.mju_axisAngle2Quat(leaning, np.array([0, 1.0, 0]), lean)
    mujoco.mju_mulQuat(quat, turn, leaning)
    return quat


def build_pedestal(root: Element, pedestal: Pedestal, jar: Jar) -> None:
    """A V-shaped cradle; its frame is at the centre of the jar that lies in it."""
    rgba = [0.10, 0.10, 0.11, 1]
    half_width, half_thickness = pedestal.plate
    valley = -jar.body_radius / np.sin(SLOPE)
    for name, side in (("near", -1), ("far", 1)):
        along = np.array([side * np.cos(SLOPE), 0, np.sin(SLOPE)])
        outward = np.array([side * np.sin(SLOPE), 0, -np.cos(SLOPE)])
        pos = [0, 0, valley] + half_width * along + half_thickness * outward
        size = [half_width, pedestal.half_length, half_thickness]
        quat = _turned(0.0, -side * SLOPE)
        _plate(root.worldbody, name, pos, quat, size=size, rgba=rgba)
    top, foot = valley - 2 * half_thickness, -pedestal.axis_height - 0.03
    root.worldbody.add(
        "geom",
        name="post",
        type="cylinder",
        fromto=[0, 0, top, 0, 0, foot],
        size=[pedestal.post_radius],
        rgba=rgba,
    )


def build_well(root: Element, well: Well) -> None:
    """An open square box with a chamfer round its rim; its frame is on the table."""
    surface = {
        "friction": [well.friction, 0.005, 0.0001],
        "priority": 2,
        "condim": 4,
        "rgba": [0.16, 0.34, 0.27, 1],
    }
    outer = well.half_width + 2 * well.wall
    body = root.worldbody
    floor = [outer, outer, well.floor_height / 2]
    _plate(body, "floor", [0, 0, floor[2]], _turned(0, 0), size=floor, **surface)
    for i, name in enumerate(("far", "left", "near", "right")):
        _well_side(body, well, name, i * np.pi / 2, surface)
    if well.post is not None:
        foot = np.array([0, 0, well.floor_height])
        top = foot + [0, 0, well.post.height]
        _rod(body, "post", "cylinder", foot, top, well.post.radius, **surface, **_POST)


def _well_side(
    body: Element, well: Well, name: str, angle: float, surface: dict[str, Any]
) -> None:
    """One wall of the receptacle, and the sloping plate on top of it."""
    outer = well.half_width + 2 * well.wall
    outward, up = np.array([np.cos(angle), np.sin(angle), 0]), np.array([0, 0, 1.0])
    size = [well.wall, outer, well.rim_height / 2]
    pos = (well.half_width + well.wall) * outward + size[2] * up
    _plate(body, f"wall_{name}", pos, _turned(angle, 0), size=size, **surface)
    rise = np.cos(SLOPE) * outward + np.sin(SLOPE) * up
    beneath = np.sin(SLOPE) * outward - np.cos(SLOPE) * up
    rim = well.half_width * outward + well.rim_height * up
    pos = rim + well.chamfer / 2 * rise + _CHAMFER_THICKNESS * beneath
    size = [well.chamfer / 2, outer, _CHAMFER_THICKNESS]
    _plate(body, f"chamfer_{name}", pos, _turned(angle, -SLOPE), size=size, **surface)


def build_lamp(root: Element, lamp: Lamp) -> None:
    """A shade open in front of the bulb, on a boom from a stand behind the table."""
    bulb = np.array(lamp.position)
    forward = np.array(lamp.aim) - bulb
    forward /= np.linalg.norm(forward)
    root.worldbody.add(
        "light",
        name="bulb",
        pos=bulb,
        dir=forward,
        cutoff=lamp.cutoff,
        exponent=0,
        attenuation=lamp.attenuation,
        diffuse=[lamp.diffuse] * 3,
        ambient=[0] * 3,
        specular=[0] * 3,
    )
    rear = bulb - 0.06 * forward
    foot = np.array([*lamp.stand, 0.0])
    elbow = np.array([*lamp.stand, rear[2] + 0.1])
    for name, kind, start, end, radius in (
        ("shade", "cylinder", bulb - 0.025 * forward, rear, 0.045),
        ("stand", "capsule", foot, elbow, 0.012),
        ("boom", "capsule", elbow, rear, 0.01),
        ("foot", "cylinder", foot, foot + [0, 0, 0.02], 0.08),
    ):
        _rod(root.worldbody, name, kind, start, end, radius, rgba=_BRASS)


def build_obstacle(root: Element, obstacle: Obstacle) -> None:
    """An upright post; its frame is on the table."""
    ends = (np.zeros(3), np.array([0, 0, obstacle.height]))
    rgba = [0.55, 0.20, 0.16, 1]
    _rod(root.worldbody, "post", "cylinder", *ends, obstacle.radius, rgba=rgba)


def build_jar(root: Element, jar: Jar, surface: dict[str, Any]) -> None:
    """The two cylinders that collide and carry the mass; z points to the lid."""
    half, shoulder = jar.length / 2, jar.length / 2 - jar.lid_length
    hollow = jar.recess is not None
    for name, low, high, radius, share, touches in (
        ("body", -half, shoulder, jar.body_radius, 1 - jar.lid_share, _SOLID),
        ("lid", shoulder, half, jar.lid_radius, jar.lid_share, _HOLLOW),
    ):
        ends = (np.array([0, 0, low]), np.array([0, 0, high]))
        geom = surface | {"mass": share * jar.mass} | (touches if hollow else {})
        _rod(root.worldbody, name, "cylinder", *ends, radius, **geom)
    if jar.recess is not None:
        _line(root.worldbody, jar.recess, half, surface | {"mass": 0} | _LINING)


def _line(body: Element, recess: Recess, top: float, surface: dict[str, Any]) -> None:
    """The plates round a recess, and the one that it ends at."""
    thickness = _RECESS_THICKNESS
    width = (recess.radius + 2 * thickness) * np.tan(np.pi / _FACETS)
    for i in range(_FACETS):
        angle = 2 * np.pi * i / _FACETS
        outward = np.array([np.cos(angle), np.sin(angle), 0])
        pos = (recess.radius + thickness) * outward + [0, 0, top - recess.depth / 2]
        size = [thickness, width, recess.depth / 2]
        _plate(body, f"recess_{i}", pos, _turned(angle, 0), size=size, **surface)
    end = np.array([0, 0, top - recess.depth])
    behind = end - [0, 0, 2 * thickness]
    _rod(body, "recess_end", "cylinder", behind, end, recess.radius, **surface)


def _rod(
    body: Element,
    name: str,
    kind: str,
    start: np.ndarray,
    end: np.ndarray,
    radius: float,
    **geom: object,
) -> None:
    """A cylinder or capsule from one point to another."""
    ends = [*start, *end]
    body.add("geom", name=name, type=kind, fromto=ends, size=[radius], **geom)
