"""The supervised automaton small enough to be drawn: states merged, actions as nodes.

Predicate states that differ only in whether an arm came to rest or is astray become one
node, and so do the forbidden states of a constraint. Starts that can change nothing are
left out.
"""

from enum import StrEnum
from typing import NamedTuple

import networkx as nx

from prospect_mj.actions.action import Action
from prospect_mj.robot.names import Side
from prospect_mj.supervisor.constraints import violated
from prospect_mj.supervisor.effects import can_change, outcomes
from prospect_mj.supervisor.plant import Situation, Start, is_marked, supervision
from prospect_mj.supervisor.predicates import Jar, PredicateState, every_state


class Group(StrEnum):
    """Predicate states between two actions that are drawn as one."""

    SEEN = "jar seen"
    LEFT = "left hand holds the jar"
    RIGHT = "right hand holds the jar"
    INSERTED = "jar inserted"
    UNKNOWN = "jar unknown"


class Forbidden(NamedTuple):
    """The forbidden states of a constraint that a mistake can lead to."""

    constraint: str
    holder: Side
    """The hand that held the jar before."""


class Attempt(NamedTuple):
    """An action, started in a group of states."""

    group: Group
    action: Action


Node = Group | Forbidden | Attempt

HOLDERS: dict[Group, Side] = {Group.LEFT: "left", Group.RIGHT: "right"}


def group_of(state: PredicateState) -> Group:
    """The group of a state that is not forbidden."""
    for group, side in HOLDERS.items():
        if state.arm(side).holding:
            return group
    named = {Jar.SEEN: Group.SEEN, Jar.INSERTED: Group.INSERTED}
    return named.get(state.jar, Group.UNKNOWN)


def summary() -> "nx.DiGraph[Node]":
    """The graph of groups, attempts and forbidden states.

    Returns:
        A graph whose nodes of groups say whether they are `marked`, whose nodes of
        attempts say whether they are `disabled`, and whose edges from attempts have the
        `results` that they stand for.
    """
    reached = supervision().automaton.reachable()
    graph: nx.DiGraph[Node] = nx.DiGraph()
    for state in every_state():
        if Situation(state) in reached:
            group = group_of(state)
            graph.add_node(group, marked=is_marked(state))
            for action in Action:
                if can_change(action, state):
                    _add_attempt(graph, group, action, state)
    return graph


def _add_attempt(
    graph: "nx.DiGraph[Node]", group: Group, action: Action, state: PredicateState
) -> None:
    attempt = Attempt(group, action)
    disabled = (Situation(state), Start(action)) in supervision().disabled
    graph.add_node(attempt, disabled=disabled)
    graph.add_edge(group, attempt)
    for result, after in outcomes(action, state):
        for end in _ends(group, after, disabled):
            results = graph.get_edge_data(attempt, end, {"results": ()})["results"]
            graph.add_edge(attempt, end, results=tuple({*results, str(result)}))


def _ends(group: Group, after: PredicateState, disabled: bool) -> tuple[Node, ...]:
    """Nodes that an outcome leads to; of a disabled attempt the forbidden ones only."""
    if not disabled:
        return (group_of(after),)
    return tuple(Forbidden(name, HOLDERS[group]) for name in violated(after))
