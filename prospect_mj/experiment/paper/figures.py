"""The paper's figures 5 and 6, drawn from their tables."""

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np
import pyarrow as pa
import pyarrow.compute as pc
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import PercentFormatter

from prospect_mj.experiment.learning_curve import BLOCK
from prospect_mj.experiment.paper.bands import Floats
from prospect_mj.experiment.paper.figure_tables import CORRECTION
from prospect_mj.experiment.plots import png

_LINE = "#1f4e79"
_LIVE = "#c8611a"
_GREY = "#7d7d7d"
_SHADE = "#f4efe2"
_SHADE_TEXT = "#8a7a4a"
_LEGEND = {"frameon": False, "fontsize": 9, "columnspacing": 1.6}
_DOTTED = (0, (1, 1.6))
_COLOURS = {
    "optimal": _LINE,
    "early": "#2a9d6f",
    "late": "#c8611a",
    "other": "#a9b2bb",
    CORRECTION: "#7a3b8f",
}
_LABELS = {
    "optimal": "optimal",
    "early": "early correction",
    "late": "late correction",
    "other": "other or cut off",
    CORRECTION: "any correction",
}


class Heading(NamedTuple):
    """What a figure says it shows."""

    title: str
    of: str
    """What its curves are."""
    pretrain: int = 0
    """Trials of pretraining."""
    shaded: str = "pretraining, one orientation"
    """What to write over them."""


class Mark(NamedTuple):
    """A number that the paper states, to be marked in a figure."""

    trial: int
    actions: float
    text: str
    offset: tuple[int, int] = (14, 26)
    """Of the text [points]."""


def actions(
    table: pa.Table, heading: Heading, cap: int, marks: Sequence[Mark]
) -> bytes:
    """Draw figure 5: actions per trial.

    Args:
        table: under `figure_tables.ACTIONS_SCHEMA`.
        heading: what it says it shows.
        cap: where trials are cut off [actions].
        marks: what the paper says.

    Returns:
        The picture as PNG.
    """
    columns = _columns(table)
    figure, axes = _frame(heading, int(columns["trial"][-1]), "actions per trial")
    axes.set_ylim(0, 1.1 * cap)
    middles = columns["trial"] + BLOCK / 2
    axes.fill_between(
        middles, columns["low"], columns["high"], color=_LINE, alpha=0.35, lw=0
    )
    axes.plot(middles, columns["actions"], color=_LINE, linewidth=1.2)
    _draw_floor(axes, columns["trial"], columns["optimum"])
    for mark in marks:
        _draw_mark(axes, mark)
    return png(figure)


def strategies(table: pa.Table, heading: Heading) -> bytes:
    """Draw figure 6: the share of each strategy.

    Args:
        table: under `figure_tables.STRATEGY_SCHEMA`.
        heading: what it says it shows.

    Returns:
        The picture as PNG.
    """
    last = pc.max(table["trial"]).as_py()
    figure, axes = _frame(heading, last, "share of trials")
    # Room for the words above a best share of all trials.
    axes.set_ylim(0, 1.2)
    axes.set_yticks(np.linspace(0, 1, 6))
    axes.yaxis.set_major_formatter(PercentFormatter(1, decimals=0, symbol=" %"))
    for strategy, colour in _COLOURS.items():
        rows = _columns(table.filter(pc.field("strategy") == strategy))
        middles = rows["trial"] + BLOCK / 2
        style = _DOTTED if strategy == CORRECTION else "-"
        label = _LABELS[strategy]
        axes.plot(
            middles, rows["share"], color=colour, linestyle=style, lw=1.8, label=label
        )
        if strategy != CORRECTION:
            low, high = rows["low"], rows["high"]
            axes.fill_between(middles, low, high, color=colour, alpha=0.25, lw=0)
    _draw_best_share(axes, table)
    figure.legend(loc="outside lower center", ncols=len(_COLOURS), **_LEGEND)
    return png(figure)


