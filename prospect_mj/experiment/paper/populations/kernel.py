"""The learner on a graph of outcomes, compiled: whole runs, trial after trial.

It does what `agent.LinearQ` does, given the same random numbers, to the last bit: early
on, many values are equal, and a tie that is rounded away is another action. The picture
stays for a whole trial: a value is computed anew when its weights have changed.

Everything compiled is in this file, as numba's cache doesn't see changes in others, and
is kept where the planner's code is. `compiled_learner` is the way in.
"""

from typing import NamedTuple

import numpy as np
from numba import njit
from numpy.typing import NDArray

from prospect_mj.agent.features import N_BINS
from prospect_mj.planning import kernel_cache

kernel_cache.use()

Floats = NDArray[np.float64]

N_ACTIONS = 6
DONE, UNKNOWN_OUTCOME, DIVERGED = 0, 1, 2
PARTS = ((0, 72), (72, 144), (144, 216), (216, 296), (296, 303))
"""Of the features, as `_product` adds them up: all but the last in eight lanes."""


class Graph(NamedTuple):
    """What every action leads to from n nodes, in s states of the supervisor."""

    child: NDArray[np.int32]
    """(n, 6): the node that an action leads to, the node itself where it is not run, or
    a negative number where the outcome is not known."""
    situation: NDArray[np.int32]
    """(n,): the node in which the trial is after this one."""
    inserted: NDArray[np.bool_]
    """(n,): whether the jar stands in the receptacle, which ends a trial."""
    holding: NDArray[np.int64]
    """(n,): 0 = no hand holds the jar, 1 = left, 2 = right."""
    state: NDArray[np.int32]
    """(n,): number of the supervisor's state."""
    choices: NDArray[np.bool_]
    """(phases, s, 6): whether the learner may choose an action, in every phase of the
    shaping schedule."""


class Trials(NamedTuple):
    """What a run's trials present, and the random numbers the learner uses in them."""

    root: NDArray[np.int32]
    """(n_trials,): the node where a trial begins."""
    image: NDArray[np.int32]
    """(n_trials,): row of `visual`."""
    visual: NDArray[np.float64]
    """(n_images, 100) [1], scaled histograms."""
    phase: NDArray[np.int32]
    """(n_trials,): phase of the shaping schedule."""
    draws: NDArray[np.float64]
    """(n_trials, max_actions, 2), uniform on [0, 1): the two of `LinearQ.choose`."""


class Outcomes(NamedTuple):
    """What the learner did; entries after a trial's last action are -1."""

    n_actions: NDArray[np.int8]
    """(n_trials,) [actions], all that a trial may have where it was not solved."""
    solved: NDArray[np.bool_]
    """(n_trials,): whether the jar was inserted."""
    action: NDArray[np.int8]
    """(n_trials, max_actions): the action taken."""
    node: NDArray[np.int32]
    """(n_trials, max_actions): the node it led to; the one before if it was not run."""


class Rule(NamedTuple):
    """The learner's settings, as the compiled code takes them."""

    step_size: float
    epsilon: float
    discount: float
    one_hot: bool
    bootstrap: bool


class Memory(NamedTuple):
    """What is known in a trial; rows for no hand holding the jar, left and right."""

    weights: Floats
    """theta, (6, 303)."""
    features: Floats
    """phi, (3, 303)."""
    busy: NDArray[np.bool_]
    """(3, 5): whether phi has more than zeros in each of `PARTS`."""
    values: Floats
    """(3, 6) [actions], theta phi."""
    known: NDArray[np.bool_]
    """(3,): whether features and values are those of the present trial."""


@njit(nogil=True, cache=True)
def walk_trials(
    memory: Memory, graph: Graph, trials: Trials, rule: Rule, outcomes: Outcomes
) -> tuple[int, int]:
    """Learn from every trial in turn.

    Args:
        memory: the weights are updated in place.
        graph: what actions lead to.
        trials: what is presented.
        rule: the learner's settings.
        outcomes: written to.

    Returns:
        DONE, UNKNOWN_OUTCOME or DIVERGED, and the trial in which it ended so.
    """
    for trial in range(len(trials.root)):
        memory.known[:] = False
        ended = _run_trial(memory, graph, trials, rule, outcomes, trial)
        if ended != DONE:
            return ended, trial
    return DONE, len(trials.root)


