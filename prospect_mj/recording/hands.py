"""Hands by number; the same numbers stand for the side of the lid."""

from prospect_mj.robot.names import SIDES, Side

NONE, LEFT, RIGHT = 0, 1, 2

NUMBERS: dict[Side, int] = {"left": LEFT, "right": RIGHT}


def number_of(hand: Side | None) -> int:
    """The number of a hand, or NONE."""
    return NONE if hand is None else NUMBERS[hand]


def hand_of(number: int) -> Side | None:
    """The hand with a number, None for NONE."""
    return None if number == NONE else SIDES[number - LEFT]
