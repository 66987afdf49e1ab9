"""One three-finger BarrettHand as MJCF."""

import xml.etree.ElementTree as ET

from scipy.spatial.transform import Rotation

from prospect_mj.robot import barrett_hand, names, posture, wam
from prospect_mj.robot.description.elements import (
    DARK,
    SHELL,
    TIP,
    body,
    geom,
    position,
    text,
    wxyz,
)
from prospect_mj.robot.names import Side

_LINK_MASSES = (0.06, 0.04)
"""Proximal and distal link of a finger, tip included [kg]; ours, not published."""
_LINK_RADII = (0.009, 0.007)
"""[m]"""


def hand(flange: ET.Element, side: Side) -> None:
    """Add a hand to the flange of its arm."""
    s = names.sign(side)
    mount = text([0, 0, wam.WRIST_TO_FLANGE])
    palm = body(flange, names.palm(side), pos=mount, gravcomp="1")
    fingers = len(barrett_hand.FINGERS) * sum(_LINK_MASSES)
    mass = text([barrett_hand.MASS - fingers])
    top = (0, 0, barrett_hand.PALM_HEIGHT)
    label = names.palm(side)
    geom(palm, label, "cylinder", (0, 0, 0), top, 0.042, DARK, mass=mass)
    ET.SubElement(palm, "site", name=names.wrist(side), pos="0 0 0", size="0.005")
    origin, lean = posture.grasp_frame()
    ET.SubElement(
        palm,
        "site",
        name=names.grasp_site(side),
        pos=text(origin * [1, s, 1]),
        quat=text(wxyz(Rotation.from_euler("y", lean))),
        size="0.005",
    )
    for number in barrett_hand.FINGERS:
        _finger(palm, side, number)


def _finger(palm: ET.Element, side: Side, number: int) -> None:
    s = names.sign(side)
    base, heading = barrett_hand.finger_base(number)
    turn = text(wxyz(Rotation.from_euler("z", s * heading)))
    bend = text(wxyz(Rotation.from_euler("y", -barrett_hand.DISTAL_BEND)))
    places = ((base * [1, s, 1], turn), ((barrett_hand.PROXIMAL, 0, 0), bend))
    lengths = (barrett_hand.PROXIMAL, barrett_hand.DISTAL)
    limits = (barrett_hand.PROXIMAL_RANGE, barrett_hand.DISTAL_RANGE)
    parent = palm
    for i, joint in enumerate(names.finger_joints(side)[number - 1]):
        place, turned = places[i]
        parent = body(parent, joint, pos=text(place), quat=turned, gravcomp="1")
        _finger_joint(parent, joint, limits[i])
        shape = ((0, 0, 0), (lengths[i], 0, 0), _LINK_RADII[i], SHELL)
        mass = text([0.9 * _LINK_MASSES[i]])
        geom(parent, joint, "capsule", *shape, mass=mass)
    tip = names.fingertips(side)[number - 1]
    ball = ((barrett_hand.DISTAL, 0, 0), None, barrett_hand.TIP_RADIUS, TIP)
    geom(parent, tip, "sphere", *ball, mass=text([0.1 * sum(_LINK_MASSES)]))


def _finger_joint(body: ET.Element, name: str, limits: tuple[float, float]) -> None:
    servo = barrett_hand.SERVO
    torque = servo.torque_limit
    ET.SubElement(
        body,
        "joint",
        name=name,
        axis="0 -1 0",
        range=text(limits),
        armature=text([servo.armature]),
        damping="0.02",
        actuatorfrcrange=text([-torque, torque]),
    )


def actuators(actuator: ET.Element, side: Side) -> None:
    """Add the servos of the fingers' joints."""
    servo = barrett_hand.SERVO
    gains = (servo.stiffness, servo.damping, servo.torque_limit)
    for proximal, distal in names.finger_joints(side):
        position(actuator, proximal, gains, barrett_hand.PROXIMAL_RANGE)
        position(actuator, distal, gains, barrett_hand.DISTAL_RANGE)


def sensors(sensor: ET.Element, side: Side) -> None:
    """Add the fingertips' touch sensors."""
    for tip, touch in zip(names.fingertips(side), names.touches(side), strict=True):
        reading = {"data": "found force pos normal", "reduce": "maxforce", "num": "1"}
        ET.SubElement(sensor, "contact", name=touch, geom1=tip, **reading)
