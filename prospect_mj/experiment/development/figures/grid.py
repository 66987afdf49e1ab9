"""Small multiples in the frame of the other figures."""

from typing import Literal, NamedTuple

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from prospect_mj.experiment.paper.figures.figure_frame import (
    BLUE,
    GREEN,
    INK,
    SMALL,
    VERMILION,
)
from prospect_mj.experiment.populations.strategies import Strategy

GREY = "#8a8a8a"
COLOURS = {
    Strategy.LATE: VERMILION,
    Strategy.EARLY: GREEN,
    Strategy.OPTIMAL: BLUE,
    Strategy.OTHER: GREY,
}
"""The same as in the paper's figures."""

_TITLE, _LINE = 12, 14.0
"""Size of the title, and height of a line below it [points]."""
_POINTS = 72.0


class Grid(NamedTuple):
    """Panels of one figure."""

    figure: Figure
    axes: NDArray[np.object_]
    """(rows, columns) of Axes."""


class Size(NamedTuple):
    """Of a figure."""

    rows: int
    columns: int
    width: float = 8.0
    """[inches]"""
    height: float = 6.0
    """[inches]"""


def grid(
    title: str,
    of: str,
    size: Size,
    sharex: bool = True,
    sharey: bool | Literal["row"] = True,
) -> Grid:
    """Empty panels under a heading.

    Args:
        title: of the figure.
        of: what is shown; may have several lines.
        size: panels, and the figure's own.
        sharex: whether all panels have one axis of x.
        sharey: the same of y, or all of a row.
    """
    figure = Figure((size.width, size.height), dpi=150, layout="constrained")
    lines = 1 + of.count("\n")
    top = 1 - (_LINE * (lines + 1.6)) / _POINTS / size.height
    figure.get_layout_engine().set(rect=(0, 0, 1, top))
    _heading(figure, title, of, size.height)
    shape = {"nrows": size.rows, "ncols": size.columns, "squeeze": False}
    axes = figure.subplots(**shape, sharex=sharex, sharey=sharey)
    for one in axes.flat:
        tidy(one)
    return Grid(figure, axes)


def tidy(axes: Axes) -> None:
    """Take away all that shows nothing."""
    axes.spines[["top", "right"]].set_visible(False)
    axes.grid(axis="y", color="#e6e6e6", linewidth=0.8)
    axes.set_axisbelow(True)
    axes.tick_params(labelsize=SMALL)


def name(axes: Axes, words: str) -> None:
    """Name a panel above its left corner."""
    style = {"loc": "left", "fontsize": SMALL + 1, "color": INK, "pad": 4}
    axes.set_title(words, **style)


def _heading(figure: Figure, title: str, of: str, height: float) -> None:
    step = _LINE / _POINTS / height
    style = {"ha": "left", "va": "top"}
    figure.text(
        0.01, 1 - 0.3 * step, title, fontsize=_TITLE, fontweight="bold", **style
    )
    place = 0.01, 1 - 1.7 * step
    figure.text(*place, of, fontsize=SMALL, color=INK, linespacing=1.4, **style)
