"""Shares of the strategies by trial, a panel for each population."""

from collections.abc import Iterable, Sequence
from typing import NamedTuple

import numpy as np
from matplotlib.axes import Axes
from matplotlib.ticker import PercentFormatter

from prospect_mj.experiment.development.figures.grid import (
    COLOURS,
    Size,
    grid,
    name,
)
from prospect_mj.experiment.development.measures.development import Development
from prospect_mj.experiment.paper.figures.figure_frame import (
    BLUE,
    SMALL,
    middles,
)
from prospect_mj.experiment.paper.measures.bootstrap import Floats, band
from prospect_mj.experiment.populations.strategies import Strategy
from prospect_mj.experiment.run.learning_curve import BLOCK
from prospect_mj.experiment.run.plots import png

_SHADE = 0.25
_ROW = 1.75
"""Height of a panel [inches]."""
_HEAD = 1.0
"""Of the heading and the axis [inches]."""
_OVER, _NAMED = 1.24, 1.15
"""Top of a panel, and height of the names in it [1]."""
_LEAST_NAMED = 0.1
"""Largest share of a strategy that needs no name, as it is hardly there."""
_NEAR = 0.95
_GAP = 9.0
"""Between names [pixels]."""


class Panel(NamedTuple):
    """A population whose strategies are drawn."""

    title: str
    development: Development
    trials: str = "difficult"
    """Which ones the shares are of: `difficult` or `easy`."""
    beside: bool = True
    """Whether the optimal share of the other trials is drawn, dotted."""


def shares(
    title: str,
    of: str,
    panels: Sequence[Sequence[Panel]],
    axis: str = "trial after the pretraining",
) -> bytes:
    """Draw the shares of late, early, optimal and other, with their bands.

    Args:
        title: of the figure.
        of: what it shows.
        panels: row by row, as many in each.
        axis: what the trials are counted from.

    Returns:
        The picture as PNG.
    """
    rows, columns = len(panels), len(panels[0])
    size = Size(rows, columns, max(8.0, 3.6 * columns), _HEAD + _ROW * rows)
    made = grid(title, of, size)
    for axes, panel in zip(made.axes.flat, _flat(panels), strict=True):
        name(axes, panel.title)
        axes.set_ylim(0, _OVER)
        axes.set_yticks([0, 0.5, 1])
        axes.yaxis.set_major_formatter(PercentFormatter(1, decimals=0, symbol=" %"))
        trials = _trials(panel)
        axes.set_xlim(0, trials[-1] + BLOCK)
        _draw(axes, panel, trials)
    for axes in made.axes[-1]:
        axes.set_xlabel(axis)
    # All names at last: where panels are is known only when all have their words.
    made.figure.draw_without_rendering()
    for axes, panel in zip(made.axes.flat, _flat(panels), strict=True):
        _write_names(axes, panel, middles(_trials(panel)))
    return png(made.figure)


def _flat(panels: Iterable[Sequence[Panel]]) -> list[Panel]:
    return [panel for row in panels for panel in row]


def _trials(panel: Panel) -> Floats:
    curves = panel.development.mean
    return BLOCK * np.arange(curves.actions.shape[1] - curves.switch, dtype=float)


def _curve(panel: Panel, kind: Strategy, trials: str | None = None) -> Floats:
    """(3, s): share of a strategy, and its bounds."""
    once, many = (
        getattr(one, trials or panel.trials).strategies[:, kind, one.switch :]
        for one in panel.development
    )
    return np.concatenate([once, band(many)])


def _draw(axes: Axes, panel: Panel, trials: Floats) -> None:
    places = middles(trials)
    for kind, colour in COLOURS.items():
        share, low, high = _curve(panel, kind)
        axes.fill_between(places, low, high, color=colour, alpha=_SHADE, lw=0)
        axes.plot(places, share, color=colour, linewidth=1.4)
    if panel.beside:
        style = {"color": BLUE, "linewidth": 1.0, "linestyle": (0, (1, 1.5))}
        axes.plot(places, _beside(panel), **style)


def _beside(panel: Panel) -> Floats:
    other = "easy" if panel.trials == "difficult" else "difficult"
    return _curve(panel, Strategy.OPTIMAL, other)[0]


def _write_names(axes: Axes, panel: Panel, places: Floats) -> None:
    """Name the strategies above the panel, in the order in which they prevail.

    Each name is at the place where its share first comes near to its largest, or, where
    others are there, right of these.
    """
    peaks = {
        kind: places[np.argmax(share >= _NEAR * np.nanmax(share))]
        for kind in COLOURS
        if np.nanmax(share := _curve(panel, kind)[0]) > _LEAST_NAMED
    }
    to_pixels, to_data = axes.transData, axes.transData.inverted()
    extent = axes.get_window_extent()
    free = extent.x0 + _GAP
    for kind, peak in sorted(peaks.items(), key=lambda pair: pair[1]):
        style = {"color": COLOURS[kind], "fontsize": SMALL, "fontweight": "bold"}
        text = axes.text(0, _NAMED, kind.name.lower(), va="center", **style)
        text.set_in_layout(False)
        width = text.get_window_extent().width
        middle = to_pixels.transform((peak, 0))[0]
        left = max(min(middle - width / 2, extent.x1 - width), free)
        text.set_x(to_data.transform((left, 0))[0])
        free = left + width + _GAP
