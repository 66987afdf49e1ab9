"""Hands by number, and their actions; the numbers stand for the lid's side as well."""

import numpy as np
from numpy.typing import NDArray

from prospect_mj.actions.action import Action
from prospect_mj.agent.haptics import LEFT, NONE, RIGHT
from prospect_mj.recording.worlds import WORLDS
from prospect_mj.robot.names import SIDES, Side

NUMBERS: dict[Side, int] = {"left": LEFT, "right": RIGHT}

GRASPS = {LEFT: Action.GRASP_LEFT, RIGHT: Action.GRASP_RIGHT}
SWAPS = {LEFT: Action.SWAP_LEFT_TO_RIGHT, RIGHT: Action.SWAP_RIGHT_TO_LEFT}
"""By the hand that gives."""
INSERTIONS = {LEFT: Action.INSERT_LEFT, RIGHT: Action.INSERT_RIGHT}


def number_of(hand: Side | None) -> int:
    """The number of a hand, or NONE."""
    return NONE if hand is None else NUMBERS[hand]


def hand_of(number: int) -> Side | None:
    """The hand with a number, None for NONE."""
    return None if number == NONE else SIDES[number - LEFT]


def inserting_hand(lid: NDArray[np.int8], world: str) -> NDArray[np.int8]:
    """The hand that can insert what it picks up.

    Args:
        lid: side of the lid, LEFT or RIGHT (any shape).
        world: name of the world; it decides which end fits.

    Returns:
        LEFT or RIGHT, in the same shape.
    """
    return np.int8(LEFT + RIGHT) - lid if WORLDS[world].lid_first else lid
