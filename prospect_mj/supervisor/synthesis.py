"""The least restrictive supervisor that keeps a plant out of its forbidden states.

The supremal controllable and non-blocking sublanguage of a plant (Ramadge and Wonham,
"Supervisory control of a class of discrete event processes", SIAM J. Control and
Optimization 25(1), 1987; its computation as a fixpoint: Wonham and Ramadge, ibid.
25(3), 1987). As the specification is a set of forbidden states, the supervisor is a
function of the state:

    K(0)   = all states but the forbidden ones
    K(i+1) = the states of K(i) that no uncontrollable event takes out of K(i) and
             from which a marked state can be reached within K(i)

until nothing changes. A controllable transition out of the last K is disabled.
"""

from collections import deque
from collections.abc import Collection, Hashable, Iterable, Mapping
from dataclasses import dataclass
from enum import StrEnum
from functools import cached_property
from typing import Generic, NamedTuple

from prospect_mj.errors import InvalidChoice
from prospect_mj.supervisor.automaton import Automaton, Event, State


class Cause(StrEnum):
    """Why a state had to go."""

    FORBIDDEN = "forbidden"
    """It is a forbidden state."""
    BLOCKING = "blocking"
    """No marked state can be reached from it any more."""


class Reason(NamedTuple, Generic[State, Event]):
    """Why a transition is disabled: the end of a story that nothing can stop."""

    path: tuple[Event, ...]
    """Uncontrollable events that can follow it."""
    state: State
    """Where these lead."""
    cause: Cause
    """What is wrong with that state."""


@dataclass(frozen=True)
class Supervision(Generic[State, Event]):
    """What a synthesis found."""

    plant: Automaton[State, Event]
    """What is supervised."""
    kept: frozenset[State]
    """The largest set of states that a supervisor can keep the plant within; if the
    initial state is none of them, no supervisor can do it."""
    _fates: Mapping[State, tuple[Event, State] | Cause]
    """Of every other state: the uncontrollable event and the state that it leads to, or
    what is wrong with the state itself."""

    @cached_property
    def automaton(self) -> Automaton[State, Event]:
        """The plant under supervision.

        Raises:
            InvalidValue: if no supervisor can do it.
        """
        return self.plant.restricted(self.kept)

    @cached_property
    def disabled(self) -> Mapping[tuple[State, Event], Reason[State, Event]]:
        """The controllable transitions of kept states that are disabled, and why."""
        return {
            (state, event): self.reason(target)
            for state in self.kept
            for event, target in self.plant.enabled(state).items()
            if target not in self.kept
        }

    def reason(self, state: State) -> Reason[State, Event]:
        """Why a state is not kept: what can happen from there on its own."""
        path: list[Event] = []
        while not isinstance(fate := self._fates[state], Cause):
            event, state = fate
            path.append(event)
        return Reason(tuple(path), state, fate)


def synthesise(
    plant: Automaton[State, Event],
    forbidden: Collection[State],
    progress: Iterable[Event] | None = None,
) -> Supervision[State, Event]:
    """Find the least restrictive supervisor of a plant.

    Args:
        plant: what can happen if nothing is disabled.
        forbidden: states that must never be reached.
        progress: the events that a way to a marked state may be made of; None = all.
            A plant whose failures end in a marked state would otherwise never block,
            as it could always fail.

    Raises:
        InvalidChoice: if a forbidden state is not one of the plant's.
    """
    for state in frozenset(forbidden) - plant.states:
        raise InvalidChoice("forbidden state", state, plant.states)
    hopeful = None if progress is None else frozenset(progress)
    fates: dict[State, tuple[Event, State] | Cause] = dict.fromkeys(
        forbidden, Cause.FORBIDDEN
    )
    while True:
        n_before = len(fates)
        _remove_uncontrollable(plant, fates)
        _remove_blocking(plant, fates, hopeful)
        if len(fates) == n_before:
            return Supervision(plant, plant.states - fates.keys(), fates)


def _remove_uncontrollable(
    plant: Automaton[State, Event],
    fates: dict[State, tuple[Event, State] | Cause],
) -> None:
    """Add the states from which uncontrollable events alone lead to a removed one."""
    free = plant.events - plant.controllable
    backwards = plant.graph(free).reverse(copy=False)
    # First in, first out: the reasons are then the shortest ones.
    pending = deque(fates)
    while pending:
        lost = pending.popleft()
        for _, state, event in backwards.out_edges(lost, data="event"):
            if state not in fates:
                fates[state] = (event, lost)
                pending.append(state)


def _remove_blocking(
    plant: Automaton[State, Event],
    fates: dict[State, tuple[Event, State] | Cause],
    progress: frozenset[Hashable] | None,
) -> None:
    """Add the states that cannot reach a marked one without a removed one."""
    left = plant.states - fates.keys()
    alive = plant.coreachable(progress, within=left)
    fates |= dict.fromkeys(left - alive, Cause.BLOCKING)
