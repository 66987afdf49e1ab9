"""Deterministic automata of discrete events, as Ramadge and Wonham (1987) write them.

G = (Q, Sigma, delta, q0, Qm): states, events, a partial transition function, where it
starts and where a task is complete. An event is controllable if a supervisor can keep
it from happening. Nothing here knows of robots.
"""

from collections.abc import Callable, Hashable, Iterable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Generic, NamedTuple, Self, TypeVar

import networkx as nx

from prospect_mj.checks import check_choice
from prospect_mj.errors import InvalidChoice, InvalidValue

State = TypeVar("State", bound=Hashable)
Event = TypeVar("Event", bound=Hashable)

_GOAL = object()
"""Stands behind all marked states when the way to them is searched."""


class Run(NamedTuple, Generic[State, Event]):
    """How far an automaton follows a word."""

    state: State
    """Where it stands after the last event that it accepted."""
    n_accepted: int
    """Events that it followed."""
    refused: Event | None
    """The first event that is not possible in `state`; None = it followed them all."""


@dataclass(frozen=True)
class Automaton(Generic[State, Event]):
    """A deterministic automaton with a partial transition function.

    Raises:
        InvalidChoice: if a state that is named anywhere is not one of `states`.
    """

    states: frozenset[State]
    """Q."""
    controllable: frozenset[Event]
    """The events that a supervisor can disable."""
    transitions: Mapping[State, Mapping[Event, State]]
    """delta: state, event, next state."""
    initial: State
    """q0."""
    marked: frozenset[State]
    """Qm."""

    def __post_init__(self) -> None:
        """Refuse states that are none of Q."""
        ends = {target for row in self.transitions.values() for target in row.values()}
        for what, named in (
            ("initial state", {self.initial}),
            ("marked state", self.marked),
            ("state with transitions", self.transitions.keys()),
            ("next state", ends),
        ):
            for state in named - self.states:
                raise InvalidChoice(what, state, self.states)

    @cached_property
    def events(self) -> frozenset[Event]:
        """Sigma: the controllable events and all that occur in a transition."""
        rows = self.transitions.values()
        return self.controllable | {event for row in rows for event in row}

    def enabled(self, state: State) -> Mapping[Event, State]:
        """The events possible in a state, and where they lead."""
        check_choice("state", state, self.states)
        return self.transitions.get(state, {})

    def graph(self, events: Iterable[Event] | None = None) -> "nx.MultiDiGraph[State]":
        """The transitions as a graph, each with its `event`; `events` None = all."""
        chosen = None if events is None else frozenset(events)
        graph: nx.MultiDiGraph[State] = nx.MultiDiGraph()
        graph.add_nodes_from(self.states)
        for state, row in self.transitions.items():
            for event, target in row.items():
                if chosen is None or event in chosen:
                    graph.add_edge(state, target, event=event)
        return graph

    def reachable(self, start: State | None = None) -> frozenset[State]:
        """States that some word leads to, from `start` or else the initial state."""
        root = self.initial if start is None else start
        check_choice("state", root, self.states)
        return frozenset({root} | nx.descendants(self.graph(), root))

    def coreachable(
        self,
        events: Iterable[Event] | None = None,
        within: Iterable[State] | None = None,
    ) -> frozenset[State]:
        """States from which some word leads to a marked state.

        Args:
            events: those that the word may be made of; None = all.
            within: the states that it may pass through, its ends included; None = all.
        """
        graph = self.graph(events)
        if within is not None:
            graph.remove_nodes_from(self.states - frozenset(within))
        goals = [state for state in self.marked if state in graph]
        graph.add_node(_GOAL)
        graph.add_edges_from((state, _GOAL) for state in goals)
        return frozenset(nx.ancestors(graph, _GOAL))

    def restricted(self, states: Iterable[State]) -> Self:
        """The sub-automaton of some states and of the transitions among them.

        Raises:
            InvalidValue: if the initial state is not among them.
        """
        kept = self.states & frozenset(states)
        if self.initial not in kept:
            raise InvalidValue("states", f"{len(kept)}", "some with the initial one")
        return type(self)(
            kept,
            self.controllable,
            {
                state: {event: end for event, end in row.items() if end in kept}
                for state, row in self.transitions.items()
                if state in kept
            },
            self.initial,
            self.marked & kept,
        )

    def without(self, disabled: Callable[[State, Event], bool]) -> Self:
        """The same automaton less the transitions that `disabled` is true of."""
        transitions = {
            state: {
                event: end for event, end in row.items() if not disabled(state, event)
            }
            for state, row in self.transitions.items()
        }
        return replace(self, transitions=transitions)

    def run(
        self, word: Iterable[Event], start: State | None = None
    ) -> Run[State, Event]:
        """Follow a word up to the first event that is not possible."""
        state = self.initial if start is None else start
        n_accepted = 0
        for event in word:
            if event not in self.enabled(state):
                return Run(state, n_accepted, event)
            state = self.enabled(state)[event]
            n_accepted += 1
        return Run(state, n_accepted, None)