def live(
    table: pa.Table, heading: Heading, cap: int, optimum: float, runs: int
) -> bytes:
    """Draw the mean of live runs on the band of as many recorded ones.

    Args:
        table: under `live_check.SCHEMA`.
        heading: what it says it shows.
        cap: where trials are cut off [actions].
        optimum: the best possible mean [actions].
        runs: live ones.

    Returns:
        The picture as PNG.
    """
    columns = _columns(table)
    trials = columns["trial"]
    figure, axes = _frame(heading, int(trials[-1]), "actions per trial")
    axes.set_ylim(0, 1.1 * cap)
    middles = trials + BLOCK / 2
    axes.fill_between(
        middles,
        columns["low"],
        columns["high"],
        color=_LINE,
        alpha=0.18,
        lw=0,
        label=f"95 % of means of {runs} recorded runs, as a whole",
    )
    axes.plot(middles, columns["recorded"], color=_LINE, lw=1.2, label="all recorded")
    axes.plot(middles, columns["live"], color=_LIVE, lw=1.8, label=f"{runs} live runs")
    _draw_floor(axes, trials, np.full(len(trials), optimum))
    figure.legend(loc="outside lower center", ncols=3, **_LEGEND)
    return png(figure)


def _frame(heading: Heading, last: int, y_label: str) -> tuple[Figure, Axes]:
    """An empty figure up to the set of ten that begins with trial `last`."""
    figure = Figure(figsize=(8, 4.5), dpi=150, layout="constrained")
    axes = figure.add_subplot()
    axes.set_title(heading.title, loc="left", fontsize=12, fontweight="bold", pad=12)
    axes.set(xlabel="trial", ylabel=y_label, xlim=(0, last + BLOCK))
    axes.spines[["top", "right"]].set_visible(False)
    axes.grid(axis="y", color="#ececec", linewidth=0.8)
    axes.set_axisbelow(True)
    _draw_words(axes, heading)
    return figure, axes


def _draw_words(axes: Axes, heading: Heading) -> None:
    """What the curve is, at the right; what the shade is, at the left."""
    _write(axes, heading.of, (1, 0.96), "right")
    if heading.pretrain:
        axes.axvspan(0, heading.pretrain, color=_SHADE, zorder=0)
        axes.axvline(heading.pretrain, color=_SHADE_TEXT, linewidth=1)
        _write(axes, heading.shaded, (0, 0.96), "left", _SHADE_TEXT)


def _write(
    axes: Axes, text: str, place: tuple[float, float], side: str, colour: str = _GREY
) -> None:
    """Write a few words at a place (2,) given as shares of the width and height."""
    axes.annotate(
        text,
        place,
        xycoords="axes fraction",
        xytext=(-4 if side == "right" else 6, 0),
        textcoords="offset points",
        ha=side,
        va="center",
        fontsize=9,
        color=colour,
    )


def _draw_floor(axes: Axes, trials: Floats, optimum: Floats) -> None:
    """Draw the best possible mean of every set of ten."""
    edges = np.append(trials, trials[-1] + BLOCK)
    axes.stairs(optimum, edges, baseline=None, color=_GREY, linewidth=1)
    height = axes.get_ylim()[1]
    words = f"best possible: {optimum[-1]:.2f}"
    _write(axes, words, (1, (optimum[-1] - 0.04 * height) / height), "right")


def _draw_best_share(axes: Axes, table: pa.Table) -> None:
    """Draw the best possible share of the optimal strategy, where there are trials."""
    share, first = table["optimum"][0].as_py(), pc.min(table["trial"]).as_py()
    axes.hlines(share, first, axes.get_xlim()[1], color=_GREY, linewidth=1)
    height = axes.get_ylim()[1]
    words = f"best possible: {100 * share:.0f} %"
    _write(axes, words, (1, (share + 0.04 * height) / height), "right")


def _draw_mark(axes: Axes, mark: Mark) -> None:
    """A dot where the paper says that the curve is, its words on a short leader."""
    axes.annotate(
        f"paper: {mark.text}",
        (mark.trial, mark.actions),
        xytext=mark.offset,
        textcoords="offset points",
        fontsize=9,
        color=_GREY,
        arrowprops={"arrowstyle": "-", "color": _GREY, "linewidth": 0.8},
    )
    axes.plot(mark.trial, mark.actions, "o", color="white", mec=_GREY, markersize=6)


def _columns(table: pa.Table) -> Mapping[str, Floats]:
    """The columns of a table by name, each (n,)."""
    return {name: table[name].to_numpy() for name in table.column_names}
