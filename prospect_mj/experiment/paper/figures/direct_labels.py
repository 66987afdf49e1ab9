"""Names beside curves, where there is room, in place of a legend."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from matplotlib.axes import Axes
from matplotlib.text import Text

from prospect_mj.experiment.paper.figures.figure_frame import SMALL
from prospect_mj.experiment.paper.measures.bootstrap import Floats

_STEP = 10.0
"""Between points of a line [pixels]."""
_TRIED = (10.0, 5.0)
"""Between places that are tried, sideways and upwards [pixels]."""
_NEAR = 6.0
"""The least that a name stays away from every line [pixels]."""
_FAR = 40.0
"""From where on it doesn't matter how far away other lines are [pixels]."""
_GRID = 1.0
"""The least that a name stays away from the grid [pixels]."""
_EDGE = 4.0
"""Room along the edge of the axes [pixels]."""


class Named(NamedTuple):
    """A curve and its name."""

    name: str
    colour: str
    lines: Sequence[Floats]
    """The curve, and the bounds of its band, each (n, 2) in the data."""


def write_names(axes: Axes, curves: Sequence[Named], lines: Sequence[Floats]) -> None:
    """Write each name near its own curve and away from all others.

    Args:
        axes: where the curves are drawn; its limits must be set.
        curves: each with its name.
        lines: other lines to be kept clear, each (n, 2) in the data.
    """
    # Only now is known where the axes will be.
    axes.figure.draw_without_rendering()
    drawn = [_in_pixels(axes, curve.lines) for curve in curves]
    taken = [_in_pixels(axes, lines)]
    frame = axes.get_window_extent().extents
    ticks = np.column_stack([np.zeros(len(axes.get_yticks())), axes.get_yticks()])
    grid = axes.transData.transform(ticks)[:, 1]
    for number, curve in enumerate(curves):
        text = _text(axes, curve)
        extent = text.get_window_extent()
        half = np.array([extent.width, extent.height]) / 2
        others = [*drawn[:number], *drawn[number + 1 :], *taken]
        centre = best_place(frame, grid, half, drawn[number], np.concatenate(others))
        text.set_position(axes.transData.inverted().transform(centre))
        taken.append(_box(centre, half))


def best_place(
    frame: Floats, grid: Floats, half: Floats, own: Floats, others: Floats
) -> Floats:
    """Where the box of a name is near its own line, and clear of all lines.

    Args:
        frame: (4,), left, bottom, right and top of what there is [pixels].
        grid: (g,), heights of the lines across all of it [pixels].
        half: (2,), half the box's width and height [pixels].
        own: (n, 2), points of its own line [pixels].
        others: (m, 2), points of all else [pixels].

    Returns:
        (2,), the middle of the box [pixels].
    """
    low, high = frame[:2] + half + _EDGE, frame[2:] - half - _EDGE
    across, up = map(np.arange, low, high, _TRIED)
    between = (np.abs(up[:, None] - grid) > half[1] + _GRID).all(axis=1)
    up = up[between] if between.any() else up
    centres = np.stack(np.meshgrid(across, up), axis=-1).reshape(-1, 2)
    to_own, to_others = (_clearance(centres, half, points) for points in (own, others))
    clear = np.minimum(to_own, to_others)
    # What is not clear is worse than all that is.
    score = np.where(clear < _NEAR, clear - 1e6, np.minimum(to_others, _FAR) - to_own)
    return centres[score.argmax()]


def _clearance(centres: Floats, half: Floats, points: Floats) -> Floats:
    """Distance (c,) of boxes around centres (c, 2) from the nearest point (n, 2)."""
    nearest = np.full(len(centres), np.inf)
    for point in points:
        away = np.maximum(np.abs(centres - point) - half, 0.0)
        np.minimum(nearest, np.hypot(away[:, 0], away[:, 1]), out=nearest)
    return nearest


def _text(axes: Axes, curve: Named) -> Text:
    style = {"ha": "center", "va": "center", "fontsize": SMALL, "fontweight": "bold"}
    text = axes.text(0, 0, curve.name, **style)
    text.set(color=curve.colour, in_layout=False)
    return text


def _in_pixels(axes: Axes, lines: Sequence[Floats]) -> Floats:
    """Points along lines, (n, 2) [pixels]."""
    return np.concatenate(
        [np.empty((0, 2)), *(_dense(axes.transData.transform(line)) for line in lines)]
    )


def _dense(line: Floats) -> Floats:
    """Points at short steps along a line (n, 2) [pixels]."""
    lengths = np.hypot(*np.diff(line, axis=0).T)
    along = np.concatenate([[0.0], np.cumsum(lengths)])
    places = np.linspace(0, along[-1], 2 + int(along[-1] / _STEP))
    return np.column_stack([np.interp(places, along, side) for side in line.T])


def _box(centre: Floats, half: Floats) -> Floats:
    """Points all over a box (n, 2) [pixels]."""
    sides = [np.arange(c - h, c + h, _STEP) for c, h in zip(centre, half, strict=True)]
    return np.stack(np.meshgrid(*sides), axis=-1).reshape(-1, 2)
