"""The torso's MJCF, written from one arm and one hand; the sides are reflections.

Reflection in the sagittal plane maps a link's local point (x, y, z) to (x, -y, z),
keeps the sign of joints about y and flips that of joints about z.
"""

import xml.etree.ElementTree as ET
from collections.abc import Iterable

import numpy as np
from scipy.spatial.transform import Rotation

from prospect_mj.robot import barrett_hand, names, posture, wam
from prospect_mj.robot.names import SIDES, Side

SHOULDER_HEIGHT = 0.55
SHOULDER_HALF_WIDTH = 0.22
"""Place of the shoulder centres [m]; the Torso's own is not published. J1 points
outward along y, which of all mounts searched keeps pick, swap and insertion in one
connected part of the arm's workspace."""

EYE = (0.08, 0.05, 0.85)
"""Position of the left camera [m]; the right one is its reflection."""
GAZE = (0.62, 0.0, 0.20)
"""The fixed point at which both cameras are aimed: the nominal place of the jar."""
EYE_FOVY = 22.0
"""Vertical field of view [deg]: a fovea on the presentation area."""

_SHELL, _JOINT, _DARK, _TIP = "shell", "joint", "dark", "tip"
_MATERIALS = {
    _SHELL: "0.72 0.74 0.78 1",
    _JOINT: "0.32 0.34 0.38 1",
    _DARK: "0.13 0.14 0.16 1",
    _TIP: "0.10 0.22 0.38 1",
}
# Collision and visual shape of the arm's links: name, type, from, to, radius, material.
_LINK_SHAPES = (
    (("motor", "cylinder", (0, 0, -0.10), (0, 0, -0.03), 0.075, _JOINT),),
    (("shoulder", "sphere", (0, 0, 0), None, 0.08, _SHELL),),
    (
        ("upper", "capsule", (0, 0, 0.14), (0, 0, 0.47), 0.055, _SHELL),
        ("elbow", "capsule", (0, 0, 0.47), (0.045, 0, 0.55), 0.05, _JOINT),
    ),
    (("forearm", "capsule", (-0.03, 0, 0.03), (-0.045, 0, 0.17), 0.045, _SHELL),),
    (("wrist_yaw", "capsule", (0, 0, 0.17), (0, 0, 0.22), 0.042, _SHELL),),
    (("wrist_pitch", "sphere", (0, 0, 0), None, 0.045, _JOINT),),
    (("flange", "cylinder", (0, 0, 0.03), (0, 0, 0.06), 0.04, _DARK),),
)
_FINGER_MASSES = (0.06, 0.04)
_N_FINGER_MASS = len(barrett_hand.FINGERS) * sum(_FINGER_MASSES)


def torso_xml() -> str:
    """The whole file `models/torso.xml`."""
    root = ET.Element("mujoco", model="torso")
    ET.SubElement(root, "compiler", angle="radian", autolimits="true")
    ET.SubElement(root, "option", timestep="0.0025", integrator="implicitfast")
    _assets(ET.SubElement(root, "asset"))
    world = ET.SubElement(root, "worldbody")
    _trunk(world)
    sections = [ET.SubElement(root, tag) for tag in ("contact", "actuator", "sensor")]
    for side in SIDES:
        _arm(world, side)
        _exclusions(sections[0], side)
        _actuators(sections[1], side)
        _sensors(sections[2], side)
    home = np.concatenate([_home(side) for side in SIDES])
    key = {"name": names.HOME, "qpos": _text(home), "ctrl": _text(home)}
    ET.SubElement(ET.SubElement(root, "keyframe"), "key", key)
    ET.indent(root)
    note = "<!-- Written by scripts/make_torso.py from one arm and one hand. -->\n"
    return note + ET.tostring(root, encoding="unicode") + "\n"


def _text(values: Iterable[float]) -> str:
    """Numbers as MJCF text, rounded to a nanometre so that no -0 or 1e-17 appears."""
    return " ".join(f"{round(float(v), 9) + 0.0:.10g}" for v in values)


def _home(side: Side) -> np.ndarray:
    fingers = np.outer(posture.OPEN, [1.0, barrett_hand.COUPLING])
    return np.concatenate([posture.home(side), fingers.ravel()])


def _assets(parent: ET.Element) -> None:
    for name, rgba in _MATERIALS.items():
        ET.SubElement(
            parent, "material", name=name, rgba=rgba, specular="0.3", shininess="0.5"
        )


def _body(parent: ET.Element, name: str, **attributes: str) -> ET.Element:
    """A body of the robot; WAM and hand carry their own weight (gravcomp)."""
    return ET.SubElement(parent, "body", name=name, **attributes)


