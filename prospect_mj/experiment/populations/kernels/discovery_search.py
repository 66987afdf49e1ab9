"""The twin of `agent.discovery`'s `feature`, `detector` and `search`."""

from typing import NamedTuple

import numpy as np
from numba import njit
from numpy.typing import NDArray

from prospect_mj.agent.discovery.contexts import Contexts
from prospect_mj.agent.discovery.detector import BETTER, WORSE
from prospect_mj.agent.discovery.examples import Examples
from prospect_mj.agent.discovery.feature import N_LEVELS, WIDTHS
from prospect_mj.agent.features import N_BINS
from prospect_mj.experiment.populations.kernels import cache
from prospect_mj.experiment.populations.kernels.discovery_state import (
    DiscoveryState,
    Floats,
)
from prospect_mj.experiment.populations.kernels.graph import N_ACTIONS

Ranges = tuple[int, int, int, int]


class FoundDetector(NamedTuple):
    """A detector, as `detector.Detector`, the counts by class."""

    ranges: Ranges
    cut: float
    distance: float
    present: tuple[int, int]
    total: tuple[int, int]


@cache.called
def measure(ranges: Ranges, picture: Floats) -> float:
    """How strong a feature is."""
    begin, end, less_begin, less_end = ranges
    more = picture[end] - picture[begin]
    return more - (picture[less_end] - picture[less_begin])


@cache.called
def ranges_of(contexts: Contexts, haptic: int, action: int, slot: int) -> Ranges:
    """The feature of a context's detector."""
    ranges = contexts.ranges[haptic, action, slot]
    return ranges[0], ranges[1], ranges[2], ranges[3]


@cache.called
def number(examples: Examples, haptic: int, action: int, kind: int) -> int:
    """Examples of a class that are remembered."""
    return min(examples.added[haptic, action, kind], examples.target.shape[3])


@cache.called
def required(state: DiscoveryState, haptic: int, action: int) -> float:
    """The distance that counts in a context; 1 or more with too few examples."""
    n_worse = number(state.examples, haptic, action, WORSE)
    n_better = number(state.examples, haptic, action, BETTER)
    if min(n_worse, n_better) < 2:
        return np.inf
    size = np.sqrt((n_worse + n_better) / (n_worse * n_better))
    return state.options.guard_scale * size


@cache.called
def detect(
    state: DiscoveryState, haptic: int, action: int, ranges: Ranges
) -> FoundDetector:
    """A feature with the best cut-point for a context's examples."""
    examples, strengths = state.examples, state.sight.strengths
    total = (
        number(examples, haptic, action, WORSE),
        number(examples, haptic, action, BETTER),
    )
    for kind in range(2):
        pictures = examples.picture[haptic, action, kind]
        for place in range(total[kind]):
            _insert(strengths[kind], place, measure(ranges, pictures[place]))
    worse, better = strengths[WORSE, : total[WORSE]], strengths[BETTER, : total[BETTER]]
    distance, cut = separation(worse, better)
    present = _above(worse, cut), _above(better, cut)
    return FoundDetector(ranges, cut, distance, present, total)


@cache.called
def separation(worse: Floats, better: Floats) -> tuple[float, float]:
    """Distance of Kolmogorov and Smirnov, and cut-point, of two sorted samples."""
    m, n = len(worse), len(better)
    i = j = widest = 0
    level, cut = min(worse[0], better[0]), min(worse[0], better[0])
    while i < m and j < n:
        level = min(worse[i], better[j])
        while i < m and worse[i] == level:
            i += 1
        while j < n and better[j] == level:
            j += 1
        gap = abs(j * m - i * n)
        if gap > widest:
            widest = gap
            following = np.inf
            if i < m:
                following = worse[i]
            if j < n:
                following = min(following, better[j])
            cut = (level + following) / 2.0
    # Where one sample has ended, the gap only narrows.
    return widest / (m * n), cut


