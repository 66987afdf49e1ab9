"""Features of a picture: how much of it has grey levels in one range, or in which.

A picture is known by its cumulative histogram c: the part of a range [begin, end) of
bins is c[end] - c[begin], whatever its width.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from prospect_mj.agent.features import N_BINS

WIDTHS = (2, 16)
"""Least and greatest width of a range that is drawn [bins]."""
N_LEVELS = 3
"""Kinds of features, from simple to complex: a bin, a range, two ranges' difference."""


class Feature(NamedTuple):
    """The part of a picture in one range of bins, less that in another one."""

    begin: int
    """First bin of the range."""
    end: int
    """The bin after its last."""
    less_begin: int
    """First bin of the range that is taken off."""
    less_end: int
    """The bin after its last; the first one where nothing is taken off."""


def cumulative(visual: NDArray[np.float64]) -> NDArray[np.float64]:
    """The sum of the first k bins, for every k.

    Args:
        visual: v, (100,) [1], a scaled histogram.

    Returns:
        c, (101,) [1].
    """
    # Added up one by one, as the compiled code does it.
    return np.concatenate([[0.0], np.cumsum(visual)])


def measure(feature: Feature, pictures: NDArray[np.float64]) -> NDArray[np.float64]:
    """How strong a feature is.

    Args:
        feature: the ranges.
        pictures: c, (..., 101) [1].

    Returns:
        (...) [1].
    """
    begin, end, less_begin, less_end = feature
    more = pictures[..., end] - pictures[..., begin]
    return more - (pictures[..., less_end] - pictures[..., less_begin])


def draw(rng: np.random.Generator) -> Feature:
    """Draw a new feature: of a random kind, with random ranges.

    Args:
        rng: asked for the kind, then for each range's width (but a bin's) and place.
    """
    kind = int(rng.integers(N_LEVELS))
    if kind == 0:
        begin = int(rng.integers(N_BINS))
        return Feature(begin, begin + 1, 0, 0)
    more = _draw_range(rng)
    return Feature(*more, *(_draw_range(rng) if kind == N_LEVELS - 1 else (0, 0)))


def _draw_range(rng: np.random.Generator) -> tuple[int, int]:
    width = int(rng.integers(WIDTHS[0], WIDTHS[1] + 1))
    begin = int(rng.integers(N_BINS - width + 1))
    return begin, begin + width
