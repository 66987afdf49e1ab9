"""Names of the torso's MuJoCo elements: the only place where they are spelled."""

from typing import Literal, get_args

from prospect_mj.errors import InvalidChoice
from prospect_mj.robot import barrett_hand, wam

Side = Literal["left", "right"]
SIDES: tuple[Side, ...] = get_args(Side)

HOME = "home"
"""Keyframe with both arms at rest and both hands open."""

EYES: tuple[str, ...] = ("left_eye", "right_eye")
"""The head's stereo pair of cameras."""


def checked_side(side: str) -> Side:
    """Return `side`, or raise `InvalidChoice` if it is not a side."""
    for valid in SIDES:
        if side == valid:
            return valid
    raise InvalidChoice("side", side, SIDES)


def other(side: Side) -> Side:
    """The opposite side."""
    return "right" if checked_side(side) == "left" else "left"


def sign(side: Side) -> int:
    """+1 for the left (+y), -1 for the right: reflection in the sagittal plane."""
    return 1 if checked_side(side) == "left" else -1


def arm_joints(side: Side) -> tuple[str, ...]:
    """The seven joints of an arm, shoulder to wrist; actuators bear the same names."""
    return tuple(f"{side}_joint{i + 1}" for i in range(wam.N_JOINTS))


def arm_links(side: Side) -> tuple[str, ...]:
    """The bodies of an arm, shoulder to flange, without the hand."""
    return tuple(f"{side}_link{i + 1}" for i in range(wam.N_JOINTS))


def palm(side: Side) -> str:
    """The hand's base body."""
    return f"{side}_palm"


def wrist(side: Side) -> str:
    """The site of the wrist's force/torque sensor, on the flange."""
    return f"{side}_wrist"


def grasp_site(side: Side) -> str:
    """The site where a grasped jar's axis meets the plane of the three fingertips."""
    return f"{side}_grasp"


def wrist_force(side: Side) -> str:
    """The wrist's force sensor."""
    return f"{side}_wrist_force"


def wrist_torque(side: Side) -> str:
    """The wrist's torque sensor."""
    return f"{side}_wrist_torque"


def finger(side: Side, number: int) -> str:
    """Stem of a finger's names, number 1 to 3."""
    return f"{side}_finger{number}"


def finger_joints(side: Side) -> tuple[tuple[str, str], ...]:
    """(proximal, distal) joint of each finger; actuators bear the same names."""
    stems = [finger(side, number) for number in barrett_hand.FINGERS]
    return tuple((f"{stem}_proximal", f"{stem}_distal") for stem in stems)


def fingertips(side: Side) -> tuple[str, ...]:
    """The fingertip spheres."""
    return tuple(f"{finger(side, n)}_tip" for n in barrett_hand.FINGERS)


def touches(side: Side) -> tuple[str, ...]:
    """The fingertips' touch sensors."""
    return tuple(f"{finger(side, n)}_touch" for n in barrett_hand.FINGERS)
