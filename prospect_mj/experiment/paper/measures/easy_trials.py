"""What is measured on the easy trials after the pretraining; see `measure`."""

import numpy as np

from prospect_mj.experiment.paper.measures.bootstrap import Floats
from prospect_mj.experiment.paper.measures.curves import (
    LONG,
    SMOOTHED,
    mean_of_sets,
    moving_means,
    ratio,
)
from prospect_mj.experiment.paper.measures.measure import measure
from prospect_mj.experiment.paper.measures.quantity import Kind
from prospect_mj.experiment.paper.measures.sample import Pair
from prospect_mj.experiment.populations.strategies import Strategy


@measure(
    Kind.POINTS,
    "Drop of the optimal strategy on easy trials",
    "The share of easy trials with the optimal strategy in the last hundred trials of "
    "the pretraining, minus the smallest mean of such shares of five successive sets "
    "of ten after it.",
)
def easy_drop(pair: Pair) -> Floats:
    """(b,) [1]."""
    before = _optimal(pair)[:, : pair.dominant.switch]
    return mean_of_sets(before[:, -LONG:]) - _lowest(pair)


@measure(
    Kind.TRIAL,
    "Place of the drop on easy trials",
    "The middle of the five successive sets of ten, after the pretraining, with the "
    "smallest mean share of the optimal strategy on easy trials.",
)
def easy_low_trial(pair: Pair) -> Floats:
    """(b,) [trials]."""
    return pair.dominant.middle(np.nanargmin(_optimal_after(pair), axis=1))


@measure(
    Kind.RATIO,
    "Part of the drop on easy trials that was regained",
    "The rise of the share of the optimal strategy on easy trials from its lowest five "
    "sets after the pretraining to the mean of the last hundred trials, divided by the "
    "drop; none without a drop, or if it lies in these hundred trials.",
    of_end=True,
)
def easy_regained(pair: Pair) -> Floats:
    """(b,) [1]."""
    shares = _optimal(pair)[:, pair.dominant.switch :]
    lowest = np.nanargmin(_optimal_after(pair), axis=1)
    earlier = lowest + SMOOTHED <= shares.shape[1] - LONG
    rise = mean_of_sets(shares[:, -LONG:]) - _lowest(pair)
    return np.where(earlier, ratio(rise, easy_drop(pair)), np.nan)


@measure(
    Kind.RATIO,
    "Part of the rise that difficult trials make",
    "Of the rise of the mean number of actions, from the last hundred trials of the "
    "pretraining to the first ten after it, the part that would be left if easy "
    "trials had not risen.",
)
def difficult_part_of_rise(pair: Pair) -> Floats:
    """(b,) [1]."""
    after = pair.dominant.switch
    mean, easy, difficult = (
        actions[:, after]
        for actions in (
            pair.dominant.actions,
            pair.dominant.easy.actions,
            pair.dominant.difficult.actions,
        )
    )
    # Mean trials lie between easy and difficult ones, whichever take more actions.
    share = ratio(np.abs(mean - easy), np.abs(difficult - easy))
    return ratio(
        share * (difficult - _actions_before(pair)), mean - _actions_before(pair)
    )


@measure(
    Kind.ACTIONS,
    "Rise in easy trials, at once",
    "The mean number of actions in the easy ones of the first ten trials after the "
    "pretraining, minus that in its last hundred trials.",
)
def easy_rise_at_once(pair: Pair) -> Floats:
    """(b,) [actions]."""
    return pair.dominant.easy.actions[:, pair.dominant.switch] - _actions_before(pair)


@measure(
    Kind.ACTIONS,
    "Rise in easy trials, at its largest",
    "The largest mean number of actions in easy trials over five successive sets of "
    "ten after the pretraining, minus that in its last hundred trials.",
)
def easy_rise_at_most(pair: Pair) -> Floats:
    """(b,) [actions]."""
    after = pair.dominant.easy.actions[:, pair.dominant.switch :]
    return np.fmax.reduce(moving_means(after), axis=1) - _actions_before(pair)


def _actions_before(pair: Pair) -> Floats:
    """Mean actions (b,) in the last hundred trials of the pretraining, all easy."""
    actions = pair.dominant.easy.actions[:, : pair.dominant.switch]
    return mean_of_sets(actions[:, -LONG:])


def _optimal(pair: Pair) -> Floats:
    return pair.dominant.easy.strategies[:, Strategy.OPTIMAL]


def _optimal_after(pair: Pair) -> Floats:
    """Moving means of it (b, s) after the pretraining."""
    return moving_means(_optimal(pair)[:, pair.dominant.switch :])


def _lowest(pair: Pair) -> Floats:
    return np.fmin.reduce(_optimal_after(pair), axis=1)
