"""What is measured on the learning curves; see `measure`.

The measures of corrections are in `corrections`, those of easy trials in `easy_trials`.
"""

import numpy as np

from prospect_mj.experiment.paper.measures.bootstrap import Floats
from prospect_mj.experiment.paper.measures.curves import (
    LONG,
    Curves,
    moving_means,
    ratio,
)
from prospect_mj.experiment.paper.measures.measure import Measure, measure
from prospect_mj.experiment.paper.measures.quantity import Kind
from prospect_mj.experiment.paper.measures.sample import Pair
from prospect_mj.experiment.run.learning_curve import BLOCK, NEAR_OPTIMAL, settled

RATE_LEVELS = ((6.0, 3.0), (5.0, 3.0), (5.0, 2.5), (4.0, 2.4))
"""Mean actions between which the rate of learning is taken."""


def _end_of_baseline(pair: Pair) -> float:
    return BLOCK * pair.baseline.actions.shape[1]


def _end_of_pretraining(pair: Pair) -> float:
    return BLOCK * pair.dominant.switch


@measure(
    Kind.TRIAL,
    "Near-optimal without a dominant hand",
    "The first trial of the first set of ten from which on every set has a mean over "
    "all runs of at most 2.4 actions.",
    end=_end_of_baseline,
)
def near_optimal(pair: Pair) -> Floats:
    """(b,) [trials]."""
    return BLOCK * settled(pair.baseline.actions, NEAR_OPTIMAL)


@measure(
    Kind.TRIAL,
    "Near-optimal in pretraining",
    "The same as near-optimal without a dominant hand, over the sets of the "
    "pretraining.",
    end=_end_of_pretraining,
)
def pretraining_near_optimal(pair: Pair) -> Floats:
    """(b,) [trials]."""
    return BLOCK * settled(_before(pair.dominant), NEAR_OPTIMAL)


@measure(
    Kind.RATIO,
    "Near-optimal in pretraining, relative",
    "The trial from which on the pretraining is near-optimal, divided by that without "
    "a dominant hand.",
)
def pretraining_ratio(pair: Pair) -> Floats:
    """(b,) [1]; NaN unless both are reached."""
    return _reached(ratio(pretraining_near_optimal(pair), near_optimal(pair)))


@measure(
    Kind.SHARE,
    "First trials cut off",
    "The share of the first ten trials, without a dominant hand, that were not solved "
    "within the longest trial allowed.",
)
def first_unsolved(pair: Pair) -> Floats:
    """(b,) [1]."""
    return pair.baseline.unsolved[:, 0]


@measure(
    Kind.ACTIONS,
    "Right after the pretraining",
    "The mean number of actions over all runs in the first ten trials after the "
    "pretraining.",
)
def actions_after_switch(pair: Pair) -> Floats:
    """(b,) [actions]."""
    return _after(pair.dominant)[:, 0]


@measure(
    Kind.ACTIONS,
    "Largest mean after the pretraining",
    "The largest mean number of actions over five successive sets of ten after the "
    "pretraining.",
)
def most_actions(pair: Pair) -> Floats:
    """(b,) [actions]."""
    return moving_means(_after(pair.dominant)).max(axis=1)


@measure(
    Kind.TRIAL,
    "Place of the largest mean after the pretraining",
    "The middle of these five sets.",
)
def most_actions_trial(pair: Pair) -> Floats:
    """(b,) [trials]."""
    return pair.dominant.middle(np.argmax(moving_means(_after(pair.dominant)), axis=1))


@measure(
    Kind.RATIO,
    "Time from the first random orientation to near-optimal, relative",
    "Trials from the first one with random orientation to near-optimal after the "
    "pretraining, divided by the same without a dominant hand.",
)
def relearning_ratio(pair: Pair) -> Floats:
    """(b,) [1]; NaN unless both are reached."""
    spans = (settled(c, NEAR_OPTIMAL) for c in _with_random_sides(pair))
    return _reached(ratio(*spans))


def fall_ratio(upper: float, lower: float) -> Measure:
    """How long the mean takes to fall from a level [actions] to a lower one, relative.

    NaN unless both scenarios fall as far.
    """

    def formula(pair: Pair) -> Floats:
        spans = (_fall(curves, upper, lower) for curves in _with_random_sides(pair))
        return _reached(ratio(*spans))

    return Measure(
        f"fall_ratio_{upper:g}_to_{lower:g}".replace(".", "_"),
        Kind.RATIO,
        f"Time from {upper:g} to {lower:g} actions, relative",
        f"Trials in which the mean over all runs falls for good from {upper:g} to "
        f"{lower:g} actions after the pretraining, on straight lines from set of ten "
        "to set of ten, divided by the same without a dominant hand.",
        formula,
    )


@measure(
    Kind.ACTIONS,
    "Actions at the end without a dominant hand",
    "The mean number of actions over all runs in the last hundred trials without a "
    "dominant hand.",
)
def last_actions(pair: Pair) -> Floats:
    """(b,) [actions]."""
    return pair.baseline.actions[:, -LONG:].mean(axis=1)


def _before(curves: Curves) -> Floats:
    return curves.actions[:, : curves.switch]


def _after(curves: Curves) -> Floats:
    return curves.actions[:, curves.switch :]


def _with_random_sides(pair: Pair) -> tuple[Floats, Floats]:
    """Actions (b, s) where orientations are random: after pretraining, and without."""
    return _after(pair.dominant), pair.baseline.actions


def _reached(values: Floats) -> Floats:
    """NaN in place of what a longer study might tell."""
    return np.where(np.isfinite(values), values, np.nan)


def _fall(actions: Floats, upper: float, lower: float) -> Floats:
    """Sets from where curves (b, s) cross the upper level for good to the lower one."""
    top, bottom = (_crossing(actions, level) for level in (upper, lower))
    reached = np.isfinite(bottom)
    return np.where(reached, bottom - np.where(reached, top, 0.0), np.inf)


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