@cache.called
def draw(rng: np.random.Generator) -> Ranges:
    """Draw a new feature."""
    kind = _below(N_LEVELS, rng)
    if kind == 0:
        begin = _below(N_BINS, rng)
        return begin, begin + 1, 0, 0
    begin, end = _draw_range(rng)
    if kind == N_LEVELS - 1:
        less_begin, less_end = _draw_range(rng)
        return begin, end, less_begin, less_end
    return begin, end, 0, 0


@cache.called
def explanation(
    state: DiscoveryState,
    haptic: int,
    action: int,
    kind: int,
    least: float,
    rng: np.random.Generator,
) -> tuple[bool, FoundDetector]:
    """The best detector that puts the trial's picture into its class, if any does."""
    contexts, picture = state.contexts, state.sight.picture
    is_found, best = False, FoundDetector((0, 0, 0, 0), 0.0, least, (0, 0), (0, 0))
    if state.options.reuse:
        for h in range(contexts.mean.shape[0]):
            for a in range(N_ACTIONS):
                for slot in range(contexts.n_detectors[h, a]):
                    if (h == haptic and a == action) or contexts.lent[h, a]:
                        continue
                    ranges = ranges_of(contexts, h, a, slot)
                    if not _has(contexts, haptic, action, ranges):
                        one = detect(state, haptic, action, ranges)
                        if _is_better(one, best, picture, kind):
                            is_found, best = True, one
    if not is_found:
        for _ in range(state.options.candidates):
            one = detect(state, haptic, action, draw(rng))
            if _is_better(one, best, picture, kind):
                is_found, best = True, one
    return is_found, best


@cache.called
def put(
    contexts: Contexts, haptic: int, action: int, slot: int, one: FoundDetector
) -> None:
    """Write a detector into a slot of a context."""
    for place in range(4):
        contexts.ranges[haptic, action, slot, place] = one.ranges[place]
    contexts.cut[haptic, action, slot] = one.cut
    contexts.distance[haptic, action, slot] = one.distance
    for kind in range(2):
        contexts.present[haptic, action, slot, kind] = one.present[kind]
        contexts.total[haptic, action, slot, kind] = one.total[kind]


@cache.called
def _is_better(
    one: FoundDetector, best: FoundDetector, picture: Floats, kind: int
) -> bool:
    """Whether a detector is further apart, and puts a picture into its class."""
    if one.distance <= best.distance:
        return False
    is_there = measure(one.ranges, picture) > one.cut
    likelihood = _likelihood(one, WORSE, is_there), _likelihood(one, BETTER, is_there)
    return (likelihood[BETTER] > likelihood[WORSE]) == (kind == BETTER)


@cache.called
def _likelihood(one: FoundDetector, kind: int, is_there: bool) -> float:
    hits = one.present[kind] if is_there else one.total[kind] - one.present[kind]
    return (hits + 1) / (one.total[kind] + 2)


@cache.called
def _has(contexts: Contexts, haptic: int, action: int, ranges: Ranges) -> bool:
    """Whether a context has a feature of its own that is the same."""
    if contexts.lent[haptic, action]:
        return False
    for slot in range(contexts.n_detectors[haptic, action]):
        if ranges_of(contexts, haptic, action, slot) == ranges:
            return True
    return False


@cache.called
def _insert(ordered: Floats, place: int, strength: float) -> None:
    """Put a number into the first `place` ones, which are in ascending order."""
    while place > 0 and ordered[place - 1] > strength:
        ordered[place] = ordered[place - 1]
        place -= 1
    ordered[place] = strength


@cache.called
def _above(ordered: NDArray[np.float64], cut: float) -> int:
    """How many of ascending numbers are above another one."""
    n = 0
    while n < len(ordered) and ordered[len(ordered) - 1 - n] > cut:
        n += 1
    return n


@cache.called
def _draw_range(rng: np.random.Generator) -> tuple[int, int]:
    width = WIDTHS[0] + _below(WIDTHS[1] - WIDTHS[0] + 1, rng)
    begin = _below(N_BINS - width + 1, rng)
    return begin, begin + width


# With reference counts, without which numba compiles no generator.
@njit(nogil=True, _nrt=True)
def _below(end: int, rng: np.random.Generator) -> int:
    """A whole number from 0, below another one."""
    return rng.integers(0, end)
