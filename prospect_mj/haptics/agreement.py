"""Whether a number of models is one that other grasps ask for, too.

More models always fit better, even grasps that they were not made from, as grasps are
no normal densities: no likelihood tells how many there are. But a category is of use
only if it is the same whatever grasps it was made from. So grasps are split into
halves, both clustered, and all grasps sorted by the models of either: how far both
agree is Hubert and Arabie's adjusted Rand index (Comparing partitions, Journal of
Classification 2, 1985), 1 where they are the same and 0 where they agree by chance
(von Luxburg, Clustering stability: an overview, 2010). Nothing is told of what was
grasped.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from prospect_mj.checks import check_integer
from prospect_mj.haptics.clustering import ClusterSettings, fit
from prospect_mj.haptics.models import categories

_Numbers = NDArray[np.integer]


class Agreement(NamedTuple):
    """How far the models of two halves agree."""

    mean: float
    """Adjusted Rand index, mean over the splits [1]."""
    error: float
    """Its standard error over the splits [1]."""


def agreement(
    trajectories: list[NDArray[np.float64]],
    groups: _Numbers,
    settings: ClusterSettings,
    splits: int,
    rng: np.random.Generator,
) -> Agreement:
    """How far the models of two halves agree.

    Args:
        trajectories: each (k, 3), as `phase_samples` gives them.
        groups: (t,), trajectories of one group depend on each other: a half has all
            of them or none.
        settings: of both clusterings.
        splits: into halves, drawn anew each time; two at least.
        rng: draws the halves, and the starts of the clustering.

    Raises:
        InvalidValue: if a half has fewer trajectories than models, or there are fewer
            than two splits.
    """
    check_integer("splits", splits, 2, 10_000)
    names, group = np.unique(groups, return_inverse=True)
    found = []
    for _ in range(splits):
        first = (rng.permutation(len(names)) < len(names) // 2)[group]
        sorted_by = []
        for half in (first, ~first):
            chosen = [trajectories[i] for i in np.flatnonzero(half)]
            models = fit(chosen, settings, rng).models
            sorted_by.append(categories(trajectories, models))
        found.append(adjusted_rand(*sorted_by))
    return Agreement(
        float(np.mean(found)), float(np.std(found, ddof=1) / np.sqrt(splits))
    )


def adjusted_rand(one: _Numbers, other: _Numbers) -> float:
    """How far two sortings of the same things agree: 1 if wholly, 0 as by chance.

    Args:
        one: (t,), the class of each thing, from 0.
        other: (t,), in the other sorting.
    """
    counts = np.zeros((one.max() + 1, other.max() + 1))
    np.add.at(counts, (one, other), 1)
    ones, others = _pairs(counts.sum(axis=1)), _pairs(counts.sum(axis=0))
    by_chance = ones * others / _pairs(np.array([len(one)]))
    most = (ones + others) / 2
    # Both have a single class, or each thing its own: they are the same.
    if most == by_chance:
        return 1.0
    return float((_pairs(counts) - by_chance) / (most - by_chance))


def _pairs(counts: NDArray[np.number]) -> float:
    """Pairs of things in the same cell."""
    return float((counts * (counts - 1) / 2).sum())
