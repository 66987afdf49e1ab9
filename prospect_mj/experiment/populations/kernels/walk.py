"""Walking through a trial, which is the same for every compiled learner.

A learner's loop begins each trial with `begin`, then asks `take` for one action after
the other, giving it the values of all actions and learning from what it tells.
"""

from typing import NamedTuple

import numpy as np
from numba import njit
from numpy.typing import NDArray

from prospect_mj.agent.haptics import N_HOLDINGS
from prospect_mj.experiment.populations.kernels.cache import uncounted
from prospect_mj.experiment.populations.kernels.graph import (
    DIVERGED,
    DONE,
    N_ACTIONS,
    UNKNOWN_OUTCOME,
    Graph,
    Outcomes,
    Rule,
    Trials,
)

Floats = NDArray[np.float64]


class Walk(NamedTuple):
    """What is known in a trial beside what the learner knows."""

    failed: NDArray[np.bool_]
    """(3, 6): actions that had no effect, for each of what holds the jar."""
    allowed: NDArray[np.bool_]
    """(6,): what may be chosen in the present state."""


class Taken(NamedTuple):
    """An action that was taken, and where it led."""

    ended: int
    """DONE, or what makes it impossible to go on."""
    action: int
    node: int
    """Where the trial is now."""
    inserted: bool
    """Whether that is the end of it."""
    terminated: bool
    """Whether nothing that follows counts for the target."""


@njit(nogil=True)
def new_walk() -> Walk:
    """Room for what is known in a trial."""
    return Walk(
        np.zeros((N_HOLDINGS, N_ACTIONS), np.bool_), np.zeros(N_ACTIONS, np.bool_)
    )


@uncounted
def begin(walk: Walk, graph: Graph, trials: Trials, rule: Rule, trial: int) -> int:
    """The node where a trial begins; nothing has failed in it."""
    node = trials.root[trial]
    if rule.suppress:
        walk.failed[:] = False
    _allow(walk, graph, trials.phase[trial], rule, node)
    return node


@uncounted
def take(
    walk: Walk,
    graph: Graph,
    trials: Trials,
    rule: Rule,
    done: Outcomes,
    values: Floats,
    node: int,
    trial: int,
    step: int,
) -> Taken:
    """Choose an action by the values (6,) of all and find what it leads to.

    Afterwards `walk.allowed` is what may be chosen next: what the maximum of a target
    is over.
    """
    action = choose(values, walk.allowed, rule.epsilon, trials.draws[trial, step])
    if action < 0:
        return Taken(DIVERGED, action, node, False, False)
    led_to = graph.child[node, action]
    if not 0 <= led_to < len(graph.child):
        return Taken(UNKNOWN_OUTCOME, action, node, False, False)
    done.action[trial, step], done.node[trial, step] = action, led_to
    after, inserted = graph.situation[led_to], graph.inserted[led_to]
    if inserted:
        done.n_actions[trial], done.solved[trial] = step + 1, True
    elif rule.suppress and graph.holding[node] == graph.holding[after]:
        walk.failed[graph.holding[node], action] = True
    _allow(walk, graph, trials.phase[trial], rule, after)
    cut_off = step + 1 == trials.draws.shape[1] and not rule.bootstrap
    return Taken(DONE, action, after, inserted, inserted or cut_off)


@uncounted
def _allow(walk: Walk, graph: Graph, phase: int, rule: Rule, node: int) -> None:
    """Find what may be chosen in a node, as `FailedActionRule.remaining` does."""
    choices, state = graph.choices, graph.state[node]
    remaining = not rule.suppress
    if rule.suppress:
        failed = walk.failed[graph.holding[node]]
        for action in range(N_ACTIONS):
            allowed = choices[phase, state, action] and not failed[action]
            walk.allowed[action] = allowed
            remaining |= allowed
    if not rule.suppress or not remaining:
        for action in range(N_ACTIONS):
            walk.allowed[action] = choices[phase, state, action]


@uncounted
def choose(
    values: Floats, allowed: NDArray[np.bool_], epsilon: float, draw: Floats
) -> int:
    """The action that `epsilon_greedy` takes; -1 where the values are NaN."""
    explored, best = draw[0] < epsilon, largest(values, allowed)
    n_candidates = 0
    for action in range(N_ACTIONS):
        n_candidates += allowed[action] and (explored or values[action] == best)
    number = int(draw[1] * n_candidates)
    for action in range(N_ACTIONS):
        if allowed[action] and (explored or values[action] == best):
            if number == 0:
                return action
            number -= 1
    return -1


@uncounted
def largest(values: Floats, allowed: NDArray[np.bool_]) -> float:
    """The largest value of the allowed actions, NaN if any is."""
    best = -np.inf
    for action in range(N_ACTIONS):
        value = values[action]
        if allowed[action] and (value > best or np.isnan(value)):
            best = value
    return best
