"""The paper's figure 6, drawn from its table: strategies, and corrections enlarged."""

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np
import pyarrow as pa
import pyarrow.compute as pc
from matplotlib.axes import Axes
from matplotlib.ticker import PercentFormatter

from prospect_mj.experiment.paper.figures.direct_labels import Named, write_names
from prospect_mj.experiment.paper.figures.figure_frame import (
    BLUE,
    GREEN,
    INK,
    VERMILION,
    Heading,
    columns,
    middles,
    panels,
    segments,
    set_trials,
    write,
)
from prospect_mj.experiment.paper.figures.figure_tables import CORRECTION
from prospect_mj.experiment.paper.measures.bootstrap import Floats
from prospect_mj.experiment.run.plots import png

Strategies = Mapping[str, Mapping[str, Floats]]


class _Look(NamedTuple):
    """How a strategy is drawn."""

    name: str
    colour: str


LOOKS = {
    "optimal": _Look("optimal", BLUE),
    "other": _Look("other or truncated", "#707070"),
    CORRECTION: _Look("early or late correction", "#8c5a00"),
    "early": _Look("early correction", GREEN),
    "late": _Look("late correction", VERMILION),
}
_SUM, _PARTS = ("optimal", "other", CORRECTION), ("early", "late")
_ROOM = 1.25


def strategies(table: pa.Table, heading: Heading, trials: str) -> bytes:
    """Draw figure 6: the share of each strategy.

    Above, the three classes that add up to all trials; below, the two kinds of
    corrections on a larger scale.

    Args:
        table: under `figure_tables.STRATEGY_SCHEMA`.
        heading: what it says it shows.
        trials: the kind of trials that the shares are of.

    Returns:
        The picture as PNG.
    """
    shown = {
        name: columns(table.filter(pc.field("strategy") == name)) for name in LOOKS
    }
    above, below = panels(heading, 6.2, (3, 2))
    set_trials([above, below], heading, shown["optimal"]["trial"])
    for axes in (above, below):
        axes.yaxis.set_major_formatter(PercentFormatter(1, decimals=0, symbol=" %"))
        axes.set_ylabel(f"share of {trials} trials")
    above.set_ylim(0, 1.09)
    highest = max(shown[name]["high"].max() for name in _PARTS)
    below.set_ylim(0, _ROOM * max(highest, 0.01))
    best = _draw_best_share(above, table)
    _draw(above, heading, shown, _SUM, [best])
    write(below, "corrections, enlarged", (0, 1), (3, 3), xycoords="axes fraction")
    _draw(below, heading, shown, _PARTS, [])
    return png(above.figure)


def _draw(
    axes: Axes,
    heading: Heading,
    shown: Strategies,
    names: Sequence[str],
    lines: Sequence[Floats],
) -> None:
    """Draw strategies with their bands and names."""
    for name in names:
        rows, look = shown[name], LOOKS[name]
        for part in segments(heading, rows["trial"]):
            places = middles(rows["trial"][part])
            low, high = rows["low"][part], rows["high"][part]
            axes.fill_between(places, low, high, color=look.colour, alpha=0.25, lw=0)
            axes.plot(places, rows["share"][part], color=look.colour, lw=1.5)
    switch = np.column_stack([2 * [heading.pretrain], axes.get_ylim()])
    named = [_named(shown[name], LOOKS[name]) for name in names]
    write_names(axes, named, [*lines, switch])


def _named(rows: Mapping[str, Floats], look: _Look) -> Named:
    places = middles(rows["trial"])
    bounds = (np.column_stack([places, rows[n]]) for n in ("share", "low", "high"))
    return Named(look.name, look.colour, list(bounds))


def _draw_best_share(axes: Axes, table: pa.Table) -> Floats:
    """Draw the best possible share of the optimal strategy, where there are trials.

    Returns:
        (2, 2), the ends of its line in the data.
    """
    share, first = table["optimum"][0].as_py(), pc.min(table["trial"]).as_py()
    ends = np.array([[first, share], [axes.get_xlim()[1], share]])
    axes.plot(*ends.T, color=INK, linewidth=1)
    words = f"best possible: {100 * share:.0f} % optimal"
    write(axes, words, tuple(ends[1]), (0, 3), ha="right", va="bottom")
    return ends
