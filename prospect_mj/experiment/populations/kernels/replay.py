"""The twin of `agent.ReplayQ`.

The features of a picture are written once, as its transitions come back again and
again; values are not kept, as every transition that is replayed changes them.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

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
from prospect_mj.experiment.populations.kernels.linear import fill_features
from prospect_mj.experiment.populations.kernels.ring import Ring, draw, forget, remember
from prospect_mj.experiment.populations.kernels.sums import Order, add, product
from prospect_mj.experiment.populations.kernels.walk import (
    Walk,
    begin,
    largest,
    new_walk,
    take,
)

Floats = NDArray[np.float64]


class ReplayState(NamedTuple):
    """What the learner has learned and remembers.

    h haptic states; n features of K categories.
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
    """phi, (n_images, h, n)."""
    known: NDArray[np.bool_]
    """(n_images,): whether the features of a picture have been written."""
    values: Floats
    """(6,) [actions], room for those of all actions."""
    ring: Ring
    """Transitions; what they show are numbers of pictures."""


@kept
def run(
    state: ReplayState,
    graph: Graph,
    trials: Trials,
    rule: Rule,
    outcomes: Outcomes,
    rng: np.random.Generator,
) -> tuple[int, int]:
    """Learn from every trial in turn; see `kernels`."""
    walk = new_walk()
    for trial in range(len(trials.root)):
        ended = _run_trial(state, walk, graph, trials, rule, outcomes, rng, trial)
        if ended != DONE:
            return ended, trial
    return DONE, len(trials.root)


@uncounted
def _run_trial(
    state: ReplayState,
    walk: Walk,
    graph: Graph,
    trials: Trials,
    rule: Rule,
    outcomes: Outcomes,
    rng: np.random.Generator,
    trial: int,
) -> int:
    values, image = state.values, trials.image[trial]
    _see(state, image, trials.visual[image], rule.one_hot)
    node = begin(walk, graph, trials, rule, trial)
    for step in range(trials.draws.shape[1]):
        haptic = graph.haptic[node]
        for action in range(N_ACTIONS):
            values[action] = _product(state, action, image, haptic)
        taken = take(walk, graph, trials, rule, outcomes, values, node, trial, step)
        if taken.ended != DONE:
            return taken.ended
        node, ended = taken.node, taken.terminated
        follows = graph.haptic[node]
        place = remember(
            state.ring, image, haptic, taken.action, follows, ended, walk.allowed
        )
        sound = _learn(state, place, rule.discount)
        forget(state.ring, place)
        draw(state.ring, rng)
        for again in state.ring.drawn:
            sound &= _learn(state, again, rule.discount)
        if not sound:
            return DIVERGED
        if taken.inserted:
            break
    return DONE


@uncounted
def _see(state: ReplayState, image: int, visual: Floats, one_hot: bool) -> None:
    """Write the features of a picture, unless they have been."""
    if not state.known[image]:
        state.known[image] = True
        for haptic in range(len(state.bits)):
            phi = state.features[image, haptic]
            fill_features(phi, visual, state.bits[haptic], one_hot)


@uncounted
def _learn(state: ReplayState, place: int, discount: float) -> bool:
    """Learn from a remembered transition; whether the error is a finite number."""
    ring = state.ring
    image, haptic = ring.shown[place], ring.haptic[place]
    action, target = ring.action[place], -1.0
    if not ring.terminated[place]:
        for after in range(N_ACTIONS):
            if ring.allowed[place, after]:
                follows = ring.follows[place]
                state.values[after] = _product(state, after, image, follows)
        best = largest(state.values, ring.allowed[place])
        target += discount * best
    error = target - _product(state, action, image, haptic)
    phi, change = state.features[image, haptic], state.step_size * error
    add(state.weights[action], change, phi, state.order, state.spans[haptic])
    return np.isfinite(error)


@uncounted
def _product(state: ReplayState, action: int, image: int, haptic: int) -> float:
    """theta_a . phi of a picture in a haptic state."""
    theta, phi = state.weights[action], state.features[image, haptic]
    return product(theta, phi, state.order, state.spans[haptic])
