"""What the robot believes about the jar: from one look, its joints and its touch."""

from dataclasses import dataclass, field, replace
from typing import Self

import mink
import numpy as np

from prospect_mj.robot.names import SIDES, Side


@dataclass(frozen=True)
class SeenJar:
    """Where a jar was seen to lie; which end bears the lid is not part of it."""

    position: np.ndarray
    """Centre (3,) [m]."""
    axis: np.ndarray
    """Unit vector (3,) along the jar, pointing to the left (+y)."""


@dataclass
class Belief:
    """The robot's memory within a trial; all that controllers keep between actions.

    The jar's frame has its origin at the centre and z towards the end that was on the
    left when it was seen.
    """

    seen: SeenJar | None = None
    """Set by the look, gone once the jar has been picked up or dropped."""
    cradle: SeenJar | None = None
    """Where the jar was seen at first: the cradle stands under it all the time."""
    inserted: mink.SE3 | None = None
    """Pose in the world of a jar that stands in the receptacle."""
    held: dict[Side, mink.SE3] = field(default_factory=dict)
    """Pose of the jar in the grasp frame of each hand that holds it."""

    def __post_init__(self) -> None:
        """Remember where the cradle stands."""
        self.cradle = self.cradle or self.seen

    def copy(self) -> Self:
        """A belief of its own, as actions change theirs."""
        return replace(self, held=dict(self.held))

    @property
    def holding(self) -> Side | None:
        """The hand that holds the jar: the grasp predicates as one value."""
        for side in SIDES:
            if side in self.held:
                return side
        return None