def _geom(
    parent: ET.Element,
    name: str,
    kind: str,
    start: Iterable[float],
    end: Iterable[float] | None,
    radius: float,
    material: str,
    **attributes: str,
) -> None:
    place = {"pos": _text(start)} if end is None else {"fromto": _text([*start, *end])}
    shape = {"type": kind, "size": _text([radius]), "material": material}
    ET.SubElement(parent, "geom", name=name, **shape, **place, **attributes)


def _trunk(world: ET.Element) -> None:
    trunk = ET.SubElement(world, "body", name="trunk")
    box = {"type": "box", "pos": "-0.07 0 -0.06", "size": "0.055 0.10 0.69"}
    ET.SubElement(trunk, "geom", name="column", material=_JOINT, **box)
    beam = ((0, -0.10, SHOULDER_HEIGHT), (0, 0.10, SHOULDER_HEIGHT))
    _geom(trunk, "beam", "cylinder", *beam, 0.085, _SHELL)
    head = ET.SubElement(world, "body", name="head")
    _geom(head, "neck", "capsule", (-0.05, 0, 0.6), (-0.02, 0, 0.8), 0.035, _JOINT)
    _geom(head, "skull", "capsule", (0, -0.05, 0.85), (0, 0.05, 0.85), 0.055, _SHELL)
    for name in names.EYES:
        y = EYE[1] if name.startswith("left") else -EYE[1]
        eye = np.array([EYE[0], y, EYE[2]])
        _geom(head, name, "cylinder", (0.03, y, 0.85), (0.07, y, 0.84), 0.022, _DARK)
        camera = {"pos": _text(eye), "xyaxes": _text(_look_at(eye, np.array(GAZE)))}
        ET.SubElement(head, "camera", name=name, fovy=_text([EYE_FOVY]), **camera)


def _look_at(eye: np.ndarray, target: np.ndarray) -> np.ndarray:
    """MuJoCo's camera axes x (right) and y (up), (6,), with z away from the target."""
    backward = (eye - target) / np.linalg.norm(eye - target)
    right = np.cross([0.0, 0.0, 1.0], backward)
    right /= np.linalg.norm(right)
    return np.concatenate([right, np.cross(backward, right)])


def _arm(world: ET.Element, side: Side) -> None:
    s = names.sign(side)
    parent = ET.SubElement(
        world,
        "body",
        name=f"{side}_base",
        pos=_text([0, s * SHOULDER_HALF_WIDTH, SHOULDER_HEIGHT]),
        quat=_text(_wxyz(Rotation.from_euler("x", -s * np.pi / 2))),
    )
    for i, link in enumerate(names.arm_links(side)):
        origin = _text(wam.LINK_ORIGINS[i])
        parent = _body(parent, link, pos=origin, gravcomp="1")
        _arm_joint(parent, side, i)
        shapes = _LINK_SHAPES[i]
        mass = _text([wam.LINK_MASSES[i] / len(shapes)])
        for name, kind, start, end, radius, material in shapes:
            label = f"{side}_{name}"
            _geom(parent, label, kind, start, end, radius, material, mass=mass)
    _hand(parent, side)


def _wxyz(rotation: Rotation) -> np.ndarray:
    return rotation.as_quat(scalar_first=True)


def mirrored_range(limits: tuple[float, float], sign: int) -> tuple[float, float]:
    """A joint's range, or its reflection where the joint's sign flips."""
    return limits if sign > 0 else (-limits[1], -limits[0])


def _arm_joint(body: ET.Element, side: Side, i: int) -> None:
    flips = names.sign(side) if wam.MIRROR[i] < 0 else 1
    torque = wam.TORQUE_LIMITS[i]
    ET.SubElement(
        body,
        "joint",
        name=names.arm_joints(side)[i],
        axis={"y": "0 1 0", "z": "0 0 1"}[wam.JOINT_AXES[i]],
        range=_text(mirrored_range(wam.JOINT_LIMITS[i], flips)),
        armature=_text([wam.SERVO.armature[i]]),
        damping=_text([wam.SERVO.friction_damping[i]]),
        # The motors carry the arm's weight, so that it counts against their limit.
        actuatorgravcomp="true",
        actuatorfrcrange=_text([-torque, torque]),
    )


