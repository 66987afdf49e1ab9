"""The states that must not be between two actions, each by its name.

They hold *between* actions only: what a swap passes through, with both hands on the jar
for a moment, is its own affair. None of them names an action; which action is
dangerous, and where, is what the synthesis computes.
"""

from collections.abc import Callable, Mapping

from prospect_mj.robot.names import SIDES, other
from prospect_mj.supervisor.predicates import Place, PredicateState

Constraint = Callable[[PredicateState], bool]
"""True of the states that it forbids."""


def _both_hands_on_one_jar(state: PredicateState) -> bool:
    return len(state.holders) > 1


def _open_hand_over_a_held_jar(state: PredicateState) -> bool:
    """Over its own, as at rest every hand is open, or over that of the other hand."""
    return any(
        state.arm(side).place is Place.REST
        or state.arm(other(side)) == (False, Place.FRONT)
        for side in state.holders
    )


def _two_arms_in_one_workspace(state: PredicateState) -> bool:
    """Steering round the other arm is of no use where both are to be at one place."""
    return all(state.arm(side).place is Place.FRONT for side in SIDES)


CONSTRAINTS: Mapping[str, Constraint] = {
    "both hands pull on one jar": _both_hands_on_one_jar,
    "an open hand over a held jar": _open_hand_over_a_held_jar,
    "two arms in one workspace": _two_arms_in_one_workspace,
}
"""What is forbidden between actions."""


def violated(state: PredicateState) -> tuple[str, ...]:
    """The names of the constraints that a state violates."""
    return tuple(name for name, forbids in CONSTRAINTS.items() if forbids(state))
