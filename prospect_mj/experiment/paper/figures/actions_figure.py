"""The paper's figure 5, and live runs on recorded ones, drawn from their tables."""

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np
import pyarrow as pa
from matplotlib.axes import Axes

from prospect_mj.experiment.paper.figures.figure_frame import (
    BLUE,
    INK,
    SMALL,
    VERMILION,
    Heading,
    columns,
    draw_floor,
    middles,
    panels,
    segments,
    set_trials,
    write,
)
from prospect_mj.experiment.paper.measures.bootstrap import LEVEL, Floats
from prospect_mj.experiment.run.learning_curve import BLOCK, NEAR_OPTIMAL
from prospect_mj.experiment.run.plots import png

_PAPER = "#8b2f75"
_DOTTED = (0, (1, 2))
_DASHED = (0, (6, 3))


class Mark(NamedTuple):
    """A number that the paper states, to be marked in a figure."""

    trial: int
    text: str
    above: float | None = None
    """Number of actions that the mean is said to exceed there; None if the paper tells
    of the trial alone."""


def actions(
    table: pa.Table,
    heading: Heading,
    cap: int,
    marks: Sequence[Mark],
    exploring: float,
) -> bytes:
    """Draw figure 5: actions per trial.

    Args:
        table: under `figure_tables.ACTIONS_SCHEMA`.
        heading: what it says it shows.
        cap: where trials are cut off [actions].
        marks: what the paper says.
        exploring: the best possible mean at the end for who explores [actions].

    Returns:
        The picture as PNG.
    """
    data = columns(table)
    trials = data["trial"]
    (axes,) = panels(heading, 4.5, (1,))
    set_trials([axes], heading, trials)
    _draw_actions_axis(axes, cap)
    for mark in marks:
        _draw_mark(axes, mark)
    draw_floor(axes, trials, data["optimum"], exploring)
    _draw_near_optimal(axes, trials)
    for part in segments(heading, trials):
        _draw_curve(axes, *(data[n][part] for n in ("trial", "actions", "low", "high")))
    return png(axes.figure)


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
    data = columns(table)
    trials = data["trial"]
    above, below = panels(heading, 6, (3, 2))
    set_trials([above, below], heading, trials)
    _draw_actions_axis(above, cap)
    draw_floor(above, trials, np.full(len(trials), optimum))
    zero = np.zeros(len(trials))
    _draw_live(above, data, zero, runs)
    above.legend(loc="upper right", fontsize=SMALL, framealpha=1, edgecolor="white")
    _draw_live(below, data, data["recorded"], runs)
    below.set_ylabel("live minus recorded")
    return png(above.figure)


def _draw_actions_axis(axes: Axes, cap: int) -> None:
    axes.set_ylabel("actions per trial")
    axes.set_ylim(0, cap)


def _draw_curve(
    axes: Axes, trials: Floats, mean: Floats, low: Floats, high: Floats
) -> None:
    """A mean with its band."""
    axes.fill_between(middles(trials), low, high, color=BLUE, alpha=0.3, lw=0)
    axes.plot(middles(trials), mean, color=BLUE, linewidth=1.3)


def _draw_near_optimal(axes: Axes, trials: Floats) -> None:
    """The mean that counts as near-optimal here; the paper has no number for it."""
    axes.axhline(NEAR_OPTIMAL, color=INK, linewidth=0.8, linestyle=_DASHED)
    words = f"near-optimal here: {NEAR_OPTIMAL}"
    write(axes, words, (trials[0], NEAR_OPTIMAL), (5, 2), va="bottom")


def _draw_mark(axes: Axes, mark: Mark) -> None:
    """What the paper says: of a trial on a line without a height, else by an arrow."""
    style = {"color": _PAPER, "linespacing": 1.3}
    if mark.above is None:
        axes.axvline(mark.trial, color=_PAPER, linewidth=1, linestyle=_DOTTED)
        place = mark.trial, 0
        write(axes, mark.text, place, (-5, 4), ha="right", va="bottom", **style)
        return
    # A lower bound: a bar with an arrow upwards, in the middle of the set.
    foot = mark.trial + BLOCK / 2, mark.above
    write(axes, mark.text, foot, (10, 26), va="center", **style)
    arrow = {"arrowstyle": "<|-,head_width=0.25", "color": _PAPER, "fc": "white"}
    write(axes, "", foot, (0, 34), arrowprops=arrow | {"shrinkA": 0, "shrinkB": 0})
    axes.plot(*foot, marker="_", color=_PAPER, markersize=14)


def _draw_live(
    axes: Axes, data: Mapping[str, Floats], origin: Floats, runs: int
) -> None:
    """Live and recorded means with the band, all minus the origin (s,)."""
    places = middles(data["trial"])
    recorded, live, low, high = (
        data[name] - origin for name in ("recorded", "live", "low", "high")
    )
    axes.plot(places, live, color=VERMILION, lw=1.5, label=f"mean of {runs} live runs")
    outside = (data["live"] < data["low"]) | (data["live"] > data["high"])
    if outside.any():
        ring = {"color": VERMILION, "mfc": "white", "ms": 4, "ls": ""}
        ringed = places[outside], live[outside]
        axes.plot(*ringed, marker="o", label="outside of the band", **ring)
    axes.plot(places, recorded, color=BLUE, lw=1.3, label="mean of all recorded runs")
    band = f"simultaneous {100 * LEVEL:.0f} % band of means of {runs} recorded runs"
    axes.fill_between(places, low, high, color=BLUE, alpha=0.2, lw=0, label=band)
