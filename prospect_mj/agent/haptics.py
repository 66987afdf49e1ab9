"""Numbering of the haptic states, with and without categories of grasps.

Without categories (K = 0) a state says which hand holds the jar: 0 none, 1 left,
2 right. With K categories it says of what kind the grasp is as well:
1 + hand K + category, where the hand is 0 (left) or 1 (right).

The linear features have a bit for each hand and for each category, (h_L, h_R, c_1, ...,
c_K), and phi = (v, v x each bit, the bits, 1) with the histogram v of 100 bins.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from prospect_mj.errors import InvalidValue

N_BINS = 100
"""Of the histogram."""
NONE, LEFT, RIGHT = 0, 1, 2
"""What holds the jar."""
N_HOLDINGS = 3


def n_haptic(categories: int) -> int:
    """Number of haptic states with K = `categories`."""
    return N_HOLDINGS if categories == 0 else 1 + 2 * categories


def n_features(categories: int) -> int:
    """Length of phi with K = `categories`: 100 (3 + K) + 3 + K; 303 without."""
    return (N_BINS + 1) * (3 + categories)


def haptic_state(holding: int, category: int, categories: int) -> int:
    """Number of a haptic state.

    Args:
        holding: `NONE`, `LEFT` or `RIGHT`.
        category: of the grasp, from 0; without meaning where there are none.
        categories: K.
    """
    if holding == NONE or categories == 0:
        return holding
    return 1 + (holding - LEFT) * categories + category


def haptic_states(
    holding: ArrayLike, category: ArrayLike, categories: int
) -> NDArray[np.int64]:
    """(n,): the same of many states; `holding` and `category` are (n,)."""
    held = np.array(holding, np.int64)
    if categories == 0:
        return held
    states = 1 + (held - LEFT) * categories + np.asarray(category)
    return np.where(held == NONE, NONE, states)


def holding_of(haptic: int, categories: int) -> int:
    """What holds the jar in a haptic state: `NONE`, `LEFT` or `RIGHT`."""
    if haptic == NONE or categories == 0:
        return haptic
    return LEFT + (haptic - 1) // categories


def categories_of(n_states: int) -> int:
    """K, of which there are so many haptic states: the inverse of `n_haptic`."""
    return 0 if n_states == N_HOLDINGS else (n_states - 1) // 2


def categories_of_features(length: int) -> int:
    """K, with which phi is of a length: the inverse of `n_features`.

    Raises:
        InvalidValue: if no number of categories makes features of this length.
    """
    categories, left_over = divmod(length - n_features(0), N_BINS + 1)
    if categories < 0 or left_over:
        expected = f"{n_features(0)}, and {N_BINS + 1} more for each haptic category"
        raise InvalidValue("number of features", length, expected)
    return categories


def haptic_bits(categories: int) -> NDArray[np.bool_]:
    """(h, 2 + K): the bits of every haptic state, those of the hands first."""
    n_states = n_haptic(categories)
    bits = np.zeros((n_states, 2 + categories), np.bool_)
    for state in range(1, n_states):
        bits[state, holding_of(state, categories) - LEFT] = True
        if categories:
            bits[state, 2 + (state - 1) % categories] = True
    return bits
