"""The six actions as operators of the planner's model, for either hand and end.

They say what the success of an action does (`supervisor.effects`), and geometry says
where it can succeed. The table of effects alone can't: to it an insertion may go well
or jam, whichever end the hand holds.
"""

from collections.abc import Callable, Iterator
from typing import NamedTuple

from prospect_mj.experiment.development.rivals.planner.facts import (
    ENDS,
    INSERTED,
    End,
    Operator,
    empty,
    holds,
    lies,
    opposite,
)
from prospect_mj.experiment.development.rivals.planner.geometry import Geometry
from prospect_mj.recording.hands import GRASPS, INSERTIONS, NUMBERS, SWAPS
from prospect_mj.robot.names import SIDES, Side, other


class Conditional(NamedTuple):
    """An operator, and what geometry must say for it."""

    operator: Operator
    possible: Callable[[Geometry], bool]


def operators() -> Iterator[Conditional]:
    """Each action of each hand with each end."""
    for side in SIDES:
        for end in ENDS:
            yield _grasp(side, end)
            yield _swap(side, end)
            yield _insert(side, end)


def _grasp(side: Side, end: End) -> Conditional:
    """Take the lying jar by the end on the hand's side."""
    lying = {lies(side, end), lies(other(side), opposite(end))}
    operator = Operator(
        GRASPS[NUMBERS[side]],
        needs=frozenset({*lying, *map(empty, SIDES)}),
        adds=frozenset({holds(side, end)}),
        deletes=frozenset({*lying, empty(side)}),
    )
    return Conditional(operator, lambda geometry: geometry.reaches_cradle(side))


def _swap(side: Side, end: End) -> Conditional:
    """Hand the jar over, which the other hand takes by its other end."""
    taker = other(side)
    operator = Operator(
        SWAPS[NUMBERS[side]],
        needs=frozenset({holds(side, end), empty(taker)}),
        adds=frozenset({holds(taker, opposite(end)), empty(side)}),
        deletes=frozenset({holds(side, end), empty(taker)}),
    )
    return Conditional(operator, lambda geometry: geometry.reaches_hand(taker))


def _insert(side: Side, end: End) -> Conditional:
    """Lower the free end into the receptacle."""
    operator = Operator(
        INSERTIONS[NUMBERS[side]],
        needs=frozenset({holds(side, end), empty(other(side))}),
        adds=frozenset({INSERTED, empty(side)}),
        deletes=frozenset({holds(side, end)}),
    )
    return Conditional(operator, lambda geometry: geometry.fits(opposite(end)))
