"""The plant: everything the six actions can do if nobody supervises them.

Its states are predicates and what runs; between two actions nothing runs. To start an
action is controllable; how it ends, together with the predicates observed then, is not.
As the observed predicates are part of the event, the automaton is deterministic and
every observed event can be checked against it.
"""

from enum import StrEnum
from functools import cache
from typing import NamedTuple, TypeAlias

from prospect_mj.actions.action import Action, ActionResult
from prospect_mj.supervisor import constraints, effects
from prospect_mj.supervisor.automaton import Automaton
from prospect_mj.supervisor.predicates import (
    NOTHING_SEEN,
    PRESENTED,
    Jar,
    PredicateState,
    every_state,
)
from prospect_mj.supervisor.synthesis import Supervision, synthesise


class Look(StrEnum):
    """The one look that begins a trial; it is nobody's choice."""

    LOOK = "look"


Running: TypeAlias = Action | Look | None


class Situation(NamedTuple):
    """A state of the plant."""

    predicates: PredicateState
    """Those at the last time that nothing ran."""
    running: Running = None
    """None between two actions."""


class Start(NamedTuple):
    """Controllable: an action is started."""

    action: Action

    def __str__(self) -> str:
        """Such as `start grasp-left`."""
        return f"start {self.action.label}"


class End(NamedTuple):
    """Uncontrollable: what ran has ended."""

    result: ActionResult
    """How; a look ends in `success` or `not_seen`."""
    predicates: PredicateState
    """What the robot observes of itself then."""

    def __str__(self) -> str:
        """Such as `success: left holds in front, ...`."""
        return f"{self.result}: {self.predicates}"


Plant: TypeAlias = Automaton[Situation, Start | End]

INITIAL = Situation(NOTHING_SEEN, Look.LOOK)
"""Arms at rest, and the look under way."""


def is_marked(state: PredicateState) -> bool:
    """Whether a trial may end here: the jar is inserted, or given up.

    A jar that was lost, or never seen, ends what a trial can achieve, and no supervisor
    can keep a jar from slipping: such states must be marked, or nothing at all would be
    allowed. They do not have to have their arms at rest, since an arm that ended astray
    can't be called home by any of the six actions. But the way from any other state has
    to lead to an insertion, see `progress`.
    """
    held = bool(state.holders)
    return state.jar is Jar.INSERTED or (state.jar is Jar.UNKNOWN and not held)


@cache
def plant() -> Plant:
    """Build the plant from the tables of effects, over all predicate states."""
    states = tuple(every_state())
    transitions: dict[Situation, dict[Start | End, Situation]] = {
        INITIAL: {
            End(result, seen): Situation(seen)
            for result, seen in (
                (ActionResult.SUCCESS, PRESENTED),
                (ActionResult.NOT_SEEN, NOTHING_SEEN),
            )
        }
    }
    for state in states:
        idle = transitions[Situation(state)] = {}
        for action in Action:
            running = idle[Start(action)] = Situation(state, action)
            transitions[running] = {
                End(*outcome): Situation(outcome.predicates)
                for outcome in effects.outcomes(action, state)
            }
    return Automaton(
        states=frozenset(transitions),
        controllable=frozenset(map(Start, Action)),
        transitions=transitions,
        initial=INITIAL,
        marked=frozenset(Situation(state) for state in states if is_marked(state)),
    )


def forbidden() -> tuple[Situation, ...]:
    """The situations that the constraints forbid: none while an action runs."""
    return tuple(
        Situation(state) for state in every_state() if constraints.violated(state)
    )


def progress() -> frozenset[Start | End]:
    """What a way to the end of a trial may be made of: anything but losing the jar.

    Without this, every state would count as non-blocking: a jar that is held can always
    be lost, and a lost jar may be given up.
    """
    return frozenset(
        event
        for event in plant().events
        if isinstance(event, Start) or event.result is not ActionResult.LOST
    )


@cache
def supervision() -> Supervision[Situation, Start | End]:
    """The maximally permissive supervisor of the plant, over all predicate states."""
    return synthesise(plant(), forbidden(), progress())
