"""What each action may set and may destroy: a table of effects per kind of action.

A table says what the controllers under an action do from *any* predicate state, not
only from those that the action is meant for; that is what lets the danger of an action
be computed. It is written for one hand and the opposite one, and so holds for both
sides. Every way out of the plans in `prospect_mj.actions` is here; what ends in another
way is an event that the model did not foresee (`monitor`).

In one place a table says more than the plans do. A grasp reaches for the jar where it
is known to be, also if that is in a hand. The plan reaches for a jar that was *seen*,
and forgets that as soon as it has lifted it, so that it would answer `not_seen`; but
that a variable is cleared elsewhere is nothing to build safety on. Its controllers take
hold of a held jar just as well: a swap is made of them, with a giver who then lets go.
"""

from collections.abc import Callable
from dataclasses import dataclass
from enum import StrEnum
from typing import NamedTuple

from prospect_mj.actions.action import Action, ActionResult
from prospect_mj.robot.names import Side, other
from prospect_mj.supervisor.predicates import (
    AT_REST,
    CARRYING,
    ArmState,
    Jar,
    Place,
    PredicateState,
    state_of,
)


class ArmEffect(StrEnum):
    """What becomes of an arm."""

    UNCHANGED = "as before"
    """Nothing that its predicates would tell."""
    CARRIES = "holds, in front"
    """Holds the jar in front of the chest."""
    STRANDS = "holds, in front or astray"
    """Holds the jar, but may have ended short of the place in front."""
    WITHDRAWS = "empty, at rest or astray"
    """Has opened, backed out and gone home, or ended short of that."""
    OPENS = "opened, at rest or astray"
    """The same, for whatever reason it was opened: a hand that held the jar has let it
    fall, and may not have noticed."""
    TUGGED = "as before, may lose its hold"
    """The other hand pulls at what it holds, if it holds anything."""


class JarEffect(StrEnum):
    """What becomes of the knowledge of a jar that is in no hand."""

    UNCHANGED = "as before"
    FORGOTTEN = "no longer seen"
    """It was lifted or dropped: where it was seen says nothing any more."""
    INSERTED = "inserted"


class Condition(StrEnum):
    """In which predicate states an outcome can happen."""

    LOCATED = "seen or held"
    """The robot knows where the jar is."""
    NOT_SEEN = "not seen"
    """It does not lie where the look found it."""
    HELD = "the hand holds"
    """The hand that the action is named for first holds the jar."""
    NOT_HELD = "the hand holds nothing"


@dataclass(frozen=True)
class Effect:
    """One way in which an action can end."""

    result: ActionResult
    """How it ends."""
    when: Condition
    """Where it can end so."""
    hand: ArmEffect = ArmEffect.UNCHANGED
    """On the hand that the action is named for first: a swap's giver."""
    opposite: ArmEffect = ArmEffect.UNCHANGED
    """On the other hand: a swap's taker."""
    jar: JarEffect = JarEffect.UNCHANGED


Table = tuple[Effect, ...]

_R, _C, _A, _J = ActionResult, Condition, ArmEffect, JarEffect

GRASP: Table = (
    Effect(_R.SUCCESS, _C.LOCATED, _A.CARRIES, _A.TUGGED, _J.FORGOTTEN),
    Effect(_R.NOT_GRASPED, _C.LOCATED, _A.OPENS, _A.TUGGED),
    Effect(_R.NOT_REACHED, _C.LOCATED, _A.OPENS, _A.TUGGED),
    Effect(_R.NOT_REACHED, _C.LOCATED, _A.STRANDS, _A.TUGGED, _J.FORGOTTEN),
    Effect(_R.LOST, _C.LOCATED, _A.WITHDRAWS, _A.TUGGED, _J.FORGOTTEN),
    Effect(_R.NOT_SEEN, _C.NOT_SEEN),
)
"""Reach, take hold, lift, weigh, present."""

