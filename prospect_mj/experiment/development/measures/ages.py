"""Blocks in which the agent does as infants of an age do.

The numbers of McCarty, Clifton and Collard (1999) are not at hand, so that nothing but
what Wheeler, Fagg and Grupen (2002, section 2) tell in words is looked for: at 9 months
as many early as late corrections, at 14 early ones strongly preferred, at 19 hardly
any correction. The bounds below are ours.
"""

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from prospect_mj.experiment.development.measures.development import (
    Development,
    difficult,
)
from prospect_mj.experiment.paper.measures.bootstrap import Floats
from prospect_mj.experiment.paper.measures.curves import Curves, mean_of_sets
from prospect_mj.experiment.populations.strategies import Strategy
from prospect_mj.experiment.run.learning_curve import BLOCK

Booleans = NDArray[np.bool_]


class Window(NamedTuple):
    """Shares (b, w) in the difficult trials of windows of blocks."""

    late: Floats
    early: Floats
    optimal: Floats


@dataclass(frozen=True)
class Age:
    """An age of infants, and what counts as doing the same."""

    months: int
    infants: str
    """What the paper tells of them."""
    rule: str
    """What counts as that."""
    holds: Callable[[Window], Booleans]
    """(b, w)."""


class AgeFound(NamedTuple):
    """Where an age's pattern was found."""

    age: Age
    first: float
    """First trial of the first window that shows it, NaN without any."""
    last: float
    """Last trial of the last window that does."""
    resamples: float
    """Share of the resamples with such a window [1]."""


def _nine(window: Window) -> Booleans:
    late, early, optimal = window
    balanced = np.abs(late - early) <= 0.15
    return (late + early > optimal) & (np.minimum(late, early) >= 0.2) & balanced


def _fourteen(window: Window) -> Booleans:
    late, early, optimal = window
    return (late + early > optimal) & (early >= 2 * late) & (early >= 0.2)


def _nineteen(window: Window) -> Booleans:
    late, early, optimal = window
    return (optimal > 0.7) & (late + early < 0.25)


AGES = (
    Age(
        9,
        "as many early as late corrections",
        "corrections exceed the optimal strategy, early and late ones are 20 % of the "
        "difficult trials each, and not more than 15 points apart",
        _nine,
    ),
    Age(
        14,
        "early corrections strongly preferred",
        "corrections exceed the optimal strategy, early ones are 20 % and twice as "
        "many as late ones",
        _fourteen,
    ),
    Age(
        19,
        "corrections hardly necessary",
        "more than 70 % optimal, and less than 25 % corrections",
        _nineteen,
    ),
)
"""Of which the paper tells."""


def windows(curves: Curves, blocks: int = 2) -> Window:
    """Shares in windows of successive blocks, one beginning at each block."""
    shares = (
        difficult(curves, Strategy.LATE),
        difficult(curves, Strategy.EARLY),
        difficult(curves, Strategy.OPTIMAL),
    )
    return Window(*(_means(values, blocks) for values in shares))


def _means(shares: Floats, blocks: int) -> Floats:
    view = np.lib.stride_tricks.sliding_window_view(shares, blocks, axis=1)
    return mean_of_sets(view)


def ages(development: Development, blocks: int = 2) -> list[AgeFound]:
    """Where each age's pattern is found, in windows of so many blocks."""
    once, many = (windows(curves, blocks) for curves in development)
    return [_found(age, once, many, blocks) for age in AGES]


def _found(age: Age, once: Window, many: Window, blocks: int) -> AgeFound:
    where = np.flatnonzero(age.holds(once)[0])
    share = float(age.holds(many).any(axis=1).mean())
    if not len(where):
        return AgeFound(age, np.nan, np.nan, share)
    return AgeFound(age, BLOCK * where[0], BLOCK * (where[-1] + blocks) - 1, share)


def in_order(development: Development, blocks: int = 2) -> float:
    """Share of the resamples in which all patterns are there, one after the other.

    The first window of an age must come after that of the age before.
    """
    shown = [age.holds(windows(development.resampled, blocks)) for age in AGES]
    first = [np.where(one.any(axis=1), one.argmax(axis=1), np.inf) for one in shown]
    rising = np.all([then > one for one, then in pairwise(first)], axis=0)
    rising &= np.isfinite(first[-1])
    return float(rising.mean())
