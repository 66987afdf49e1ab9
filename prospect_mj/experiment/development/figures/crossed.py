"""A crossed table of the causal part: when corrections are gone, by inertia."""

from collections.abc import Callable, Sequence

import numpy as np
from matplotlib.axes import Axes

from prospect_mj.experiment.development.claims.unmet import unmet
from prospect_mj.experiment.development.figures.dots import BEYOND, Look, asides, dot
from prospect_mj.experiment.development.figures.grid import Grid, Size, grid, name
from prospect_mj.experiment.development.figures.intervals import AS_INFANTS
from prospect_mj.experiment.development.study.measured import Measured
from prospect_mj.experiment.paper.figures.figure_frame import (
    BLUE,
    GREEN,
    INK,
    SHADE,
    SMALL,
    VERMILION,
)
from prospect_mj.experiment.run.plots import png

_KINDS = {"late_gone": VERMILION, "early_gone": GREEN}
_LEAD = "#d9e8d9"
_WIDTH = 0.5
_HALF = 0.47
"""Of the ground of a row that does as infants do."""
_TOP = BEYOND + 520
"""Of a panel [trials], with room for words."""
_SIZE = SMALL - 1.5
"""Of words in a panel [points]."""
_LINE = 95
"""Height of one [trials]."""

Find = Callable[[str, str, float], Measured]
"""The row of a line, a column and a rate."""


def crossed(
    title: str,
    of: str,
    lines: Sequence[str],
    columns: Sequence[str],
    rates: Sequence[float],
    find: Find,
) -> bytes:
    """Draw when late and early corrections are gone, against the least rate.

    Args:
        title: of the figure.
        of: what it shows.
        lines: names of the rows of panels.
        columns: names of the columns of panels.
        rates: in each panel, from the left.
        find: gives the numbers.

    Returns:
        The picture as PNG.
    """
    size = Size(len(lines), len(columns), 9.0, 1.1 + 1.9 * len(lines))
    made = grid(title, of, size)
    for (row, column), axes in np.ndenumerate(made.axes):
        name(axes, f"{lines[row]}, {columns[column]}")
        found = [find(lines[row], columns[column], rate) for rate in rates]
        _draw(axes, found)
        axes.set_ylim(0, _TOP)
        axes.set_xlim(-0.5, len(rates) - 0.5)
        axes.set_xticks(range(len(rates)), [f"{rate:g}" for rate in rates])
    _label(made)
    return png(made.figure)


def _draw(axes: Axes, rows: Sequence[Measured]) -> None:
    for place, one in enumerate(rows):
        lead = one.measured["early_lead"].estimate
        axes.bar(place, lead, width=_WIDTH, color=_LEAD, zorder=0)
        for (measure, colour), aside in zip(
            _KINDS.items(), asides(len(_KINDS)), strict=True
        ):
            look = Look(colour, aside, upright=True)
            dot(axes, one.measured[measure], place, look)
        _write(axes, place, one)


def _write(axes: Axes, place: int, one: Measured) -> None:
    """Write the easy trials of a row above it, and what it does not meet."""
    lacking = unmet(one)
    easy = f"{100 * one.measured['easy_worst'].estimate:.0f} %"
    style = {"ha": "center", "va": "top", "fontsize": _SIZE, "linespacing": 1.15}
    axes.annotate(easy, (place, _TOP), color=BLUE, **style)
    words, weight = ("\n".join(lacking), "normal") if lacking else (AS_INFANTS, "bold")
    axes.annotate(words, (place, _TOP - _LINE), color=INK, weight=weight, **style)
    if not lacking:
        axes.axvspan(place - _HALF, place + _HALF, color=SHADE, zorder=-1)


def _label(made: Grid) -> None:
    for axes in made.axes[:, 0]:
        axes.set_ylabel("trials")
        axes.set_yticks(range(0, BEYOND, 200))
    for axes in made.axes[-1]:
        axes.set_xlabel("least rate")