def _hand(flange: ET.Element, side: Side) -> None:
    s = names.sign(side)
    mount = _text([0, 0, wam.WRIST_TO_FLANGE])
    palm = _body(flange, names.palm(side), pos=mount, gravcomp="1")
    mass = _text([barrett_hand.MASS - _N_FINGER_MASS])
    top = (0, 0, barrett_hand.PALM_HEIGHT)
    label = names.palm(side)
    _geom(palm, label, "cylinder", (0, 0, 0), top, 0.042, _DARK, mass=mass)
    ET.SubElement(palm, "site", name=names.wrist(side), pos="0 0 0", size="0.005")
    position, tilt = posture.grasp_frame()
    ET.SubElement(
        palm,
        "site",
        name=names.grasp_site(side),
        pos=_text(position * [1, s, 1]),
        quat=_text(_wxyz(Rotation.from_euler("y", tilt))),
        size="0.005",
    )
    for number in barrett_hand.FINGERS:
        _finger(palm, side, number)


def _finger(palm: ET.Element, side: Side, number: int) -> None:
    s = names.sign(side)
    base, heading = barrett_hand.finger_base(number)
    turn = _text(_wxyz(Rotation.from_euler("z", s * heading)))
    bend = _text(_wxyz(Rotation.from_euler("y", -barrett_hand.DISTAL_BEND)))
    places = ((base * [1, s, 1], turn), ((barrett_hand.PROXIMAL, 0, 0), bend))
    lengths = (barrett_hand.PROXIMAL, barrett_hand.DISTAL)
    limits = (barrett_hand.PROXIMAL_RANGE, barrett_hand.DISTAL_RANGE)
    parent = palm
    for i, joint in enumerate(names.finger_joints(side)[number - 1]):
        position, turned = places[i]
        parent = _body(parent, joint, pos=_text(position), quat=turned, gravcomp="1")
        _finger_joint(parent, joint, limits[i])
        shape = ((0, 0, 0), (lengths[i], 0, 0), (0.009, 0.007)[i], _SHELL)
        mass = _text([_FINGER_MASSES[i] * 0.9])
        _geom(parent, joint, "capsule", *shape, mass=mass)
    tip = names.fingertips(side)[number - 1]
    place = ((barrett_hand.DISTAL, 0, 0), None, barrett_hand.TIP_RADIUS, _TIP)
    _geom(parent, tip, "sphere", *place, mass=_text([0.1 * sum(_FINGER_MASSES)]))


def _finger_joint(body: ET.Element, name: str, limits: tuple[float, float]) -> None:
    servo = barrett_hand.SERVO
    torque = servo.torque_limit
    ET.SubElement(
        body,
        "joint",
        name=name,
        axis="0 -1 0",
        range=_text(limits),
        armature=_text([servo.armature]),
        damping="0.02",
        actuatorfrcrange=_text([-torque, torque]),
    )


def _exclusions(contact: ET.Element, side: Side) -> None:
    """Links that touch by construction; parent and child are excluded by MuJoCo."""
    link1 = names.arm_links(side)[0]
    ET.SubElement(
        contact, "exclude", name=f"{side}_shoulder", body1="trunk", body2=link1
    )


def _actuators(actuator: ET.Element, side: Side) -> None:
    for i, joint in enumerate(names.arm_joints(side)):
        gains = (wam.SERVO.stiffness[i], wam.SERVO.damping[i], wam.TORQUE_LIMITS[i])
        flips = names.sign(side) if wam.MIRROR[i] < 0 else 1
        _position(actuator, joint, gains, mirrored_range(wam.JOINT_LIMITS[i], flips))
    servo = barrett_hand.SERVO
    gains = (servo.stiffness, servo.damping, servo.torque_limit)
    for proximal, distal in names.finger_joints(side):
        _position(actuator, proximal, gains, barrett_hand.PROXIMAL_RANGE)
        _position(actuator, distal, gains, barrett_hand.DISTAL_RANGE)


def _position(
    actuator: ET.Element,
    joint: str,
    gains: tuple[float, float, float],
    limits: tuple[float, float],
) -> None:
    stiffness, damping, torque = gains
    ET.SubElement(
        actuator,
        "position",
        name=joint,
        joint=joint,
        kp=_text([stiffness]),
        kv=_text([damping]),
        ctrlrange=_text(limits),
        forcerange=_text([-torque, torque]),
    )


def _sensors(sensor: ET.Element, side: Side) -> None:
    site = names.wrist(side)
    ET.SubElement(sensor, "force", name=names.wrist_force(side), site=site)
    ET.SubElement(sensor, "torque", name=names.wrist_torque(side), site=site)
    for tip, touch in zip(names.fingertips(side), names.touches(side), strict=True):
        reading = {"data": "found force pos normal", "reduce": "maxforce", "num": "1"}
        ET.SubElement(sensor, "contact", name=touch, geom1=tip, **reading)
