"""What the planner's model says of a situation, as facts that hold or don't.

STRIPS (Fikes and Nilsson, Artificial Intelligence 2, 1971): a situation is a set of
facts, and an operator is what it needs, what it adds and what it deletes.
"""

from typing import Literal, NamedTuple

from prospect_mj.actions.action import Action
from prospect_mj.robot.names import SIDES, Side, other
from prospect_mj.task.presentation import Orientation

End = Literal["lid", "body"]
"""Of the jar."""
ENDS: tuple[End, ...] = ("lid", "body")


class Fact(NamedTuple):
    """A fact, such as that the left hand holds the jar by its lid."""

    name: Literal["inserted", "empty", "holds", "lies"]
    side: Side | None = None
    """Of a hand, or where an end of the lying jar is."""
    end: End | None = None


Facts = frozenset[Fact]

INSERTED = Fact("inserted")
GOAL: Facts = frozenset({INSERTED})


class Operator(NamedTuple):
    """An action as the model has it."""

    action: Action
    needs: Facts
    adds: Facts
    deletes: Facts

    def applied(self, facts: Facts) -> Facts:
        """The facts that hold after it."""
        return (facts - self.deletes) | self.adds

    def regressed(self, goal: Facts) -> Facts | None:
        """What must hold before it, so that a goal holds after it.

        Returns:
            (goal - adds) and needs; None if the operator adds nothing to the goal or
            deletes some of it.
        """
        if not self.adds & goal or (self.deletes - self.adds) & goal:
            return None
        return (goal - self.adds) | self.needs


def opposite(end: End) -> End:
    """The other end of the jar."""
    return "body" if end == "lid" else "lid"


def empty(side: Side) -> Fact:
    """A hand holds nothing."""
    return Fact("empty", side)


def holds(side: Side, end: End) -> Fact:
    """A hand holds the jar by an end."""
    return Fact("holds", side, end)


def lies(side: Side, end: End) -> Fact:
    """The jar lies in the cradle with an end to a side."""
    return Fact("lies", side, end)


def presented(lid: Orientation) -> Facts:
    """The facts when a trial begins."""
    ends = {lies(lid, "lid"), lies(other(lid), "body")}
    return frozenset({*ends, *map(empty, SIDES)})


def holder(facts: Facts) -> Side | None:
    """The hand that holds the jar, None if none does."""
    sides = (fact.side for fact in facts if fact.name == "holds")
    return next(sides, None)


def turned_round(facts: Facts) -> Facts:
    """The same with the jar's ends exchanged."""
    return frozenset(
        fact if fact.end is None else fact._replace(end=opposite(fact.end))
        for fact in facts
    )


def consistent(facts: Facts) -> bool:
    """Whether no two facts exclude each other: there is one jar, with two ends."""
    held = [fact for fact in facts if fact.name == "holds"]
    lying = [fact for fact in facts if fact.name == "lies"]
    somewhere = bool(held) + bool(lying) + (INSERTED in facts)
    sides = {fact.side for fact in lying}
    ends = {fact.end for fact in lying}
    one_hand = len(held) <= 1 and not any(empty(fact.side) in facts for fact in held)
    return somewhere <= 1 and one_hand and len(lying) == len(sides) == len(ends)
