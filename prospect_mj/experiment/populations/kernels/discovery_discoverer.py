"""The twin of `agent.discovery.discoverer`: what is made of a surprise."""

import numpy as np

from prospect_mj.agent.discovery.contexts import WHOLE, Contexts
from prospect_mj.agent.discovery.detector import BETTER, WORSE
from prospect_mj.agent.discovery.search import KEPT
from prospect_mj.agent.features import N_BINS
from prospect_mj.experiment.populations.kernels import cache
from prospect_mj.experiment.populations.kernels.discovery_search import (
    FoundDetector,
    detect,
    draw,
    explanation,
    put,
    ranges_of,
    required,
)
from prospect_mj.experiment.populations.kernels.discovery_state import DiscoveryState
from prospect_mj.experiment.populations.kernels.discovery_values import (
    leaf_of,
    lend,
    split,
)
from prospect_mj.experiment.populations.kernels.graph import N_ACTIONS


@cache.called
def consider(
    state: DiscoveryState,
    discount: float,
    visit: int,
    outcome: float,
    rng: np.random.Generator,
) -> None:
    """Remember a visit if it is telling; explain it if it is a surprise."""
    options, visits = state.options, state.visits
    haptic, action = visits.context[visit, 0], visits.context[visit, 1]
    mean = visits.mean_before[visit]
    kind = BETTER if outcome > mean else WORSE
    if options.caches_all or abs(outcome - mean) > options.surprise / 2.0:
        _remember(state, visit, kind)
    if options.is_forced:
        return
    least = required(state, haptic, action)
    if least >= 1.0:
        return
    if abs(outcome - visits.predicted[visit]) > options.surprise:
        if _is_puzzling(state, haptic, action, kind, least):
            found, one = explanation(state, haptic, action, kind, least, rng)
            if found:
                _adopt(state, haptic, action, one, discount)
    elif options.expert_phase:
        _refine(state, haptic, action, least, discount, rng)


@cache.called
def _remember(state: DiscoveryState, visit: int, kind: int) -> None:
    """Put an example in the place of the oldest one."""
    examples, visits, sight = state.examples, state.visits, state.sight
    haptic, action = visits.context[visit, 0], visits.context[visit, 1]
    place = examples.added[haptic, action, kind] % examples.target.shape[3]
    for level in range(N_BINS + 1):
        examples.picture[haptic, action, kind, place, level] = sight.picture[level]
    examples.orientation[haptic, action, kind, place] = sight.orientation[0]
    examples.reward[haptic, action, kind, place] = -1.0
    examples.next_haptic[haptic, action, kind, place] = visits.next_haptic[visit]
    examples.terminated[haptic, action, kind, place] = visits.terminated[visit]
    for other in range(N_ACTIONS):
        allowed = visits.allowed[visit, other]
        examples.allowed[haptic, action, kind, place, other] = allowed
    examples.target[haptic, action, kind, place] = visits.target[visit]
    examples.added[haptic, action, kind] += 1


@cache.called
def _is_puzzling(
    state: DiscoveryState, haptic: int, action: int, kind: int, least: float
) -> bool:
    """Whether another detector is to be sought, those there by today's examples."""
    contexts, options = state.contexts, state.options
    if contexts.lent[haptic, action]:
        return not options.inherits
    kept = 0
    for slot in range(contexts.n_detectors[haptic, action]):
        one = detect(state, haptic, action, ranges_of(contexts, haptic, action, slot))
        if one.distance >= KEPT * least:
            put(contexts, haptic, action, kept, one)
            kept += 1
    contexts.n_detectors[haptic, action] = kept
    leaf = leaf_of(contexts, haptic, action, state.sight.picture, 0)
    return leaf == WHOLE or (leaf != kind and options.search_after_first)


@cache.called
def _refine(
    state: DiscoveryState,
    haptic: int,
    action: int,
    least: float,
    discount: float,
    rng: np.random.Generator,
) -> None:
    """The expert phase: where nothing is wrong, more is required."""
    contexts, best = state.contexts, -1.0
    n_own = contexts.n_detectors[haptic, action]
    if contexts.lent[haptic, action] or n_own == 0:
        return
    for slot in range(n_own):
        best = max(best, contexts.distance[haptic, action, slot])
    least = max(least, (best + 1.0) / 2.0)
    if least < 1.0:
        one = detect(state, haptic, action, draw(rng))
        if one.distance > least:
            _adopt(state, haptic, action, one, discount)


@cache.called
def _adopt(
    state: DiscoveryState, haptic: int, action: int, one: FoundDetector, discount: float
) -> None:
    """Split a context by a detector, too; the weakest gives way if need be."""
    contexts = state.contexts
    is_lent = contexts.lent[haptic, action]
    n_own = 0 if is_lent else contexts.n_detectors[haptic, action]
    slot = n_own
    if n_own == contexts.cut.shape[2]:
        slot = 0
        for other in range(1, n_own):
            distance = contexts.distance[haptic, action, other]
            if distance < contexts.distance[haptic, action, slot]:
                slot = other
        if one.distance <= contexts.distance[haptic, action, slot]:
            return
    is_first = not _is_any_split(contexts)
    put(contexts, haptic, action, slot, one)
    contexts.n_detectors[haptic, action] = max(n_own, slot + 1)
    split(state, haptic, action, n_own > 0, discount)
    if is_first and state.options.share_first:
        lend(state, haptic, action, one)


@cache.called
def _is_any_split(contexts: Contexts) -> bool:
    """Whether any context was ever split."""
    for haptic in range(contexts.mean.shape[0]):
        for action in range(N_ACTIONS):
            if contexts.first_split[haptic, action] >= 0:
                return True
    return False