@njit(nogil=True, cache=True)
def _run_trial(
    memory: Memory, graph: Graph, trials: Trials, rule: Rule, done: Outcomes, trial: int
) -> int:
    visual, node = trials.visual[trials.image[trial]], trials.root[trial]
    choices, max_actions = graph.choices[trials.phase[trial]], trials.draws.shape[1]
    for step in range(max_actions):
        holding, allowed = graph.holding[node], choices[graph.state[node]]
        values = _values(memory, visual, holding, rule.one_hot)
        action = _choose(values, allowed, rule.epsilon, trials.draws[trial, step])
        if action < 0:
            return DIVERGED
        led_to = graph.child[node, action]
        if not 0 <= led_to < len(graph.child):
            return UNKNOWN_OUTCOME
        done.action[trial, step], done.node[trial, step] = action, led_to
        node, inserted = graph.situation[led_to], graph.inserted[led_to]
        target = -1.0
        if not inserted and (rule.bootstrap or step + 1 < max_actions):
            follows = _values(memory, visual, graph.holding[node], rule.one_hot)
            target += rule.discount * _largest(follows, choices[graph.state[node]])
        error = target - values[action]
        if not np.isfinite(error):
            return DIVERGED
        _update(memory, action, holding, rule.step_size * error)
        if inserted:
            done.n_actions[trial], done.solved[trial] = step + 1, True
            break
    return DONE


@njit(nogil=True, cache=True)
def _choose(
    values: Floats, allowed: NDArray[np.bool_], epsilon: float, draw: Floats
) -> int:
    """The action that `LinearQ.choose` takes; -1 where the values are NaN."""
    explored, best = draw[0] < epsilon, _largest(values, allowed)
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


@njit(nogil=True, cache=True)
def _largest(values: Floats, allowed: NDArray[np.bool_]) -> float:
    """The largest value of the allowed actions, NaN if any is."""
    largest = -np.inf
    for action in range(N_ACTIONS):
        value = values[action]
        if allowed[action] and (value > largest or np.isnan(value)):
            largest = value
    return largest


@njit(nogil=True, cache=True)
def _values(memory: Memory, visual: Floats, holding: int, one_hot: bool) -> Floats:
    """The values (6,) of all actions in a haptic state."""
    if not memory.known[holding]:
        memory.known[holding] = True
        features = memory.features[holding]
        # As `StateFeatureGenerator` does it; whatever else there is stays zero.
        if holding == 0 or not one_hot:
            features[:N_BINS] = visual
        if holding:
            features[holding * N_BINS : (holding + 1) * N_BINS] = visual
            features[3 * N_BINS + holding - 1] = 1.0
        features[3 * N_BINS + 2] = 1.0
        for action in range(N_ACTIONS):
            memory.values[holding, action] = _product(memory, action, holding)
    return memory.values[holding]


@njit(nogil=True, cache=True)
def _update(memory: Memory, action: int, holding: int, change: float) -> None:
    """Add a multiple of the features to an action's weights."""
    weights, features = memory.weights[action], memory.features[holding]
    for part in range(len(PARTS)):
        if memory.busy[holding, part]:
            for index in range(*PARTS[part]):
                weights[index] += change * features[index]
    for state in range(3):
        if memory.known[state]:
            memory.values[state, action] = _product(memory, action, state)


@njit(nogil=True, cache=True)
def _product(memory: Memory, action: int, holding: int) -> float:
    """theta_a . phi, added up in the order of `np.sum`.

    NumPy adds 303 numbers pairwise, down to four parts; within a part in eight lanes,
    and the seven that are left over in the last one at the end.
    """
    theta, phi = memory.weights[action], memory.features[holding]
    busy = memory.busy[holding]
    first = _lanes(theta, phi, *PARTS[0], busy[0])
    second = _lanes(theta, phi, *PARTS[1], busy[1])
    third = _lanes(theta, phi, *PARTS[2], busy[2])
    fourth = _lanes(theta, phi, *PARTS[3], busy[3])
    for index in range(*PARTS[4]):
        fourth += theta[index] * phi[index]
    return (first + second) + (third + fourth)


@njit(nogil=True, cache=True)
def _lanes(theta: Floats, phi: Floats, begin: int, end: int, busy: bool) -> float:
    """Eight sums side by side, added up at the end."""
    if not busy:
        return 0.0
    s0 = s1 = s2 = s3 = s4 = s5 = s6 = s7 = 0.0
    for i in range(begin, end, 8):
        s0 += theta[i] * phi[i]
        s1 += theta[i + 1] * phi[i + 1]
        s2 += theta[i + 2] * phi[i + 2]
        s3 += theta[i + 3] * phi[i + 3]
        s4 += theta[i + 4] * phi[i + 4]
        s5 += theta[i + 5] * phi[i + 5]
        s6 += theta[i + 6] * phi[i + 6]
        s7 += theta[i + 7] * phi[i + 7]
    return ((s0 + s1) + (s2 + s3)) + ((s4 + s5) + (s6 + s7))
