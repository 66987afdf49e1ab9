"""What the fingers feel of both ends of a jar, and how well that tells them apart."""

from collections.abc import Mapping, Sequence

import numpy as np
import pyarrow as pa
import pyarrow.compute as pc
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Ellipse
from matplotlib.ticker import PercentFormatter

from prospect_mj.experiment.development.figures.grid import GREY, Size, grid, name
from prospect_mj.experiment.development.haptics import ends
from prospect_mj.experiment.development.haptics.grasp import (
    CRADLE,
    HAND_OVER,
    KINDS,
    Grasp,
)
from prospect_mj.experiment.paper.figures.figure_frame import (
    BLUE,
    INK,
    SMALL,
    VERMILION,
)
from prospect_mj.experiment.run.plots import png
from prospect_mj.haptics import TrajectoryModels

_BY = {
    ends.BITS: GREY,
    ends.FIRST_TOUCH: "#8fc1e3",
    ends.CATEGORY: BLUE,
    ends.TIME: "#8c5a00",
}
_ENDS = {"body": BLUE, "lid": VERMILION}
"""In the order of their numbers."""
_PLURAL = {CRADLE: "grasps out of the cradle", HAND_OVER: "hand-overs"}
_DEVIATIONS = 2


def portraits(
    grasps: Mapping[str, Sequence[Grasp]], models: Mapping[str, TrajectoryModels]
) -> bytes:
    """Draw the phase portraits of the grasps of some jars, and their models.

    Args:
        grasps: of each jar.
        models: of each jar.

    Returns:
        The picture as PNG.
    """
    of = (
        "paths of grasps, and their models: ellipses at two deviations, dotted after "
        "a correction of the hand"
    )
    size = Size(len(KINDS), len(grasps), max(2.6 * len(grasps), 8.0), 6.0)
    made = grid("Phase portraits of grasps", of, size)
    for column, (jar, felt) in zip(made.axes.T, grasps.items(), strict=True):
        corrected = any(len(np.unique(grasp.samples[:, 2])) > 1 for grasp in felt)
        for axes, kind in zip(column, KINDS, strict=True):
            _draw_models(axes, models[jar], corrected)
            shown = [grasp for grasp in felt if grasp.kind == kind]
            for end, colour in enumerate(_ENDS.values()):
                _draw_grasps(axes, [g for g in shown if g.end == end], colour)
            name(axes, f"{jar}\n{len(shown)} {_PLURAL[kind]}")
        column[-1].set_xlabel("residual ε [1]")
    for axes in made.axes[:, 0]:
        axes.set_ylabel("rate dε/dt [1/s]")
    first = made.axes[0, 0]
    for end, colour in _ENDS.items():
        first.plot([], [], "o", ms=4, color=colour, label=f"held by the {end}")
    _name_below(made.figure, first)
    return png(made.figure)


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
    _name_below(made.figure, axes)
    return png(made.figure)


def _name_below(figure: Figure, axes: Axes) -> None:
    """One legend for all panels, of what is in one of them."""
    handles, labels = axes.get_legend_handles_labels()
    style = {"frameon": False, "fontsize": SMALL, "ncols": len(labels)}
    figure.legend(handles, labels, loc="outside lower center", **style)


def _draw_models(axes: Axes, models: TrajectoryModels, corrected: bool) -> None:
    """An ellipse at two deviations round each mean, dotted for later probes.

    Args:
        axes: where.
        models: which.
        corrected: whether there are later probes.
    """
    for path, deviations in zip(models.mean, models.deviation, strict=True):
        for stage in range(1 + corrected):
            mean, size = path[stage], 2 * _DEVIATIONS * np.array(deviations[stage])
            style = {"fc": "none", "ec": INK, "lw": 1, "ls": ["-", ":"][stage]}
            axes.add_patch(Ellipse(mean, *size, **style))


def _draw_grasps(axes: Axes, grasps: Sequence[Grasp], colour: str) -> None:
    """Each grasp as a thin line through its samples."""
    for grasp in grasps:
        path = grasp.samples[:, :2].T
        axes.plot(*path, marker="o", ms=2.5, lw=0.5, alpha=0.6, color=colour)


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
