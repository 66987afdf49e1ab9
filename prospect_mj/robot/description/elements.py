"""MJCF elements as text, as all parts of the torso write them."""

import xml.etree.ElementTree as ET
from collections.abc import Iterable

import numpy as np
from scipy.spatial.transform import Rotation

SHELL, JOINT, DARK, TIP = "shell", "joint", "dark", "tip"
MATERIALS = {
    SHELL: "0.72 0.74 0.78 1",
    JOINT: "0.32 0.34 0.38 1",
    DARK: "0.13 0.14 0.16 1",
    TIP: "0.10 0.22 0.38 1",
}


def text(values: Iterable[float]) -> str:
    """Numbers as MJCF text, rounded to a nanometre so that no -0 or 1e-17 appears."""
    return " ".join(f"{round(float(v), 9) + 0.0:.10g}" for v in values)


def wxyz(rotation: Rotation) -> np.ndarray:
    """Quaternion (4,) of a rotation, scalar first."""
    return rotation.as_quat(scalar_first=True)


def mirrored_range(limits: tuple[float, float], sign: int) -> tuple[float, float]:
    """A joint's range, or its reflection where the joint's sign flips."""
    return limits if sign > 0 else (-limits[1], -limits[0])


def body(parent: ET.Element, name: str, **attributes: str) -> ET.Element:
    """A body, in its parent's frame."""
    return ET.SubElement(parent, "body", name=name, **attributes)


def geom(
    parent: ET.Element,
    name: str,
    kind: str,
    start: Iterable[float],
    end: Iterable[float] | None,
    radius: float,
    material: str,
    **attributes: str,
) -> None:
    """A geom that serves for collision and for the eye, of a shape with one radius."""
    place = {"pos": text(start)} if end is None else {"fromto": text([*start, *end])}
    shape = {"type": kind, "size": text([radius]), "material": material}
    ET.SubElement(parent, "geom", name=name, **shape, **place, **attributes)


def position(
    actuator: ET.Element,
    joint: str,
    gains: tuple[float, float, float],
    limits: tuple[float, float],
) -> None:
    """A position servo, named like its joint; gains: stiffness, damping, torque."""
    stiffness, damping, torque = gains
    ET.SubElement(
        actuator,
        "position",
        name=joint,
        joint=joint,
        kp=text([stiffness]),
        kv=text([damping]),
        ctrlrange=text(limits),
        forcerange=text([-torque, torque]),
    )
