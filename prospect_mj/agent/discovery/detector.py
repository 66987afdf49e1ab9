"""Detectors: features with a cut-point, and what several of them say together.

Piater and Grupen, "Constructive feature learning and the development of visual
expertise" (ICML 2000): a feature is worth as much as its distributions in the two
classes are apart, by the distance of Kolmogorov and Smirnov; the cut-point lies where
they are furthest apart; and a Bayesian network, here a naive one, tells the class.
"""

import math
from collections.abc import Iterable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from prospect_mj.agent.discovery.feature import Feature, measure

WORSE, BETTER = 0, 1
"""The classes: examples that came out worse or better than their context's mean."""


class Detector(NamedTuple):
    """A feature that tells the classes of one context apart."""

    feature: Feature
    cut: float
    """It is there where it is stronger than this [1]."""
    distance: float
    """Of Kolmogorov and Smirnov, between the classes [1]."""
    present: NDArray[np.int64]
    """(2,): examples of either class where it is there."""
    total: NDArray[np.int64]
    """(2,): examples of either class."""


class Separation(NamedTuple):
    """Where two samples are furthest apart."""

    distance: float
    """max_t |F_worse(t) - F_better(t)|, from 0 to 1."""
    cut: float
    """Half-way from the least such t among the samples to the next number there."""


def separation(worse: NDArray[np.float64], better: NDArray[np.float64]) -> Separation:
    """The distance of Kolmogorov and Smirnov between two samples.

    Args:
        worse: (m,).
        better: (n,).
    """
    levels = np.unique(np.concatenate([worse, better]))
    below_worse = np.searchsorted(np.sort(worse), levels, side="right")
    below_better = np.searchsorted(np.sort(better), levels, side="right")
    # Whole numbers: what is equal stays so.
    gaps = np.abs(below_worse * len(better) - below_better * len(worse))
    place = int(gaps.argmax())
    if gaps[place] == 0:
        return Separation(0.0, float(levels[0]))
    distance = int(gaps[place]) / (len(worse) * len(better))
    return Separation(distance, float((levels[place] + levels[place + 1]) / 2.0))


def guard_scale(probability: float) -> float:
    """The scale of `required_distance`, which alone depends on the probability."""
    return math.sqrt(-math.log(probability / 2.0) / 2.0)


def required_distance(n_worse: int, n_better: int, probability: float) -> float:
    """The distance that samples of one distribution exceed with a small probability.

    sqrt(-ln(p / 2) / 2) sqrt((m + n) / (m n)), the asymptotic formula (Smirnov 1948).
    With few examples it is above 1, which no distance exceeds.

    Args:
        n_worse: m, examples of one class, at least 1.
        n_better: n, of the other.
        probability: p.
    """
    size = math.sqrt((n_worse + n_better) / (n_worse * n_better))
    return guard_scale(probability) * size


def detector(
    feature: Feature, worse: NDArray[np.float64], better: NDArray[np.float64]
) -> Detector:
    """A feature with the best cut-point for the examples of two classes.

    Args:
        feature: what is measured.
        worse: c, (m, 101) [1], cumulative histograms.
        better: c, (n, 101) [1].
    """
    strengths = measure(feature, worse), measure(feature, better)
    apart = separation(*strengths)
    present = [np.count_nonzero(of_class > apart.cut) for of_class in strengths]
    total = [len(of_class) for of_class in strengths]
    return Detector(
        feature, apart.cut, apart.distance, np.array(present), np.array(total)
    )


def likelier_class(detectors: Iterable[Detector], picture: NDArray[np.float64]) -> int:
    """The class that a picture is of, by naive Bayes with equal prior probabilities.

    P(there | class) is (present + 1) / (total + 2), after Laplace.

    Args:
        detectors: each counts as independent of the others in either class.
        picture: c, (101,) [1].

    Returns:
        WORSE or BETTER.
    """
    likelihood = [1.0, 1.0]
    for one in detectors:
        is_there = measure(one.feature, picture) > one.cut
        hits = one.present if is_there else one.total - one.present
        for kind in (WORSE, BETTER):
            likelihood[kind] *= (int(hits[kind]) + 1) / (int(one.total[kind]) + 2)
    return BETTER if likelihood[BETTER] > likelihood[WORSE] else WORSE
