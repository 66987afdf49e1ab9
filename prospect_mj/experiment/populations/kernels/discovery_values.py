"""The twin of `agent.discovery.values`: values looked up, contexts split."""

import numpy as np

from prospect_mj.agent.discovery.contexts import WHOLE, Contexts
from prospect_mj.agent.discovery.detector import BETTER, WORSE
from prospect_mj.experiment.populations.kernels import cache
from prospect_mj.experiment.populations.kernels.discovery_search import (
    FoundDetector,
    measure,
    number,
    put,
    ranges_of,
)
from prospect_mj.experiment.populations.kernels.discovery_state import (
    DiscoveryState,
    Floats,
)
from prospect_mj.experiment.populations.kernels.graph import N_ACTIONS


@cache.called
def leaf_of(
    contexts: Contexts, haptic: int, action: int, picture: Floats, orientation: int
) -> int:
    """The leaf that a picture falls into, or WHOLE, as `Contexts.leaf`."""
    if contexts.told[haptic, action]:
        return orientation
    if contexts.n_detectors[haptic, action] == 0:
        return WHOLE
    worse = better = 1.0
    for slot in range(contexts.n_detectors[haptic, action]):
        strength = measure(ranges_of(contexts, haptic, action, slot), picture)
        is_there = strength > contexts.cut[haptic, action, slot]
        total = contexts.total[haptic, action, slot]
        present = contexts.present[haptic, action, slot]
        hits = present[WORSE] if is_there else total[WORSE] - present[WORSE]
        worse *= (hits + 1) / (total[WORSE] + 2)
        hits = present[BETTER] if is_there else total[BETTER] - present[BETTER]
        better *= (hits + 1) / (total[BETTER] + 2)
    return BETTER if better > worse else WORSE


@cache.called
def value_of(contexts: Contexts, haptic: int, action: int, leaf: int) -> float:
    """The value of a leaf, the mean if WHOLE."""
    if leaf == WHOLE:
        return contexts.mean[haptic, action]
    return contexts.leaf_value[haptic, action, leaf]


@cache.called
def split(
    state: DiscoveryState, haptic: int, action: int, was_split: bool, discount: float
) -> None:
    """What follows when a context has got its detectors, or is told.

    Args:
        state: written to.
        haptic: with the action, the context.
        action: of it.
        was_split: whether it had detectors of its own, or was told, before.
        discount: gamma [1].
    """
    contexts = state.contexts
    contexts.told[haptic, action] = contexts.n_detectors[haptic, action] == 0
    contexts.lent[haptic, action] = False
    if contexts.first_split[haptic, action] < 0:
        contexts.first_split[haptic, action] = state.n_trials[0]
    if not was_split:
        _inherit(contexts, haptic, action)
    if not state.options.inherits:
        if not was_split:
            for leaf in range(2):
                contexts.leaf_count[haptic, action, leaf] = 0
        _revalue(state, haptic, action, discount)


@cache.called
def lend(state: DiscoveryState, haptic: int, action: int, found: FoundDetector) -> None:
    """Split all other contexts by the detector of one, values as they were."""
    contexts = state.contexts
    for h in range(contexts.mean.shape[0]):
        for a in range(N_ACTIONS):
            if h != haptic or a != action:
                put(contexts, h, a, 0, found)
                contexts.n_detectors[h, a] = 1
                contexts.lent[h, a] = True
                contexts.first_split[h, a] = state.n_trials[0]
                _inherit(contexts, h, a)


@cache.called
def learn(
    contexts: Contexts, haptic: int, action: int, leaf: int, target: float, least: float
) -> None:
    """Move the mean and the leaf's value towards a target, as `Contexts.learn`."""
    contexts.count[haptic, action] += 1
    rate = max(1.0 / contexts.count[haptic, action], least)
    mean = contexts.mean[haptic, action]
    contexts.mean[haptic, action] = mean + rate * (target - mean)
    if leaf != WHOLE:
        contexts.leaf_count[haptic, action, leaf] += 1
        rate = max(1.0 / contexts.leaf_count[haptic, action, leaf], least)
        before = contexts.leaf_value[haptic, action, leaf]
        contexts.leaf_value[haptic, action, leaf] = before + rate * (target - before)


@cache.called
def _inherit(contexts: Contexts, haptic: int, action: int) -> None:
    """Let both leaves be what the whole was."""
    for leaf in range(2):
        contexts.leaf_value[haptic, action, leaf] = contexts.mean[haptic, action]
        contexts.leaf_count[haptic, action, leaf] = contexts.count[haptic, action]


@cache.called
def _revalue(state: DiscoveryState, haptic: int, action: int, discount: float) -> None:
    """Let a leaf be the mean of its remembered examples, if it has any."""
    contexts, examples = state.contexts, state.examples
    worse = better = 0.0
    n_worse = n_better = 0
    for kind in range(2):
        for place in range(number(examples, haptic, action, kind)):
            picture = examples.picture[haptic, action, kind, place]
            orientation = examples.orientation[haptic, action, kind, place]
            leaf = leaf_of(contexts, haptic, action, picture, orientation)
            target = examples.target[haptic, action, kind, place]
            if not state.options.stored:
                target = _target(state, haptic, action, kind, place, discount)
            if leaf == WORSE:
                worse, n_worse = worse + target, n_worse + 1
            else:
                better, n_better = better + target, n_better + 1
    if n_worse:
        contexts.leaf_value[haptic, action, WORSE] = worse / n_worse
        contexts.leaf_count[haptic, action, WORSE] = n_worse
    if n_better:
        contexts.leaf_value[haptic, action, BETTER] = better / n_better
        contexts.leaf_count[haptic, action, BETTER] = n_better


@cache.called
def _target(
    state: DiscoveryState,
    haptic: int,
    action: int,
    kind: int,
    place: int,
    discount: float,
) -> float:
    """What an example brings by the values of today."""
    contexts, examples = state.contexts, state.examples
    reward = examples.reward[haptic, action, kind, place]
    if examples.terminated[haptic, action, kind, place]:
        return reward
    picture = examples.picture[haptic, action, kind, place]
    orientation = examples.orientation[haptic, action, kind, place]
    follows, best = examples.next_haptic[haptic, action, kind, place], -np.inf
    for other in range(N_ACTIONS):
        if examples.allowed[haptic, action, kind, place, other]:
            leaf = leaf_of(contexts, follows, other, picture, orientation)
            best = max(best, value_of(contexts, follows, other, leaf))
    return reward + discount * best
