"""What all figures of the experiment share: their frame, heading and floor."""

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np
import pyarrow as pa
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from prospect_mj.experiment.paper.measures.bootstrap import Floats
from prospect_mj.experiment.run.learning_curve import BLOCK

BLUE, GREEN, VERMILION = "#0072b2", "#009e73", "#d55e00"
"""Colours that the colour-blind tell apart (Okabe and Ito, Color Universal Design: How
to make figures and presentations that are friendly to colorblind people, 2008)."""
INK = "#4d4d4d"
"""Of words and thin lines."""
SHADE = "#f3f1ea"
"""Of the pretraining."""
SMALL = 9
"""Size of words in a figure [points]."""

_WIDTH = 8.0


class Heading(NamedTuple):
    """What a figure says it shows."""

    title: str
    of: str
    """What its curves are."""
    pretrain: int = 0
    """Trials of pretraining."""


def panels(heading: Heading, height: float, ratios: tuple[float, ...]) -> list[Axes]:
    """Panels of one figure, one upon the other, with one axis of trials.

    Args:
        heading: stands over the first one.
        height: of the figure [inches].
        ratios: the panels' heights relative to each other.
    """
    figure = Figure(figsize=(_WIDTH, height), dpi=150, layout="constrained")
    grid = figure.subplots(
        len(ratios), sharex=True, squeeze=False, height_ratios=ratios
    )
    axes = list(grid[:, 0])
    for one in axes:
        one.spines[["top", "right"]].set_visible(False)
        one.grid(axis="y", color="#e6e6e6", linewidth=0.8)
        one.set_axisbelow(True)
    axes[-1].set_xlabel("trial")
    _write_over(axes[0], heading)
    return axes


def set_trials(axes: list[Axes], heading: Heading, trials: Floats) -> None:
    """Set the axis of trials up to the last set of ten that begins with `trials` (s,).

    Pretraining is shaded, also where nothing is drawn in it, so that all figures have
    the same axis.
    """
    axes[0].set_xlim(0, trials[-1] + BLOCK)
    if not heading.pretrain:
        return
    for one in axes:
        one.axvspan(0, heading.pretrain, color=SHADE, lw=0, zorder=0)
    shown = "one orientation" if trials[0] < heading.pretrain else "no such trials"
    _write_phase(axes[0], 0, f"pretraining: {shown}")
    _write_phase(axes[0], heading.pretrain, "random orientations")


def draw_floor(
    axes: Axes, trials: Floats, optimum: Floats, exploring: float | None = None
) -> None:
    """Draw the best possible mean of every set of ten.

    Args:
        axes: of actions per trial.
        trials: (s,), the first one of each set.
        optimum: (s,) [actions].
        exploring: the best possible for who explores as the learner does [actions].
    """
    edges = np.append(trials, trials[-1] + BLOCK)
    axes.stairs(optimum, edges, baseline=None, color=INK, linewidth=1)
    words = f"best possible: {optimum[-1]:.2f}"
    if exploring is not None:
        axes.axhline(exploring, color=INK, linewidth=0.8, linestyle=(0, (1, 1.5)))
        words += f"\nwith exploration: {exploring:.2f} (dotted)"
    write(
        axes,
        words,
        (edges[-1], optimum[-1]),
        (0, -6),
        ha="right",
        va="top",
        linespacing=1.3,
    )


def write(
    axes: Axes,
    words: str,
    place: tuple[float, float],
    offset: tuple[float, float],
    **style: object,
) -> None:
    """Write a few words beside a place in the data, by an offset [points]."""
    usual = {"fontsize": SMALL, "color": INK, "textcoords": "offset points"}
    axes.annotate(words, place, xytext=offset, **(usual | style))


def segments(heading: Heading, trials: Floats) -> list[slice]:
    """The sets of pretraining, and those after it; between the two no line is drawn."""
    switch = int(np.searchsorted(trials, heading.pretrain))
    return [part for part in (slice(switch), slice(switch, None)) if len(trials[part])]


def middles(trials: Floats) -> Floats:
    """Where sets of ten that begin with `trials` (s,) are drawn."""
    return trials + BLOCK / 2


def columns(table: pa.Table) -> Mapping[str, Floats]:
    """The columns of a table by name, each (n,)."""
    return {name: table[name].to_numpy() for name in table.column_names}


def _write_over(axes: Axes, heading: Heading) -> None:
    """Title and what the curves are, above the words for the phases."""
    lift = 14 if heading.pretrain else 0
    top = {"xycoords": "axes fraction", "va": "bottom"}
    title = {"fontsize": 12, "fontweight": "bold", "color": "black"}
    write(axes, heading.title, (0, 1), (0, 24 + lift), **top, **title)
    write(axes, heading.of, (0, 1), (0, 8 + lift), **top)


def _write_phase(axes: Axes, trial: int, words: str) -> None:
    place = axes.get_xaxis_transform()
    write(axes, words, (trial, 1), (3, 3), xycoords=place, va="bottom", style="italic")
