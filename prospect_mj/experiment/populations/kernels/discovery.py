"""The twin of `agent.discovery.DiscoveryQ`."""

import numpy as np

from prospect_mj.agent.discovery.examples import NOT_READ
from prospect_mj.agent.features import N_BINS
from prospect_mj.experiment.populations.kernels import cache
from prospect_mj.experiment.populations.kernels.discovery_discoverer import consider
from prospect_mj.experiment.populations.kernels.discovery_state import DiscoveryState
from prospect_mj.experiment.populations.kernels.discovery_values import (
    leaf_of,
    learn,
    split,
    value_of,
)
from prospect_mj.experiment.populations.kernels.graph import (
    DONE,
    N_ACTIONS,
    Graph,
    Outcomes,
    Rule,
    Trials,
)
from prospect_mj.experiment.populations.kernels.walk import (
    Walk,
    begin,
    largest,
    new_walk,
    take,
)


@cache.kept
def run(
    state: DiscoveryState,
    graph: Graph,
    trials: Trials,
    rule: Rule,
    outcomes: Outcomes,
    rng: np.random.Generator,
) -> tuple[int, int]:
    """Learn from every trial in turn; see `kernels`."""
    walk = new_walk()
    for trial in range(len(trials.root)):
        _look(state, trials, trial)
        node, n_visits, n_steps = begin(walk, graph, trials, rule, trial), 0, 0
        for step in range(trials.draws.shape[1]):
            haptic = graph.haptic[node]
            _expect(state, haptic)
            values = state.sight.values
            taken = take(walk, graph, trials, rule, outcomes, values, node, trial, step)
            if taken.ended != DONE:
                return taken.ended, trial
            node, n_steps = taken.node, step + 1
            place = haptic, taken.action, graph.haptic[node], taken.terminated, step
            n_visits = _learn(state, walk, rule, n_visits, *place)
            if taken.inserted:
                break
        _end_trial(state, rule, n_visits, n_steps, rng)
    return DONE, len(trials.root)


@cache.called
def _look(state: DiscoveryState, trials: Trials, trial: int) -> None:
    """Begin a trial: find the leaves that its picture is in."""
    sight, visual = state.sight, trials.visual[trials.image[trial]]
    total = 0.0
    for place in range(N_BINS):
        total += visual[place]
        sight.picture[place + 1] = total
    side = trials.orientation[trial] if state.options.is_forced else NOT_READ
    sight.orientation[0] = side
    for haptic in range(sight.leaf.shape[0]):
        for action in range(N_ACTIONS):
            sight.is_visited[haptic, action] = False
            sight.leaf[haptic, action] = leaf_of(
                state.contexts, haptic, action, sight.picture, side
            )


@cache.called
def _expect(state: DiscoveryState, haptic: int) -> None:
    """Look up the values of all actions in a haptic state."""
    sight = state.sight
    for action in range(N_ACTIONS):
        leaf = sight.leaf[haptic, action]
        sight.values[action] = value_of(state.contexts, haptic, action, leaf)


@cache.called
def _learn(
    state: DiscoveryState,
    walk: Walk,
    rule: Rule,
    n_visits: int,
    haptic: int,
    action: int,
    next_haptic: int,
    terminated: bool,
    step: int,
) -> int:
    """Learn values from a step; give the number of first visits so far."""
    contexts, sight, visits = state.contexts, state.sight, state.visits
    target = -1.0
    if not terminated:
        _expect(state, next_haptic)
        target += rule.discount * largest(sight.values, walk.allowed)
    leaf = sight.leaf[haptic, action]
    if not sight.is_visited[haptic, action]:
        sight.is_visited[haptic, action] = True
        visits.context[n_visits, 0], visits.context[n_visits, 1] = haptic, action
        visits.leaf[n_visits] = leaf
        visits.predicted[n_visits] = value_of(contexts, haptic, action, leaf)
        visits.mean_before[n_visits] = contexts.mean[haptic, action]
        visits.target[n_visits], visits.step[n_visits] = target, step
        visits.next_haptic[n_visits] = next_haptic
        visits.terminated[n_visits] = terminated
        for other in range(N_ACTIONS):
            visits.allowed[n_visits, other] = walk.allowed[other]
        n_visits += 1
    learn(contexts, haptic, action, leaf, target, state.options.least_rate)
    return n_visits


@cache.called
def _end_trial(
    state: DiscoveryState,
    rule: Rule,
    n_visits: int,
    n_steps: int,
    rng: np.random.Generator,
) -> None:
    """Consider what was done for the first time in the trial, in that order."""
    visits, contexts = state.visits, state.contexts
    for visit in range(n_visits):
        outcome = visits.target[visit]
        if state.options.by_return:
            outcome = 0.0
            for _ in range(visits.step[visit], n_steps):
                outcome = -1.0 + rule.discount * outcome
        consider(state, rule.discount, visit, outcome, rng)
    for action in range(N_ACTIONS - 1, -1, -1):
        for haptic in range(contexts.mean.shape[0] - 1, -1, -1):
            if state.forced_after[haptic, action] == state.n_trials[0]:
                was_told = contexts.told[haptic, action]
                split(state, haptic, action, was_told, rule.discount)
    state.n_trials[0] += 1
