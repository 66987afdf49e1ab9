"""Numbers that describe a learning curve, as the paper's section 3.2 reports them."""

from typing import NamedTuple, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

BLOCK = 10
"""Trials per point of the paper's figure 5."""
WINDOW = 50
"""Trials of the means that describe a single run."""
OPTIMUM = 2
"""Actions of a solved trial without a wasted one: a grasp and an insertion."""
NEAR_OPTIMAL = 2.4
"""Mean actions from which a curve counts as near-optimal. The paper has no number; with
its exploration rate of 0.05 even the best policy takes 2.10, see
`paper.populations.optimum`."""


def block_means(n_actions: ArrayLike, size: int = BLOCK) -> NDArray[np.float64]:
    """Mean actions over successive sets of trials.

    Args:
        n_actions: (n_trials,) or (n_runs, n_trials) [actions].
        size: trials per set; trials that don't fill a last set are left out.

    Returns:
        (n_trials // size,) [actions], the mean over all runs too.
    """
    actions = np.atleast_2d(np.asarray(n_actions, dtype=np.float64))
    n_runs, n_blocks = len(actions), actions.shape[1] // size
    blocks = actions[:, : n_blocks * size].reshape(n_runs, n_blocks, size)
    return blocks.mean(axis=(0, 2))


def moving_mean(values: ArrayLike, window: int) -> NDArray[np.float64]:
    """Mean over every run of `window` successive values.

    Args:
        values: (n,).
        window: values per mean.

    Returns:
        (n - window + 1,), empty if there are too few values.
    """
    sequence = np.asarray(values, dtype=np.float64)
    if sequence.size < window:
        return np.empty(0)
    return np.lib.stride_tricks.sliding_window_view(sequence, window).mean(axis=-1)


def settled(curves: NDArray[np.float64], level: ArrayLike) -> NDArray[np.float64]:
    """First set from which on curves stay at or below a level.

    Args:
        curves: (b, s); a set that is NaN is passed over.
        level: one for all, or (b, 1).

    Returns:
        (b,) [sets], infinite where the last set is above.
    """
    above = curves > level
    n_sets = above.shape[1]
    after_last = n_sets - above[:, ::-1].argmax(axis=1)
    first = np.where(above.any(axis=1), after_last, 0)
    return np.where(first < n_sets, first, np.inf)


def smoothed_near_optimal_trial(means: ArrayLike, smoothing: int = 3) -> int | None:
    """Trial from which moving means of the curve are near-optimal and stay so.

    For a study of few runs, in which a single unlucky set would decide; the paper's
    experiment itself takes the sets as they are, and comes out later by a set or two
    (`paper.measures.learning.near_optimal`).

    Args:
        means: (n_blocks,) [actions], from `block_means`.
        smoothing: sets per moving mean.

    Returns:
        First trial of the first such moving mean; None if the curve does not end
        near-optimal.
    """
    smooth = moving_mean(means, smoothing)
    (first,) = settled(smooth[None], NEAR_OPTIMAL) if smooth.size else (np.inf,)
    return int(BLOCK * first) if np.isfinite(first) else None


def first_near_optimal_window(n_actions: ArrayLike, window: int = WINDOW) -> int | None:
    """First of the first `window` successive trials with a near-optimal mean.

    The measure for a single run, whose noise would break any "and stays so".

    Args:
        n_actions: (n_trials,) [actions].
        window: trials per mean.
    """
    reached = np.flatnonzero(moving_mean(n_actions, window) <= NEAR_OPTIMAL)
    return int(reached[0]) if reached.size else None


class Course(NamedTuple):
    """How the actions per trial of a run went."""

    first_mean: float
    """Mean actions of the first trials (at most `WINDOW`)."""
    last_mean: float
    """Mean actions of the last trials (at most `WINDOW`)."""
    near_optimal: int | None
    """First of the first `WINDOW` successive trials, after the pretraining, with a
    near-optimal mean."""

    @classmethod
    def of(cls, n_actions: NDArray[np.integer], pretrain: int) -> Self:
        """Measure a run.

        Args:
            n_actions: (n_trials,) [actions].
            pretrain: trials of pretraining.
        """
        reached = first_near_optimal_window(n_actions[pretrain:])
        return cls(
            first_mean=float(np.mean(n_actions[:WINDOW])),
            last_mean=float(np.mean(n_actions[-WINDOW:])),
            near_optimal=None if reached is None else pretrain + reached,
        )
