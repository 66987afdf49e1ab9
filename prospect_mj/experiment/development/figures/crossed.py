"""A crossed table of the causal part: when corrections are gone, by inertia."""

from collections.abc import Callable, Sequence
from math import isinf, isnan

import numpy as np
from matplotlib.axes import Axes

from prospect_mj.experiment.development.claims.criteria import CONFIDENT
from prospect_mj.experiment.development.figures.grid import Grid, Size, grid, name
from prospect_mj.experiment.development.figures.intervals import BEYOND
from prospect_mj.experiment.development.study.measured import Measured
from prospect_mj.experiment.paper.figures.figure_frame import (
    GREEN,
    INK,
    SMALL,
    VERMILION,
)
from prospect_mj.experiment.run.plots import png

_KINDS = {"late_gone": VERMILION, "early_gone": GREEN}
_LEAD = "#d9e8d9"
_WIDTH = 0.5
_TOP = BEYOND + 130
"""Of a panel [trials], with room for words."""

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
    size = Size(len(lines), len(columns), 8.0, 1.1 + 1.55 * len(lines))
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
        for measure, colour in _KINDS.items():
            found = one.measured[measure]
            if isnan(found.estimate):
                continue
            low, value, high = (
                min(part, BEYOND) if not isnan(part) else found.estimate
                for part in (found.low, found.estimate, found.high)
            )
            axes.plot([place, place], [low, high], color=colour, linewidth=1.4)
            marker = "^" if isinf(found.estimate) else "o"
            axes.plot(place, value, marker, color=colour, markersize=4.5)
        if one.order >= CONFIDENT:
            style = {"ha": "center", "va": "top", "fontsize": SMALL - 1, "color": INK}
            axes.annotate("late first", (place, _TOP - 10), **style)


def _label(made: Grid) -> None:
    for axes in made.axes[:, 0]:
        axes.set_ylabel("trials")
    for axes in made.axes[-1]:
        axes.set_xlabel("least rate")
