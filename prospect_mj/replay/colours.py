"""One colour for one thing in all views: arms, actions, controllers."""

from collections.abc import Mapping
from types import MappingProxyType

from prospect_mj.robot.names import Side

Colour = tuple[int, int, int]
"""RGB in 0..255."""

ARMS: Mapping[Side, Colour] = MappingProxyType(
    {"left": (86, 180, 233), "right": (240, 130, 40)}
)
ACTIONS: Mapping[str, Colour] = MappingProxyType(
    {
        "grasp-left": (20, 170, 120),
        "grasp-right": (130, 220, 185),
        "swap-left-to-right": (165, 105, 205),
        "swap-right-to-left": (212, 172, 238),
        "insert-left": (214, 178, 20),
        "insert-right": (250, 232, 130),
    }
)
"""Hue: what is done; full or pale: by which hand, or from which one."""
_CONTROLLERS: Mapping[str, Colour] = MappingProxyType(
    {
        "reach": (120, 158, 205),
        "straight reach": (120, 158, 205),
        "posture": (150, 165, 190),
        "posture motion": (150, 165, 190),
        "fine motion": (95, 190, 190),
        "grasp": (20, 170, 120),
        "insertion": (214, 178, 20),
        "weighing": (215, 140, 175),
        "fingers": (165, 165, 172),
    }
)
FAILED: Colour = (228, 80, 80)
CONTACT: Colour = (225, 30, 60)
NEUTRAL: Colour = (150, 150, 158)
"""Of what has no colour of its own, such as a plan that is none of the actions."""


def of_action(name: str) -> Colour:
    """Of an action by its label, or of another plan."""
    return ACTIONS.get(name, NEUTRAL)


def of_controller(words: str) -> Colour:
    """Of a controller by what it is called."""
    return _CONTROLLERS.get(words, NEUTRAL)
