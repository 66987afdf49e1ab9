"""What the compiled discovery learner works on: the readable one's arrays, and room."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from prospect_mj.agent.discovery.contexts import Contexts
from prospect_mj.agent.discovery.examples import Examples

Floats = NDArray[np.float64]
Whole = NDArray[np.int64]


class Options(NamedTuple):
    """`DiscoverySettings`, as the compiled code takes them."""

    least_rate: float
    surprise: float
    guard_scale: float
    """Of `required_distance`."""
    candidates: int
    reuse: bool
    search_after_first: bool
    expert_phase: bool
    inherits: bool
    """Whether leaves inherit the value that was there before a split."""
    stored: bool
    """Whether leaves are estimated from targets as they were at the time."""
    by_return: bool
    """Whether an outcome is judged by all that the rest of its trial brought."""
    caches_all: bool
    share_first: bool
    is_forced: bool
    """Whether there are forced splits."""


class Visits(NamedTuple):
    """First visits of contexts in a trial, in their order: as `discoverer.Visit`."""

    context: Whole
    """(h 6, 2)."""
    leaf: Whole
    """(h 6,)."""
    predicted: Floats
    """(h 6,) [actions]."""
    mean_before: Floats
    """(h 6,) [actions]."""
    target: Floats
    """(h 6,) [actions]."""
    step: Whole
    """(h 6,)."""
    next_haptic: Whole
    """(h 6,)."""
    terminated: NDArray[np.bool_]
    """(h 6,)."""
    allowed: NDArray[np.bool_]
    """(h 6, 6)."""


class PresentTrial(NamedTuple):
    """What is known of the present trial."""

    picture: Floats
    """c, (101,) [1], the cumulative histogram."""
    orientation: Whole
    """(1,): side of the lid where splits are forced, else NOT_READ."""
    leaf: Whole
    """(h, 6): the leaf of each context that the picture is in, or WHOLE."""
    is_visited: NDArray[np.bool_]
    """(h, 6)."""
    values: Floats
    """(6,) [actions], room for those in a haptic state."""
    strengths: Floats
    """(2, memory) [1], room for those of a feature in either class."""


class DiscoveryState(NamedTuple):
    """All of it."""

    contexts: Contexts
    examples: Examples
    forced_after: Whole
    """(h, 6): the trial after which a context is split by force; -1: after none."""
    options: Options
    visits: Visits
    sight: PresentTrial
    n_trials: Whole
    """(1,): trials that have ended."""
