"""The predicates that the supervisor decides by, as one state of the robot.

Each is the convergence of a controller, or something that the robot senses of itself
(Huber and Grupen 1996): whether a hand's grasp holds, where an arm has come to rest,
whether the look found the jar, whether the insertion went to its end.
"""

from collections.abc import Iterator
from enum import StrEnum
from itertools import product
from typing import NamedTuple

from prospect_mj.robot.names import SIDES, Side, other


class Place(StrEnum):
    """Where an arm is between actions."""

    REST = "at rest"
    """In its home posture, the hand open."""
    FRONT = "in front"
    """The hand is where a held jar is kept between actions: in front of the chest."""
    ASTRAY = "astray"
    """Neither: a motion ended short. The arm stands still, and every motion of the
    other arm steers round it."""


class Jar(StrEnum):
    """What is known of a jar that is in no hand."""

    SEEN = "seen"
    """It lies where the look found it."""
    INSERTED = "inserted"
    """An insertion went down to the floor of the receptacle, and the hand let go."""
    UNKNOWN = "unknown"
    """Nothing: it is in a hand, it was lost, or it was never seen."""


class ArmState(NamedTuple):
    """The predicates of one arm."""

    holding: bool
    """Whether its grasp holds the jar."""
    place: Place
    """Where it is."""


AT_REST = ArmState(False, Place.REST)
CARRYING = ArmState(True, Place.FRONT)


class PredicateState(NamedTuple):
    """All predicates between two actions."""

    left: ArmState
    right: ArmState
    jar: Jar

    def arm(self, side: Side) -> ArmState:
        """The predicates of an arm."""
        return self.left if side == "left" else self.right

    @property
    def holders(self) -> tuple[Side, ...]:
        """The hands whose grasp holds."""
        return tuple(side for side in SIDES if self.arm(side).holding)

    def __str__(self) -> str:
        """Such as `left holds in front, right empty at rest, jar unknown`."""
        arms = (
            f"{side} {'holds' if arm.holding else 'empty'} {arm.place}"
            for side in SIDES
            if (arm := self.arm(side))
        )
        return ", ".join((*arms, f"jar {self.jar}"))


def state_of(side: Side, arm: ArmState, opposite: ArmState, jar: Jar) -> PredicateState:
    """A predicate state in terms of one arm and the opposite one."""
    arms = {side: arm, other(side): opposite}
    return PredicateState(arms["left"], arms["right"], jar)


PRESENTED = PredicateState(AT_REST, AT_REST, Jar.SEEN)
"""A trial begins: arms at rest, and the look found the jar."""

NOTHING_SEEN = PredicateState(AT_REST, AT_REST, Jar.UNKNOWN)
"""A trial begins, and the look found nothing."""


def carrying(side: Side) -> PredicateState:
    """One hand holds the jar in front of the chest, the other arm is at rest."""
    return state_of(side, CARRYING, AT_REST, Jar.UNKNOWN)


def every_state() -> Iterator[PredicateState]:
    """All combinations of the predicates, possible or not."""
    arms = [ArmState(*values) for values in product((False, True), Place)]
    return (PredicateState(*values) for values in product(arms, arms, Jar))
