"""The strategies of a trial, as Wheeler, Fagg and Grupen (2002) tell them apart.

Section 2, of the child study that section 3.2 takes them over from: "Late Correction
Strategy: The child used an initial nonradial grip and placed the handle of the spoon in
the mouth, then made a correction"; "Early Correction Strategy: The child used an
initial nonradial grip, then made a correction without first placing the handle in the
mouth"; "Optimal Strategy: The child used an initial radial grip and obtained the
applesauce without need for corrective action." The radial grip is here the grasp by the
hand on the lid's side, and the handle in the mouth is an insertion that failed.
"""

from enum import IntEnum

import numpy as np
from numpy.typing import NDArray

from prospect_mj.agent.haptics import LEFT, NONE, RIGHT
from prospect_mj.recording.hands import GRASPS, INSERTIONS, SWAPS
from prospect_mj.task.presentation import Orientation

Booleans = NDArray[np.bool_]


class Strategy(IntEnum):
    """How the jar came to be inserted."""

    OPTIMAL = 0
    """First grasped by the hand on the lid's side, and not passed on."""
    EARLY = 1
    """First grasped by the other hand; no insertion failed."""
    LATE = 2
    """First grasped by the other hand; an insertion failed."""
    OTHER = 3
    """Anything else, an unsolved trial among it."""


class Grip(IntEnum):
    """How the first grasp of a trial took the jar, or tried to."""

    RADIAL = 0
    """By the hand on the lid's side."""
    NONRADIAL = 1
    """By the other hand."""


def classify(
    lid: NDArray[np.int8],
    actions: NDArray[np.int8],
    executed: Booleans,
    inserted: Booleans,
) -> NDArray[np.int8]:
    """The strategy of every trial.

    Only executed actions count. The first grasp is the first one that was executed,
    whatever came of it; an insertion failed where it was executed and the jar doesn't
    stand in the receptacle.

    Args:
        lid: (...), the lid's side, LEFT or RIGHT; in a world where the jar goes in with
            its lid down, the side of its body.
        actions: (..., max_actions); after the last one anything.
        executed: (..., max_actions), whether an action was run; false after the last.
        inserted: (..., max_actions), whether it left the jar in the receptacle.

    Returns:
        (...), numbers of `Strategy`.
    """
    solved = (executed & inserted).any(axis=-1)
    swapped = (executed & np.isin(actions, [*SWAPS.values()])).any(axis=-1)
    failed = (executed & np.isin(actions, [*INSERTIONS.values()]) & ~inserted).any(
        axis=-1
    )
    grip = first_grip(lid, first_hand(actions, executed))
    wrong = solved & (grip == Grip.NONRADIAL)
    right = solved & (grip == Grip.RADIAL) & ~swapped
    kinds = [right, wrong & failed, wrong]
    names = [Strategy.OPTIMAL, Strategy.LATE, Strategy.EARLY]
    return np.select(kinds, names, Strategy.OTHER).astype(np.int8)


def first_hand(actions: NDArray[np.int8], executed: Booleans) -> NDArray[np.int8]:
    """The hand of the first executed grasp, whatever came of it.

    Args:
        actions: (..., max_actions); after the last one anything.
        executed: (..., max_actions), whether an action was run; false after the last.

    Returns:
        (...), LEFT or RIGHT, or NONE where there was no grasp.
    """
    hands = np.full(actions.shape, NONE, np.int8)
    for hand, grasp in GRASPS.items():
        hands[executed & (actions == grasp)] = hand
    first = (hands != NONE).argmax(axis=-1)[..., None]
    return np.take_along_axis(hands, first, axis=-1)[..., 0]


def first_grip(lid: NDArray[np.int8], hand: NDArray[np.int8]) -> NDArray[np.int8]:
    """How the first grasp took the jar.

    Args:
        lid: (...), the lid's side, LEFT or RIGHT.
        hand: (...), the hand of the first grasp, or NONE.

    Returns:
        (...), numbers of `Grip`, or -1 without a grasp.
    """
    grip = np.where(hand == lid, Grip.RADIAL, Grip.NONRADIAL)
    return np.where(hand == NONE, -1, grip).astype(np.int8)


def easy(lid: NDArray[np.int8], dominant: Orientation) -> Booleans:
    """Whether a trial is easy: the lid lies on the dominant hand's side.

    Args:
        lid: (...), LEFT or RIGHT.
        dominant: the hand that the pretraining made dominant.

    Returns:
        (...); the trials that are not are the paper's difficult ones.
    """
    return np.asarray(lid) == (LEFT if dominant == "left" else RIGHT)