SWAP: Table = (
    Effect(_R.SUCCESS, _C.HELD, _A.WITHDRAWS, _A.CARRIES),
    Effect(_R.NOT_GRASPED, _C.HELD, _A.UNCHANGED, _A.OPENS),
    Effect(_R.NOT_REACHED, _C.HELD, _A.UNCHANGED, _A.OPENS),
    Effect(_R.NOT_REACHED, _C.HELD, _A.WITHDRAWS, _A.STRANDS),
    Effect(_R.LOST, _C.HELD, _A.WITHDRAWS, _A.WITHDRAWS, _J.FORGOTTEN),
    Effect(_R.NOT_ALLOWED, _C.NOT_HELD),
)
"""The other hand takes hold, then the giver lets go and goes home."""

INSERT: Table = (
    Effect(_R.SUCCESS, _C.HELD, _A.WITHDRAWS, jar=_J.INSERTED),
    Effect(_R.JAMMED, _C.HELD, _A.CARRIES),
    Effect(_R.NOT_REACHED, _C.HELD, _A.STRANDS),
    Effect(_R.LOST, _C.HELD, _A.WITHDRAWS, jar=_J.FORGOTTEN),
    Effect(_R.NOT_ALLOWED, _C.NOT_HELD),
)
"""Align over the receptacle, lower by feel, let go or come back with the jar."""

EFFECTS: dict[Action, tuple[Table, Side]] = {
    Action.GRASP_LEFT: (GRASP, "left"),
    Action.GRASP_RIGHT: (GRASP, "right"),
    Action.SWAP_LEFT_TO_RIGHT: (SWAP, "left"),
    Action.SWAP_RIGHT_TO_LEFT: (SWAP, "right"),
    Action.INSERT_LEFT: (INSERT, "left"),
    Action.INSERT_RIGHT: (INSERT, "right"),
}
"""The table of each action, and the hand that it is named for first."""

_EMPTIED = (AT_REST, ArmState(False, Place.ASTRAY))

_ARM_AFTER: dict[ArmEffect, Callable[[ArmState], tuple[ArmState, ...]]] = {
    ArmEffect.UNCHANGED: lambda arm: (arm,),
    ArmEffect.CARRIES: lambda arm: (CARRYING,),
    ArmEffect.STRANDS: lambda arm: (CARRYING, ArmState(True, Place.ASTRAY)),
    ArmEffect.WITHDRAWS: lambda arm: _EMPTIED,
    ArmEffect.OPENS: lambda arm: (
        *_EMPTIED,
        *(emptied._replace(holding=arm.holding) for emptied in _EMPTIED),
    ),
    ArmEffect.TUGGED: lambda arm: (arm, arm._replace(holding=False)),
}

_JAR_AFTER: dict[JarEffect, Callable[[Jar], Jar]] = {
    JarEffect.UNCHANGED: lambda jar: jar,
    JarEffect.FORGOTTEN: lambda jar: Jar.UNKNOWN if jar is Jar.SEEN else jar,
    JarEffect.INSERTED: lambda jar: Jar.INSERTED,
}


class Outcome(NamedTuple):
    """How an action ended, and the predicates that the robot observes then."""

    result: ActionResult
    predicates: PredicateState


def outcomes(action: Action, state: PredicateState) -> tuple[Outcome, ...]:
    """All ways in which an action that is started in a state can end, each once."""
    table, side = EFFECTS[action]
    hand, opposite = state.arm(side), state.arm(other(side))
    found = (
        Outcome(
            effect.result,
            state_of(side, own, across, _JAR_AFTER[effect.jar](state.jar)),
        )
        for effect in table
        if _holds(effect.when, state, hand)
        for own in _ARM_AFTER[effect.hand](hand)
        for across in _ARM_AFTER[effect.opposite](opposite)
    )
    return tuple(dict.fromkeys(found))


def can_start(action: Action, state: PredicateState) -> bool:
    """Whether an action has what it needs: a swap and an insertion need the jar."""
    results = {result for result, _ in outcomes(action, state)}
    return results != {ActionResult.NOT_ALLOWED}


def can_change(action: Action, state: PredicateState) -> bool:
    """Whether an action could change any predicate of a state."""
    return any(after != state for _, after in outcomes(action, state))


def _holds(when: Condition, state: PredicateState, hand: ArmState) -> bool:
    seen = state.jar is Jar.SEEN
    truths = {
        Condition.LOCATED: seen or bool(state.holders),
        Condition.NOT_SEEN: not seen,
        Condition.HELD: hand.holding,
        Condition.NOT_HELD: not hand.holding,
    }
    return truths[when]
