"""The latest transitions, remembered as `agent.experience` does."""

from typing import NamedTuple

import numpy as np
from numba import njit
from numpy.typing import NDArray

from prospect_mj.experiment.populations.kernels.cache import uncounted


class Ring(NamedTuple):
    """A ring of b transitions, in numbers that the learner's kernel knows states by."""

    shown: NDArray[np.int64]
    """(b,): what the trial shows, a picture or an orientation."""
    haptic: NDArray[np.int64]
    """(b,): the haptic state that was left."""
    action: NDArray[np.int64]
    """(b,): the action taken there."""
    follows: NDArray[np.int64]
    """(b,): the haptic state that was reached."""
    terminated: NDArray[np.bool_]
    """(b,): whether nothing that follows counts."""
    allowed: NDArray[np.bool_]
    """(b, 6): what may be chosen in the state that was reached."""
    n_added: NDArray[np.int64]
    """(1,): transitions so far."""
    drawn: NDArray[np.int64]
    """(replays,): places of those to learn from again."""
    forgets: bool
    """Whether all actions count in what is learned from again."""


def new_ring(capacity: int, n_actions: int, replays: int, forgets: bool) -> Ring:
    """A ring that remembers nothing yet."""
    shown, haptic, action, follows = np.zeros((4, capacity), np.int64)
    return Ring(
        shown,
        haptic,
        action,
        follows,
        np.zeros(capacity, np.bool_),
        np.zeros((capacity, n_actions), np.bool_),
        np.zeros(1, np.int64),
        np.zeros(replays, np.int64),
        forgets,
    )


@uncounted
def remember(
    ring: Ring,
    shown: int,
    haptic: int,
    action: int,
    follows: int,
    terminated: bool,
    allowed: NDArray[np.bool_],
) -> int:
    """Put a transition in the place of the oldest one; give that place."""
    place = ring.n_added[0] % len(ring.shown)
    ring.shown[place] = shown
    ring.haptic[place] = haptic
    ring.action[place] = action
    ring.follows[place] = follows
    ring.terminated[place] = terminated
    for number in range(len(allowed)):
        ring.allowed[place, number] = allowed[number]
    ring.n_added[0] += 1
    return place


@uncounted
def forget(ring: Ring, place: int) -> None:
    """Forget what could be chosen after a transition, if such is forgotten."""
    for number in range(ring.allowed.shape[1]):
        ring.allowed[place, number] |= ring.forgets


# With reference counts, as numba makes an array for the numbers.
@njit(nogil=True, _nrt=True)
def draw(ring: Ring, rng: np.random.Generator) -> None:
    """Draw places of transitions to learn from again."""
    n = min(ring.n_added[0], len(ring.shown))
    ring.drawn[:] = rng.integers(0, n, len(ring.drawn))
