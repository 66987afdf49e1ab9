"""What is measured on the corrections in difficult trials, as `measures` does it.

Two measures of when a correction is gone are taken side by side: the rarer of two
corrections is nearer to any fixed share from the start, and falls below it sooner.
"""

import numpy as np

from prospect_mj.experiment.learning_curve import BLOCK, settled
from prospect_mj.experiment.paper.bootstrap import Floats
from prospect_mj.experiment.paper.curves import Curves, moving_means
from prospect_mj.experiment.paper.sample import Pair
from prospect_mj.experiment.paper.strategies import Strategy

GONE = 0.02
"""Share of difficult trials at which a correction counts as gone: exploration alone
makes 0.05 / 6 = 0.8 % of first grasps wrong ones."""
FADED = 0.5
"""Part of its own largest share at which a correction counts as faded. At a quarter the
early ones would be as rare as exploration alone makes them, and stay about there."""


def correction_margin(pair: Pair) -> Floats:
    """Smallest lead of the optimal strategy over corrections on difficult trials.

    The smallest value, over sets of ten after the pretraining, of the share of
    difficult trials with the optimal strategy minus that with a correction of any kind.
    """
    early, late = (_after(pair.dominant, s) for s in (Strategy.EARLY, Strategy.LATE))
    lead = _after(pair.dominant, Strategy.OPTIMAL) - early - late
    return np.fmin.reduce(lead, axis=1)


def early_gone(pair: Pair) -> Floats:
    """Early corrections gone.

    The first trial of the first set of ten after the pretraining from which on every
    set has early corrections in at most 2 % of its difficult trials; none if no set
    ever has more.
    """
    return _gone(pair.dominant, Strategy.EARLY)


def late_gone(pair: Pair) -> Floats:
    """Late corrections gone.

    The first trial of the first set of ten after the pretraining from which on every
    set has late corrections in at most 2 % of its difficult trials; none if no set ever
    has more.
    """
    return _gone(pair.dominant, Strategy.LATE)


def late_outlasts_early(pair: Pair) -> Floats:
    """Late corrections outlast early ones, by a fixed share.

    Trials from where early corrections are gone, at 2 % of the difficult trials, to
    where late ones are.
    """
    return _lag(early_gone(pair), late_gone(pair))


def early_largest(pair: Pair) -> Floats:
    """Largest share of early corrections.

    The largest mean share of early corrections in the difficult trials of five
    successive sets of ten after the pretraining.
    """
    return np.fmax.reduce(_smooth(pair.dominant, Strategy.EARLY), axis=1)


def late_largest(pair: Pair) -> Floats:
    """Largest share of late corrections.

    The largest mean share of late corrections in the difficult trials of five
    successive sets of ten after the pretraining.
    """
    return np.fmax.reduce(_smooth(pair.dominant, Strategy.LATE), axis=1)


def early_faded(pair: Pair) -> Floats:
    """Early corrections faded.

    The first trial of the first five successive sets of ten after the pretraining from
    which on the mean share of early corrections in the difficult trials of five sets
    stays at or below a half of its largest value.
    """
    return _faded(pair.dominant, Strategy.EARLY)


def late_faded(pair: Pair) -> Floats:
    """Late corrections faded.

    The first trial of the first five successive sets of ten after the pretraining from
    which on the mean share of late corrections in the difficult trials of five sets
    stays at or below a half of its largest value.
    """
    return _faded(pair.dominant, Strategy.LATE)


def late_outlasts_early_relatively(pair: Pair) -> Floats:
    """Late corrections outlast early ones, each by its own largest share.

    Trials from where early corrections are faded, to a half of their own largest share,
    to where late ones are.
    """
    return _lag(early_faded(pair), late_faded(pair))


def _after(curves: Curves, strategy: Strategy) -> Floats:
    """Shares (b, s) of a strategy in the difficult trials after the pretraining."""
    return curves.difficult[:, strategy, curves.switch :]


def _smooth(curves: Curves, strategy: Strategy) -> Floats:
    """The same as moving means."""
    return moving_means(_after(curves, strategy))


def _gone(curves: Curves, strategy: Strategy) -> Floats:
    shares = _after(curves, strategy)
    gone = BLOCK * (curves.switch + settled(shares, GONE))
    return np.where((shares > GONE).any(axis=1), gone, np.nan)


def _faded(curves: Curves, strategy: Strategy) -> Floats:
    shares = _smooth(curves, strategy)
    largest = np.fmax.reduce(shares, axis=1, keepdims=True)
    faded = BLOCK * (curves.switch + settled(shares, FADED * largest))
    return np.where(largest[:, 0] > 0, faded, np.nan)


def _lag(early: Floats, late: Floats) -> Floats:
    """Trials from the one to the other; NaN if either is NaN, or both are infinite."""
    with np.errstate(invalid="ignore"):
        return late - early
