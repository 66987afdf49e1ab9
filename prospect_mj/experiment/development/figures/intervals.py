"""Measures of many rows as dots with their intervals."""

from collections.abc import Mapping, Sequence
from math import isinf, isnan
from typing import NamedTuple

from matplotlib.axes import Axes

from prospect_mj.experiment.development.figures.grid import GREY, Size, grid, name
from prospect_mj.experiment.paper.figures.figure_frame import (
    BLUE,
    GREEN,
    INK,
    SMALL,
    VERMILION,
)
from prospect_mj.experiment.paper.measures.bootstrap import Interval
from prospect_mj.experiment.run.plots import png

BEYOND = 660
"""Where what is never gone is drawn [trials]; six hundred follow the pretraining."""

_ROW = 0.21
"""Height of a row [inches]."""
_HEAD = 1.5


class Dots(NamedTuple):
    """One measure of all rows in a panel."""

    measure: str
    """Its name."""
    title: str
    colour: str


class Column(NamedTuple):
    """A panel."""

    title: str
    dots: Sequence[Dots]
    most: float
    """End of its axis."""
    per_cent: bool = False


GONE_COLUMN = Column(
    "trials until gone",
    (Dots("late_gone", "late", VERMILION), Dots("early_gone", "early", GREEN)),
    BEYOND + 20,
)
STRETCHES = Column(
    "longest stretch [trials]",
    (
        Dots("dominance", "corrections > optimal", "#8c5a00"),
        Dots("early_lead", "and early > late", GREEN),
    ),
    BEYOND,
)
EASY = Column(
    "optimal [%]",
    (
        Dots("easy_worst", "worst easy block", GREY),
        Dots("optimal_last", "difficult, at the end", BLUE),
    ),
    100,
    per_cent=True,
)
_END = 630
"""Where the trials end in the drawing."""
_APART = 0.16
"""Between the dots of a row [rows]."""


def intervals(
    title: str,
    of: str,
    rows: Mapping[str, Mapping[str, Interval]],
    columns: Sequence[Column] = (GONE_COLUMN, STRETCHES, EASY),
) -> bytes:
    """Draw measures of some rows.

    Args:
        title: of the figure.
        of: what it shows.
        rows: measures by name, of each row from above.
        columns: what is drawn of them.

    Returns:
        The picture as PNG.
    """
    size = Size(1, len(columns), 9.0, _HEAD + _ROW * len(rows))
    made = grid(title, of, size, sharex=False)
    for axes, column in zip(made.axes[0], columns, strict=True):
        name(axes, column.title)
        axes.set_xlim(-0.02 * column.most, column.most)
        for number, dots in enumerate(column.dots):
            shift = _APART * (number - (len(column.dots) - 1) / 2)
            for row, measured in enumerate(rows.values()):
                _dot(axes, measured[dots.measure], row + shift, dots, column)
        _key(axes, column)
        axes.grid(visible=True, axis="x", color="#ededed")
    axes = made.axes[0, 0]
    axes.set_yticks(range(len(rows)), list(rows), fontsize=SMALL)
    axes.set_ylim(len(rows) - 0.5, -0.5)
    return png(made.figure)


def _dot(
    axes: Axes, found: Interval, height: float, dots: Dots, column: Column
) -> None:
    """A dot and its interval; an arrow for what is never gone."""
    if isnan(found.estimate):
        return
    scale = 100.0 if column.per_cent else 1.0
    low, value, high = (
        min(scale * one, BEYOND) if not isnan(one) else scale * found.estimate
        for one in (found.low, found.estimate, found.high)
    )
    axes.plot(
        [low, high], [height, height], color=dots.colour, linewidth=1.6, alpha=0.6
    )
    marker = ">" if isinf(found.estimate) else "o"
    axes.plot(value, height, marker=marker, color=dots.colour, markersize=3.6)


def _key(axes: Axes, column: Column) -> None:
    """Names of the dots below the axis, each in its colour."""
    for number, dots in enumerate(column.dots):
        axes.annotate(
            dots.title,
            (0, 0),
            (0, -26 - 12 * number),
            xycoords="axes fraction",
            textcoords="offset points",
            color=dots.colour,
            fontsize=SMALL,
            fontweight="bold",
            va="top",
        )
    if any("gone" in dots.measure for dots in column.dots):
        axes.axvline(_END, color=INK, linewidth=0.6, linestyle=(0, (2, 2)))
        style = {"fontsize": SMALL - 1, "color": INK, "va": "bottom", "ha": "right"}
        axes.annotate("never", (1, 1), xycoords="axes fraction", **style)
