"""Choosing among actions by their values, which every learner does alike."""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from prospect_mj.checks import check_integer
from prospect_mj.errors import InvalidValue


class Choice(NamedTuple):
    """An action and how it came to be chosen."""

    action: int
    """Index in [0, n_actions)."""
    explored: bool
    """True if the epsilon draw asked for a random action."""
    q_values: NDArray[np.float64]
    """(n_actions,) [actions], the estimates at the time of the choice."""


def epsilon_greedy(
    q_values: NDArray[np.float64],
    epsilon: float,
    rng: np.random.Generator,
    allowed: ArrayLike | None = None,
) -> Choice:
    """Choose an action epsilon-greedily and tell how.

    Exactly two numbers u1, u2 are drawn by `rng.random()`, in this order. The
    candidates are the allowed actions if u1 < epsilon, else those of them with the
    largest value; the action is number floor(u2 n) of the n candidates in ascending
    order. So ties are broken at random, and an implementation given the same numbers
    makes the same choices.

    Args:
        q_values: (n_actions,) [actions].
        epsilon: probability of a random action.
        rng: source of the two numbers.
        allowed: (n_actions,) true where an action may be chosen; None allows all.
    """
    candidates = allowed_actions(allowed, len(q_values))
    explore_draw, candidate_draw = rng.random(), rng.random()
    explored = explore_draw < epsilon
    if not explored:
        values = q_values[candidates]
        candidates = candidates[values == values.max()]
    action = int(candidates[int(candidate_draw * len(candidates))])
    return Choice(action, explored, q_values)


def allowed_actions(allowed: ArrayLike | None, n_actions: int) -> NDArray[np.intp]:
    """Indices of the allowed actions, ascending.

    Args:
        allowed: (n_actions,) true where an action may be chosen; None allows all.
        n_actions: of the learner.

    Raises:
        InvalidValue: if there is none, or it is a mask of other actions.
    """
    if allowed is None:
        return np.arange(n_actions)
    mask = np.asarray(allowed)
    if mask.shape != (n_actions,):
        raise InvalidValue("action mask shape", mask.shape, f"({n_actions},)")
    actions = np.flatnonzero(mask)
    if actions.size == 0:
        raise InvalidValue("action mask", mask.tolist(), "one action allowed")
    return actions


def checked_action(action: object, n_actions: int) -> int:
    """An action as Python's integer, in range.

    Raises:
        InvalidValue: if it is none of 0 to n_actions - 1.
    """
    # A negative index would silently count from the end.
    plain = int(action) if isinstance(action, np.integer) else action
    check_integer("action", plain, 0, n_actions - 1)
    return plain
