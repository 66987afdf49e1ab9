"""What is measured on the learning curves; the report quotes the definitions from here.

Each measure takes the curves of both scenarios, b times resampled, and gives a value
per resample (b,): infinity where it is never reached, NaN where there is nothing to be
measured. The first line of its docstring is its name, the second paragraph its
definition. Those of corrections are in `corrections`.
"""

import numpy as np

from prospect_mj.experiment.learning_curve import BLOCK, NEAR_OPTIMAL, settled
from prospect_mj.experiment.paper.bootstrap import Floats
from prospect_mj.experiment.paper.curves import (
    SMOOTHED,
    Curves,
    mean_of_sets,
    moving_means,
)
from prospect_mj.experiment.paper.sample import Pair
from prospect_mj.experiment.paper.strategies import Strategy

RATE_LEVELS = (5.0, 3.0)
"""Mean actions between which the rate of learning is taken."""
_LONG = 10


def near_optimal(pair: Pair) -> Floats:
    """Near-optimal without a dominant hand.

    The first trial of the first set of ten from which on every set has a mean over all
    runs of at most 2.4 actions.
    """
    return BLOCK * settled(pair.baseline.actions, NEAR_OPTIMAL)


def pretraining_near_optimal(pair: Pair) -> Floats:
    """Near-optimal in pretraining.

    The same as near-optimal without a dominant hand, over the sets of the pretraining.
    """
    return BLOCK * settled(_before(pair.dominant), NEAR_OPTIMAL)


def first_unsolved(pair: Pair) -> Floats:
    """First trials cut off.

    The share of the first ten trials, without a dominant hand, that were not solved
    within the longest trial allowed.
    """
    return pair.baseline.unsolved[:, 0]


def actions_after_switch(pair: Pair) -> Floats:
    """Right after the pretraining.

    The mean number of actions over all runs in the first ten trials after the
    pretraining.
    """
    return _after(pair.dominant)[:, 0]


def relearning_ratio(pair: Pair) -> Floats:
    """Time from the first random orientation to near-optimal, relative.

    Trials from the first one with random orientation to near-optimal after the
    pretraining, divided by the same without a dominant hand.
    """
    return _ratio(*(settled(c, NEAR_OPTIMAL) for c in _with_random_sides(pair)))


def fall_ratio(pair: Pair) -> Floats:
    """Time from five to three actions, relative.

    Trials in which the mean over all runs falls for good from five to three actions
    after the pretraining, on straight lines from set of ten to set of ten, divided by
    the same without a dominant hand.
    """
    return _ratio(*map(_fall, _with_random_sides(pair)))


def easy_drop(pair: Pair) -> Floats:
    """Drop of the optimal strategy on easy trials.

    The share of easy trials with the optimal strategy in the last hundred trials of the
    pretraining, minus the smallest mean of such shares of five successive sets of ten
    after it.
    """
    before = _easy_optimal(pair)[:, : pair.dominant.switch]
    return mean_of_sets(before[:, -_LONG:]) - np.fmin.reduce(_easy_after(pair), axis=1)


def easy_low_trial(pair: Pair) -> Floats:
    """Place of that drop.

    The middle of the five successive sets of ten, after the pretraining, with the
    smallest mean share of the optimal strategy on easy trials.
    """
    lowest = np.nanargmin(_easy_after(pair), axis=1)
    n_after = _easy_optimal(pair).shape[1] - pair.dominant.switch
    return BLOCK * (pair.dominant.switch + lowest + min(SMOOTHED, n_after) / 2)


def easy_regained(pair: Pair) -> Floats:
    """Part of that drop that was regained.

    The rise of the share of the optimal strategy on easy trials from its lowest five
    sets after the pretraining to the mean of the last hundred trials, divided by the
    drop; none without a drop.
    """
    last = mean_of_sets(_easy_optimal(pair)[:, pair.dominant.switch :][:, -_LONG:])
    return _ratio(last - np.fmin.reduce(_easy_after(pair), axis=1), easy_drop(pair))


def last_actions(pair: Pair) -> Floats:
    """Actions at the end without a dominant hand.

    The mean number of actions over all runs in the last hundred trials without a
    dominant hand.
    """
    return pair.baseline.actions[:, -_LONG:].mean(axis=1)


def _before(curves: Curves) -> Floats:
    return curves.actions[:, : curves.switch]


def _after(curves: Curves) -> Floats:
    return curves.actions[:, curves.switch :]


def _with_random_sides(pair: Pair) -> tuple[Floats, Floats]:
    """Actions (b, s) where orientations are random: after pretraining, and without."""
    return _after(pair.dominant), pair.baseline.actions


def _fall(actions: Floats) -> Floats:
    """Sets from where curves (b, s) cross the upper level for good to the lower one."""
    upper, lower = (_crossing(actions, level) for level in RATE_LEVELS)
    reached = np.isfinite(lower)
    return np.where(reached, lower - np.where(reached, upper, 0.0), np.inf)


def _crossing(curves: Floats, level: float) -> Floats:
    """Where curves (b, s) fall to a level for good (b,) [sets], between sets too."""
    first = settled(curves, level)
    inside = np.isfinite(first) & (first > 0)
    ends = np.where(inside, first, 1).astype(np.intp)
    above, below = (
        np.take_along_axis(curves, at[:, None], axis=1)[:, 0] for at in (ends - 1, ends)
    )
    with np.errstate(invalid="ignore", divide="ignore"):
        part = (above - level) / (above - below)
    return np.where(inside, first - 1 + part, first)


def _easy_optimal(pair: Pair) -> Floats:
    return pair.dominant.easy[:, Strategy.OPTIMAL]


def _easy_after(pair: Pair) -> Floats:
    """Moving means of it (b, s) after the pretraining."""
    return moving_means(_easy_optimal(pair)[:, pair.dominant.switch :])


def _ratio(value: Floats, reference: Floats) -> Floats:
    """NaN unless the reference is above zero and finite."""
    usable = np.isfinite(reference) & (reference > 0)
    return np.divide(value, reference, out=np.full_like(value, np.nan), where=usable)
