"""How well what the fingers feel tells both ends of a jar apart."""

from collections.abc import Mapping, Sequence

import numpy as np
import pyarrow as pa
import pyarrow.compute as pc
from matplotlib.axes import Axes
from matplotlib.ticker import PercentFormatter

from prospect_mj.experiment.development.figures.grid import GREY, Size, grid, name
from prospect_mj.experiment.development.haptics import ends
from prospect_mj.experiment.development.haptics.grasp import KINDS
from prospect_mj.experiment.paper.figures.figure_frame import (
    BLUE,
    INK,
    SMALL,
)
from prospect_mj.experiment.run.plots import png

_BY = {
    ends.BITS: GREY,
    ends.FIRST_TOUCH: "#8fc1e3",
    ends.CATEGORY: BLUE,
    ends.TIME: "#8c5a00",
}


def separation(told: pa.Table) -> bytes:
    """Draw how often the end is told right, by what, with 95 % intervals.

    Args:
        told: under `ends.TOLD`.

    Returns:
        The picture as PNG.
    """
    jars = pc.unique(told["jar"]).to_pylist()
    title = "Which end is held, told right"
    of = "bars: share of grasps; lines: 95 % intervals; dotted: by chance"
    made = grid(title, of, Size(len(KINDS), 1, height=6.4))
    for axes, kind in zip(made.axes[:, 0], KINDS, strict=True):
        rows = told.filter(pc.field("kind") == kind).to_pylist()
        for place, (by, colour) in enumerate(_BY.items()):
            _draw_bars(axes, [r for r in rows if r["by"] == by], jars, place, colour)
        name(axes, kind)
        axes.axhline(0.5, color=INK, lw=0.8, ls=(0, (1, 2)))
        axes.set_ylim(0, 1.02)
        axes.yaxis.set_major_formatter(PercentFormatter(1, symbol=" %"))
    axes.set_xticks(range(len(jars)), jars)
    handles, labels = axes.get_legend_handles_labels()
    style = {"frameon": False, "fontsize": SMALL, "ncols": len(labels)}
    made.figure.legend(handles, labels, loc="outside lower center", **style)
    return png(made.figure)


def _draw_bars(
    axes: Axes,
    rows: Sequence[Mapping[str, float]],
    jars: Sequence[str],
    place: int,
    colour: str,
) -> None:
    width = 0.8 / len(_BY)
    where = [
        jars.index(row["jar"]) + (place - (len(_BY) - 1) / 2) * width for row in rows
    ]
    told, low, high = (
        np.array([row[n] for row in rows]) for n in ("told", "low", "high")
    )
    error = np.maximum([told - low, high - told], 0.0)
    whisker = {"ecolor": INK, "capsize": 2, "error_kw": {"lw": 1}}
    style = {"color": colour, "label": rows[0]["by"], "yerr": error}
    axes.bar(where, told, 0.9 * width, **style, **whisker)
