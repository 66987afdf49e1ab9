"""What is measured on the learning curves; the report quotes the definitions from here.

Each measure takes the curves of both scenarios, b times resampled, and gives a value
per resample (b,): infinity where it is never reached, NaN where there is nothing to be
measured. The first line of its docstring is its name, the second paragraph its
definition. Those of corrections are in `corrections`.
"""

import numpy as np

from prospect_mj.experiment.learning_curve import BLOCK, NEAR_OPTIMAL
from prospect_mj.experiment.paper.bands import Curves, Floats, mean_of_sets
from prospect_mj.experiment.paper.sample import Pair
from prospect_mj.experiment.paper.strategies import Strategy

RATE_LEVELS = (5.0, 3.0)
"""Mean actions between which the rate of learning is taken."""
_SOON, _LONG = 3, 10


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


def peak_after_switch(pair: Pair) -> Floats:
    """Peak after the pretraining.

    The largest mean number of actions over all runs of a set of ten among the first
    thirty trials after the pretraining.
    """
    return _after(pair.dominant)[:, :_SOON].max(axis=1)


def relearning_ratio(pair: Pair) -> Floats:
    """Time from the first random orientation to near-optimal, relative.

    Trials from the first one with random orientation to near-optimal after the
    pretraining, divided by the same without a dominant hand.
    """
    return _ratio(*(settled(c, NEAR_OPTIMAL) for c in _with_random_sides(pair)))


def fall_ratio(pair: Pair) -> Floats:
    """Time from five to three actions, relative.

    Trials in which the mean over all runs of sets of ten falls for good from five to
    three actions after the pretraining, divided by the same without a dominant hand.
    """
    return _ratio(*map(_fall, _with_random_sides(pair)))


def easy_drop(pair: Pair) -> Floats:
    """Drop of the optimal strategy on easy trials.

    The share of easy trials with the optimal strategy in the last hundred trials of the
    pretraining, minus the smallest such share of a set of ten after it.
    """
    optimal, switch = _easy_optimal(pair), pair.dominant.switch
    before = mean_of_sets(optimal[:, :switch][:, -_LONG:])
    return before - np.fmin.reduce(optimal[:, switch:], axis=1)


def easy_low_trial(pair: Pair) -> Floats:
    """Place of that drop.

    The first trial of the set of ten, after the pretraining, with the smallest share of
    the optimal strategy on easy trials.
    """
    switch = pair.dominant.switch
    lowest = np.nanargmin(_easy_optimal(pair)[:, switch:], axis=1)
    return BLOCK * (switch + lowest).astype(np.float64)


def easy_regained(pair: Pair) -> Floats:
    """Part of that drop that was regained.

    The rise of the share of the optimal strategy on easy trials from its lowest set
    after the pretraining to the mean of the last hundred trials, divided by the drop;
    none without a drop.
    """
    optimal = _easy_optimal(pair)[:, pair.dominant.switch :]
    last = mean_of_sets(optimal[:, -_LONG:])
    return _ratio(last - np.fmin.reduce(optimal, axis=1), easy_drop(pair))


def last_actions(pair: Pair) -> Floats:
    """Actions at the end without a dominant hand.

    The mean number of actions over all runs in the last hundred trials without a
    dominant hand.
    """
    return pair.baseline.actions[:, -_LONG:].mean(axis=1)


def settled(curves: Floats, level: float | Floats) -> Floats:
    """First set from which on curves (b, s) stay at or below a level; (b,) [sets].

    With level 2.4 the same as `learning_curve.near_optimal_trial` without smoothing,
    which the means of so many runs don't need. A set that is NaN is passed over.
    """
    above = curves > level
    n_sets = above.shape[1]
    after_last = n_sets - above[:, ::-1].argmax(axis=1)
    first = np.where(above.any(axis=1), after_last, 0)
    return np.where(first < n_sets, first, np.inf)


def _before(curves: Curves) -> Floats:
    return curves.actions[:, : curves.switch]


def _after(curves: Curves) -> Floats:
    return curves.actions[:, curves.switch :]


def _with_random_sides(pair: Pair) -> tuple[Floats, Floats]:
    """Actions (b, s) where orientations are random: after pretraining, and without."""
    return _after(pair.dominant), pair.baseline.actions


def _fall(actions: Floats) -> Floats:
    """Sets from where curves (b, s) settle at the upper level to the lower one."""
    upper, lower = (settled(actions, level) for level in RATE_LEVELS)
    reached = np.isfinite(lower)
    return np.where(reached, lower - np.where(reached, upper, 0.0), np.inf)


def _easy_optimal(pair: Pair) -> Floats:
    return pair.dominant.easy[:, Strategy.OPTIMAL]


def _ratio(value: Floats, reference: Floats) -> Floats:
    """NaN unless the reference is above zero and finite."""
    usable = np.isfinite(reference) & (reference > 0)
    return np.divide(value, reference, out=np.full_like(value, np.nan), where=usable)
