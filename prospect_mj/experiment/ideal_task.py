"""The learner on ideal outcomes, compiled: whole runs from a bank of histograms.

Every action that can succeed does: the jar is taken by either hand when none holds it,
passed on by the hand that holds it, and inserted by the hand on the lid's side; all
else changes nothing. The learner is `LinearQ` exactly, given the same random numbers;
it skips the zeros of the feature vector.
"""

from typing import NamedTuple

import numpy as np
from numba import njit
from numpy.typing import NDArray

from prospect_mj.agent.features import N_BINS, N_FEATURES
from prospect_mj.agent.settings import LearnerSettings
from prospect_mj.errors import InvalidValue
from prospect_mj.experiment.records import ACTION_NAMES

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]

N_ACTIONS = len(ACTION_NAMES)
# Hands as the kernel counts them; the same numbers stand for the lid's side.
NONE, LEFT, RIGHT = 0, 1, 2


class Trials(NamedTuple):
    """What a run's trials present, and the random numbers the learner uses in them."""

    histograms: Floats
    """(n_trials, 100) [1], scaled."""
    lid_sides: Integers
    """(n_trials,), LEFT or RIGHT."""
    draws: Floats
    """(n_trials, max_actions, 2), uniform on [0, 1): the two of `LinearQ.choose`."""


def run_trials(
    weights: Floats,
    trials: Trials,
    settings: LearnerSettings,
    one_hot: bool = False,
    bootstrap_at_truncation: bool = True,
) -> Integers:
    """Learn from every trial in turn.

    Args:
        weights: theta, (6, 303), updated in place.
        trials: what is presented.
        settings: the learner's; a frozen greedy policy has no step size and epsilon,
            see `run_frozen`.
        one_hot: the reading of the features (see `agent.features`).
        bootstrap_at_truncation: whether a cut-off trial's last action counts what
            would follow.

    Returns:
        (n_trials,) [actions], one more than the longest trial where the jar was never
        inserted.
    """
    _check_shapes(weights, trials)
    return _run(
        weights,
        *trials,
        settings.step_size,
        settings.epsilon,
        settings.discount,
        one_hot,
        bootstrap_at_truncation,
    )


def run_frozen(weights: Floats, trials: Trials, one_hot: bool = False) -> Integers:
    """Follow the greedy policy without learning; arguments and result as above."""
    _check_shapes(weights, trials)
    return _run(weights, *trials, 0.0, 0.0, 0.0, one_hot, False)


def capped(n_actions: Integers, max_actions: int) -> Integers:
    """Actions taken per trial, solved or not."""
    return np.minimum(n_actions, max_actions)


def _check_shapes(weights: Floats, trials: Trials) -> None:
    """Refuse arrays that the compiled code would read beyond their end."""
    n_trials, max_actions = trials.draws.shape[:2]
    for what, array, shape in (
        ("weights' shape", weights, (N_ACTIONS, N_FEATURES)),
        ("histograms' shape", trials.histograms, (n_trials, N_BINS)),
        ("lid sides' shape", trials.lid_sides, (n_trials,)),
        ("draws' shape", trials.draws, (n_trials, max_actions, 2)),
    ):
        if array.shape != shape:
            raise InvalidValue(what, array.shape, str(shape))


@njit(nogil=True, cache=True)
def _run(
    weights: Floats,
    histograms: Floats,
    lid_sides: Integers,
    draws: Floats,
    step_size: float,
    epsilon: float,
    discount: float,
    one_hot: bool,
    bootstrap: bool,
) -> Integers:
    n_trials, max_actions, _ = draws.shape
    n_taken = np.full(n_trials, max_actions + 1)
    for trial in range(n_trials):
        visual, holding = histograms[trial], NONE
        values = _q_values(weights, visual, holding, one_hot)
        for step in range(max_actions):
            action = _choose(values, epsilon, draws[trial, step])
            reached, inserted = _outcome(holding, action, lid_sides[trial])
            next_values = _q_values(weights, visual, reached, one_hot)
            target = -1.0
            if not inserted and (bootstrap or step + 1 < max_actions):
                target += discount * next_values.max()
            change = step_size * (target - values[action])
            _add(weights[action], change, visual, holding, one_hot)
            if inserted:
                n_taken[trial] = step + 1
                break
            holding = reached
            values = _q_values(weights, visual, holding, one_hot)
    return n_taken


@njit(nogil=True, cache=True)
def _outcome(holding: int, action: int, lid_side: int) -> tuple[int, bool]:
    """The hand that holds the jar afterwards, and whether the jar is inserted."""
    if action <= 1:
        return (action + LEFT if holding == NONE else holding), False
    if action == 2:
        return (RIGHT if holding == LEFT else holding), False
    if action == 3:
        return (LEFT if holding == RIGHT else holding), False
    hand = action - 4 + LEFT
    return holding, holding == hand and hand == lid_side


@njit(nogil=True, cache=True)
def _choose(values: Floats, epsilon: float, draw: Floats) -> int:
    explored = draw[0] < epsilon
    best = values.max()
    n_candidates = 0
    for value in values:
        n_candidates += explored or value == best
    number = int(draw[1] * n_candidates)
    for action in range(len(values)):
        if explored or values[action] == best:
            if number == 0:
                return action
            number -= 1
    return -1


@njit(nogil=True, cache=True)
def _q_values(weights: Floats, visual: Floats, holding: int, one_hot: bool) -> Floats:
    values = weights[:, N_FEATURES - 1].copy()
    if holding != NONE:
        values += weights[:, 3 * N_BINS + holding - 1]
    for block in range(3):
        if _is_active(block, holding, one_hot):
            for action in range(len(values)):
                for index in range(N_BINS):
                    weight = weights[action, block * N_BINS + index]
                    values[action] += weight * visual[index]
    return values


@njit(nogil=True, cache=True)
def _add(
    row: Floats, change: float, visual: Floats, holding: int, one_hot: bool
) -> None:
    """Add `change` times the feature vector to one action's weights."""
    row[N_FEATURES - 1] += change
    if holding != NONE:
        row[3 * N_BINS + holding - 1] += change
    for block in range(3):
        if _is_active(block, holding, one_hot):
            for index in range(N_BINS):
                row[block * N_BINS + index] += change * visual[index]


@njit(nogil=True, cache=True)
def _is_active(block: int, holding: int, one_hot: bool) -> bool:
    """Whether a block of the feature vector carries the histogram or zeros."""
    return block == holding or (block == 0 and not one_hot)
