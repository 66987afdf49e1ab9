"""The twin of `agent.LinearQ`.

The picture stays for a whole trial: a value is computed anew when its weights have
changed.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from prospect_mj.agent.features import N_BINS
from prospect_mj.experiment.populations.kernels.cache import kept, uncounted
from prospect_mj.experiment.populations.kernels.graph import (
    DIVERGED,
    DONE,
    N_ACTIONS,
    Graph,
    Outcomes,
    Rule,
    Trials,
)
from prospect_mj.experiment.populations.kernels.sums import Order, add, product
from prospect_mj.experiment.populations.kernels.walk import (
    Walk,
    begin,
    largest,
    new_walk,
    take,
)

Floats = NDArray[np.float64]


class LinearState(NamedTuple):
    """What the learner has learned, and what is known of the present trial.

    Rows of h haptic states; n features of K categories.
    """

    weights: Floats
    """theta, (6, n)."""
    step_size: float
    """alpha [1]."""
    bits: NDArray[np.bool_]
    """(h, 2 + K): which haptic bits a state has."""
    order: Order
    """In which n numbers are added up."""
    spans: NDArray[np.int64]
    """(h, parts, 2): where phi has more than zeros in a part of `order`."""
    features: Floats
    """phi, (h, n); zero where no picture changes it."""
    values: Floats
    """(h, 6) [actions], theta phi."""
    known: NDArray[np.bool_]
    """(h,): whether features and values are those of the present trial."""


@kept
def run(
    state: LinearState,
    graph: Graph,
    trials: Trials,
    rule: Rule,
    outcomes: Outcomes,
    rng: np.random.Generator,
) -> tuple[int, int]:
    """Learn from every trial in turn; see `kernels`. Nothing is drawn."""
    walk = new_walk()
    for trial in range(len(trials.root)):
        state.known[:] = False
        ended = _run_trial(state, walk, graph, trials, rule, outcomes, trial)
        if ended != DONE:
            return ended, trial
    return DONE, len(trials.root)


@uncounted
def _run_trial(
    state: LinearState,
    walk: Walk,
    graph: Graph,
    trials: Trials,
    rule: Rule,
    outcomes: Outcomes,
    trial: int,
) -> int:
    visual = trials.visual[trials.image[trial]]
    node = begin(walk, graph, trials, rule, trial)
    for step in range(trials.draws.shape[1]):
        haptic = graph.haptic[node]
        _see(state, visual, haptic, rule.one_hot)
        values = state.values[haptic]
        taken = take(walk, graph, trials, rule, outcomes, values, node, trial, step)
        if taken.ended != DONE:
            return taken.ended
        node, target = taken.node, -1.0
        if not taken.terminated:
            follows = graph.haptic[node]
            _see(state, visual, follows, rule.one_hot)
            target += rule.discount * largest(state.values[follows], walk.allowed)
        error = target - values[taken.action]
        if not np.isfinite(error):
            return DIVERGED
        _update(state, taken.action, haptic, state.step_size * error)
        if taken.inserted:
            break
    return DONE


@uncounted
def _see(state: LinearState, visual: Floats, haptic: int, one_hot: bool) -> None:
    """Find features of, and values in, a haptic state, unless they are known."""
    if not state.known[haptic]:
        state.known[haptic] = True
        fill_features(state.features[haptic], visual, state.bits[haptic], one_hot)
        for action in range(N_ACTIONS):
            state.values[haptic, action] = _product(state, action, haptic)


@uncounted
def fill_features(
    features: Floats, visual: Floats, bits: NDArray[np.bool_], one_hot: bool
) -> None:
    """Write phi = (v, v x each bit, the bits, 1), as `agent.features` has it.

    Args:
        features: (n,); what a picture can't change in this state stays zero.
        visual: v, (100,).
        bits: (2 + K,).
        one_hot: whether v itself is there only without any bit.
    """
    n_bits, n_on = len(bits), 0
    for bit in range(n_bits):
        if bits[bit]:
            n_on += 1
            _write(features, (1 + bit) * N_BINS, visual)
            features[(1 + n_bits) * N_BINS + bit] = 1.0
    if not (one_hot and n_on):
        _write(features, 0, visual)
    features[-1] = 1.0


@uncounted
def _write(features: Floats, begins: int, visual: Floats) -> None:
    for index in range(N_BINS):
        features[begins + index] = visual[index]


@uncounted
def _update(state: LinearState, action: int, haptic: int, change: float) -> None:
    """Add a multiple of the features to an action's weights."""
    phi, spans = state.features[haptic], state.spans[haptic]
    add(state.weights[action], change, phi, state.order, spans)
    for other in range(len(state.known)):
        if state.known[other]:
            state.values[other, action] = _product(state, action, other)


@uncounted
def _product(state: LinearState, action: int, haptic: int) -> float:
    """theta_a . phi in a haptic state."""
    theta, phi = state.weights[action], state.features[haptic]
    return product(theta, phi, state.order, state.spans[haptic])
