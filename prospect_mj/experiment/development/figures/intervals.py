"""Measures of many rows as dots with their intervals."""

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from matplotlib.axes import Axes

from prospect_mj.experiment.development.figures.dots import BEYOND, Look, asides, dot
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

_ROW = 0.21
"""Height of a row [inches]."""
_HEAD = 1.5
_WIDTH, _WORDS = 9.0, 1.5
"""Of all panels, and of words beside them [inches]."""


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
AS_INFANTS = "as infants"
"""What is written where all criteria hold."""
_ASIDE = 9
"""Of words beside panels [points]."""
_END = 630
"""Where the trials end in the drawing."""


def intervals(
    title: str,
    of: str,
    rows: Mapping[str, Mapping[str, Interval]],
    columns: Sequence[Column] = (GONE_COLUMN, STRETCHES, EASY),
    unmet: Sequence[Sequence[str]] = (),
) -> bytes:
    """Draw measures of some rows.

    Args:
        title: of the figure.
        of: what it shows.
        rows: measures by name, of each row from above.
        columns: what is drawn of them.
        unmet: criteria that each row does not meet, if that is written beside it.

    Returns:
        The picture as PNG.
    """
    width = _WIDTH + (_WORDS if unmet else 0.0)
    size = Size(1, len(columns), width, _HEAD + _ROW * len(rows))
    made = grid(title, of, size, sharex=False)
    for axes, column in zip(made.axes[0], columns, strict=True):
        name(axes, column.title)
        axes.set_xlim(-0.02 * column.most, column.most)
        _draw(axes, column, list(rows.values()))
        _key(axes, column)
        axes.grid(visible=True, axis="x", color="#ededed")
    axes = made.axes[0, 0]
    axes.set_yticks(range(len(rows)), list(rows), fontsize=SMALL)
    axes.set_ylim(len(rows) - 0.5, -0.5)
    if unmet:
        _write(made.axes[0, -1], unmet)
    return png(made.figure)


def _draw(axes: Axes, column: Column, rows: Sequence[Mapping[str, Interval]]) -> None:
    """The dots of a column; in each row the first one is above."""
    scale = 100.0 if column.per_cent else 1.0
    for dots, aside in zip(column.dots, asides(len(column.dots))[::-1], strict=True):
        look = Look(dots.colour, aside, scale=scale)
        for row, measured in enumerate(rows):
            dot(axes, measured[dots.measure], row, look)


def _write(axes: Axes, unmet: Sequence[Sequence[str]]) -> None:
    """Write beside each row which criteria it does not meet."""
    beside = {"textcoords": "offset points", "annotation_clip": False}
    style = {"fontsize": SMALL - 1, "color": INK, **beside}
    head = {**style, "fontsize": SMALL + 1, "xycoords": "axes fraction"}
    axes.annotate("criteria not met", (1, 1), (_ASIDE, 4), **head)
    for row, words in enumerate(unmet):
        weight = "normal" if words else "bold"
        place = {"xycoords": ("axes fraction", "data"), "va": "center"}
        said = ", ".join(words) or f"none: {AS_INFANTS}"
        axes.annotate(said, (1, row), (_ASIDE, 0), weight=weight, **place, **style)


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
