"""The whole torso as MJCF: trunk, head with its stereo pair, two arms, two hands."""

import xml.etree.ElementTree as ET

import numpy as np

from prospect_mj.robot import barrett_hand, mounting, names, posture
from prospect_mj.robot.description import arm, hand
from prospect_mj.robot.description.elements import (
    DARK,
    JOINT,
    MATERIALS,
    SHELL,
    geom,
    text,
)
from prospect_mj.robot.names import SIDES, Side
from prospect_mj.sim.props import PRESENTATION

EYE = (0.08, 0.05, 0.85)
"""Position of the left camera [m]; the right one is its reflection."""
GAZE = PRESENTATION
"""The fixed point at which both cameras are aimed: the nominal place of the jar."""
EYE_FOVY = 22.0
"""Vertical field of view [deg]: a fovea on the presentation area."""


def torso_xml() -> str:
    """The whole file `models/torso.xml`."""
    root = ET.Element("mujoco", model="torso")
    ET.SubElement(root, "compiler", angle="radian", autolimits="true")
    ET.SubElement(root, "option", timestep="0.0025", integrator="implicitfast")
    _assets(ET.SubElement(root, "asset"))
    world = ET.SubElement(root, "worldbody")
    _trunk(world)
    contact, actuator, sensor = (
        ET.SubElement(root, tag) for tag in ("contact", "actuator", "sensor")
    )
    for side in SIDES:
        hand.hand(arm.arm(world, side), side)
        arm.exclusions(contact, side)
        for part in (arm, hand):
            part.actuators(actuator, side)
            part.sensors(sensor, side)
    home = np.concatenate([_home(side) for side in SIDES])
    key = {"name": names.HOME, "qpos": text(home), "ctrl": text(home)}
    ET.SubElement(ET.SubElement(root, "keyframe"), "key", key)
    ET.indent(root)
    note = "<!-- Written by scripts/make_torso.py from one arm and one hand. -->\n"
    return note + ET.tostring(root, encoding="unicode") + "\n"


def _home(side: Side) -> np.ndarray:
    fingers = np.outer(posture.OPEN, [1.0, barrett_hand.COUPLING])
    return np.concatenate([posture.home(side), fingers.ravel()])


def _assets(parent: ET.Element) -> None:
    for name, rgba in MATERIALS.items():
        ET.SubElement(
            parent, "material", name=name, rgba=rgba, specular="0.3", shininess="0.5"
        )


def _trunk(world: ET.Element) -> None:
    trunk = ET.SubElement(world, "body", name="trunk")
    box = {"type": "box", "pos": "-0.07 0 -0.06", "size": "0.055 0.10 0.69"}
    ET.SubElement(trunk, "geom", name="column", material=JOINT, **box)
    height = mounting.SHOULDER_HEIGHT
    beam = ((0, -0.10, height), (0, 0.10, height))
    geom(trunk, "beam", "cylinder", *beam, 0.085, SHELL)
    head = ET.SubElement(world, "body", name="head")
    geom(head, "neck", "capsule", (-0.05, 0, 0.6), (-0.02, 0, 0.8), 0.035, JOINT)
    geom(head, "skull", "capsule", (0, -0.05, 0.85), (0, 0.05, 0.85), 0.055, SHELL)
    for name in names.EYES:
        y = EYE[1] if name.startswith("left") else -EYE[1]
        eye = np.array([EYE[0], y, EYE[2]])
        geom(head, name, "cylinder", (0.03, y, 0.85), (0.07, y, 0.84), 0.022, DARK)
        camera = {"pos": text(eye), "xyaxes": text(_look_at(eye, np.array(GAZE)))}
        ET.SubElement(head, "camera", name=name, fovy=text([EYE_FOVY]), **camera)


def _look_at(eye: np.ndarray, target: np.ndarray) -> np.ndarray:
    """MuJoCo's camera axes x (right) and y (up), (6,), with z away from the target."""
    backward = (eye - target) / np.linalg.norm(eye - target)
    right = np.cross([0.0, 0.0, 1.0], backward)
    right /= np.linalg.norm(right)
    return np.concatenate([right, np.cross(backward, right)])
