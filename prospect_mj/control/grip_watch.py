"""Watching by touch whether an object is still in the hand."""

from typing import ClassVar

from prospect_mj.control.controller import CONTROL_PERIOD
from prospect_mj.robot.torso import Touch

MIN_CONTACTS = 2
"""Fingertips that must feel the object for it to count as held while moving."""
RELEASE_TIME = 0.1
"""For how long fewer contacts are put down to vibration [s]."""


class GripWatch:
    """Tells when the object has left the hand.

    Args:
        carrying: False for an empty hand, which can lose nothing.
    """

    REASON: ClassVar[str] = "fewer than two fingertips feel the object"

    def __init__(self, carrying: bool = True) -> None:
        """Start with the object just felt."""
        self._carrying = carrying
        self._empty = 0.0

    def lost(self, touch: Touch) -> bool:
        """Whether the object is gone; to be asked once per control period."""
        held = not self._carrying or touch.found.sum() >= MIN_CONTACTS
        self._empty = 0.0 if held else self._empty + CONTROL_PERIOD
        return self._empty > RELEASE_TIME
