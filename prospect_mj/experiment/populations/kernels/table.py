"""The twin of `agent.TableQ`."""

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
from prospect_mj.experiment.populations.kernels.ring import Ring, draw, forget, remember
from prospect_mj.experiment.populations.kernels.walk import (
    Walk,
    begin,
    largest,
    new_walk,
    take,
)

Floats = NDArray[np.float64]


class TableState(NamedTuple):
    """What the learner has learned and remembers, in h haptic states."""

    values: Floats
    """Q, (2, h, 6) [actions], by the orientation first."""
    step_size: float
    """alpha [1]."""
    seen: NDArray[np.bool_]
    """(2,): the orientations that it has learned from."""
    copies: bool
    """Whether a new orientation has a copy of the other one's values."""
    mended: Floats
    """(2, h, 6) [actions]: values known beforehand in a copy; NaN where none is."""
    ring: Ring
    """Transitions; what they show are orientations. Empty without replays."""


@kept
def run(
    state: TableState,
    graph: Graph,
    trials: Trials,
    rule: Rule,
    outcomes: Outcomes,
    rng: np.random.Generator,
) -> tuple[int, int]:
    """Learn from every trial in turn; see `kernels`."""
    walk = new_walk()
    for trial in range(len(trials.root)):
        _meet(state, trials.orientation[trial])
        ended = _run_trial(state, walk, graph, trials, rule, outcomes, rng, trial)
        if ended != DONE:
            return ended, trial
    return DONE, len(trials.root)


@uncounted
def _run_trial(
    state: TableState,
    walk: Walk,
    graph: Graph,
    trials: Trials,
    rule: Rule,
    outcomes: Outcomes,
    rng: np.random.Generator,
    trial: int,
) -> int:
    side = trials.orientation[trial]
    node = begin(walk, graph, trials, rule, trial)
    for step in range(trials.draws.shape[1]):
        haptic = graph.haptic[node]
        values = state.values[side, haptic]
        taken = take(walk, graph, trials, rule, outcomes, values, node, trial, step)
        if taken.ended != DONE:
            return taken.ended
        node, action, ended = taken.node, taken.action, taken.terminated
        follows, allowed = graph.haptic[node], walk.allowed
        error = _learn(state, rule, side, haptic, action, follows, ended, allowed)
        if not np.isfinite(error):
            return DIVERGED
        if len(state.ring.drawn):
            place = remember(state.ring, side, haptic, action, follows, ended, allowed)
            forget(state.ring, place)
            _replay(state, rule, rng)
        if taken.inserted:
            break
    return DONE


@uncounted
def _meet(state: TableState, side: int) -> None:
    """Begin a trial: an orientation never seen may have the other one's values."""
    if state.copies and not state.seen[side] and state.seen[1 - side]:
        for haptic in range(state.values.shape[1]):
            for action in range(N_ACTIONS):
                value = state.mended[side, haptic, action]
                if np.isnan(value):
                    value = state.values[1 - side, haptic, action]
                state.values[side, haptic, action] = value
    state.seen[side] = True


@uncounted
def _replay(state: TableState, rule: Rule, rng: np.random.Generator) -> None:
    """Learn from remembered transitions again."""
    ring = state.ring
    draw(ring, rng)
    for place in ring.drawn:
        _learn(
            state,
            rule,
            ring.shown[place],
            ring.haptic[place],
            ring.action[place],
            ring.follows[place],
            ring.terminated[place],
            ring.allowed[place],
        )


@uncounted
def _learn(
    state: TableState,
    rule: Rule,
    side: int,
    haptic: int,
    action: int,
    follows: int,
    terminated: bool,
    allowed: NDArray[np.bool_],
) -> float:
    """Move one value; give the error before."""
    target = -1.0
    if not terminated:
        target += rule.discount * largest(state.values[side, follows], allowed)
    error = target - state.values[side, haptic, action]
    state.values[side, haptic, action] += state.step_size * error
    return error
