"""One WAM arm as MJCF."""

import xml.etree.ElementTree as ET

from prospect_mj.robot import mounting, names, wam
from prospect_mj.robot.description.elements import (
    DARK,
    JOINT,
    SHELL,
    body,
    geom,
    mirrored_range,
    position,
    text,
    wxyz,
)
from prospect_mj.robot.names import Side

# Collision and visual shape of the arm's links: name, type, from, to, radius, material.
_LINK_SHAPES = (
    (("motor", "cylinder", (0, 0, -0.10), (0, 0, -0.03), 0.075, JOINT),),
    (("shoulder", "sphere", (0, 0, 0), None, 0.08, SHELL),),
    (
        ("upper", "capsule", (0, 0, 0.14), (0, 0, 0.47), 0.055, SHELL),
        ("elbow", "capsule", (0, 0, 0.47), (0.045, 0, 0.55), 0.05, JOINT),
    ),
    (("forearm", "capsule", (-0.03, 0, 0.03), (-0.045, 0, 0.17), 0.045, SHELL),),
    (("wrist_yaw", "capsule", (0, 0, 0.17), (0, 0, 0.22), 0.042, SHELL),),
    (("wrist_pitch", "sphere", (0, 0, 0), None, 0.045, JOINT),),
    (("flange", "cylinder", (0, 0, 0.03), (0, 0, 0.06), 0.04, DARK),),
)


def arm(world: ET.Element, side: Side) -> ET.Element:
    """Add an arm without its hand, and return the body of its flange."""
    parent = ET.SubElement(
        world,
        "body",
        name=f"{side}_base",
        pos=text(mounting.shoulder_position(side)),
        quat=text(wxyz(mounting.shoulder_rotation(side))),
    )
    for i, link in enumerate(names.arm_links(side)):
        origin = text(wam.LINK_ORIGINS[i])
        parent = body(parent, link, pos=origin, gravcomp="1")
        _arm_joint(parent, side, i)
        shapes = _LINK_SHAPES[i]
        mass = text([wam.LINK_MASSES[i] / len(shapes)])
        for name, kind, start, end, radius, material in shapes:
            label = f"{side}_{name}"
            geom(parent, label, kind, start, end, radius, material, mass=mass)
    return parent


def _arm_joint(body: ET.Element, side: Side, i: int) -> None:
    flips = names.sign(side) if wam.MIRROR[i] < 0 else 1
    torque = wam.TORQUE_LIMITS[i]
    ET.SubElement(
        body,
        "joint",
        name=names.arm_joints(side)[i],
        axis={"y": "0 1 0", "z": "0 0 1"}[wam.JOINT_AXES[i]],
        range=text(mirrored_range(wam.JOINT_LIMITS[i], flips)),
        armature=text([wam.SERVO.armature[i]]),
        damping=text([wam.SERVO.friction_damping[i]]),
        # The motors carry the arm's weight, so that it counts against their limit.
        actuatorgravcomp="true",
        actuatorfrcrange=text([-torque, torque]),
    )


def exclusions(contact: ET.Element, side: Side) -> None:
    """Links that touch by construction; parent and child are excluded by MuJoCo."""
    link1 = names.arm_links(side)[0]
    ET.SubElement(
        contact, "exclude", name=f"{side}_shoulder", body1="trunk", body2=link1
    )


def actuators(actuator: ET.Element, side: Side) -> None:
    """Add the position servos of the arm."""
    for i, joint in enumerate(names.arm_joints(side)):
        gains = (wam.SERVO.stiffness[i], wam.SERVO.damping[i], wam.TORQUE_LIMITS[i])
        flips = names.sign(side) if wam.MIRROR[i] < 0 else 1
        position(actuator, joint, gains, mirrored_range(wam.JOINT_LIMITS[i], flips))


def sensors(sensor: ET.Element, side: Side) -> None:
    """Add the wrist's force/torque sensor."""
    site = names.wrist(side)
    ET.SubElement(sensor, "force", name=names.wrist_force(side), site=site)
    ET.SubElement(sensor, "torque", name=names.wrist_torque(side), site=site)
