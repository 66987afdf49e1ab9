"""A picture of a harmonic function over two joints, with its streamlines."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import ListedColormap
from matplotlib.figure import Figure
from matplotlib.patches import Patch

from prospect_mj.experiment.corridor import LONGEST, decay
from prospect_mj.experiment.field_slice import FREE, GOAL, KINDS, Slice, joint_slice
from prospect_mj.experiment.plots import png
from prospect_mj.planning.streamline import Streamline

_INK = "#24313f"
_LINE = "#ffffff"
_DECAY = "#e4572e"
_TINTS = ("#d9c7b4", "#b9a48c", "#a8615a", "#8f9aa6", "#c8c29a")
"""Of what is in the way, in the order of `KINDS`."""
STARTS = np.array(
    [
        (-2.3, -0.6),
        (-2.3, 0.9),
        (-2.3, 2.3),
        (-1.3, -0.6),
        (-1.3, 1.6),
        (-0.6, 2.4),
        (-0.3, -0.6),
        (-0.3, 0.6),
        (0.15, 1.75),
        (0.45, 1.6),
        (0.6, 1.2),
        (0.95, 2.35),
        (1.5, 2.3),
        (2.3, 2.3),
        (2.4, -0.6),
        (1.3, -0.7),
        (2.35, 1.4),
    ]
)
"""Where streamlines begin [rad]."""
_LIMITS = (
    (
        np.log10(np.finfo(float).eps / 2),
        "1 \N{MINUS SIGN} u is 1: its gradient is lost",
    ),
    (np.log10(np.finfo(float).smallest_subnormal), "u is 0 in double precision"),
)
"""Values of log10 u from which on down a form is of no use, and what it does there."""


def field_picture() -> bytes:
    """Draw the slice, and u along a corridor beside it.

    Returns:
        The picture as PNG.
    """
    return png(drawing(joint_slice()))


def drawing(shown: Slice) -> Figure:
    """The figure of a slice."""
    lines = shown.streamlines(STARTS)
    figure = Figure(figsize=(13, 5.4), dpi=110, layout="constrained")
    left, right = figure.subplots(1, 2, width_ratios=(1.9, 1))
    _draw_space(left, shown, lines)
    _draw_decay(right)
    return figure


def _draw_space(axes: Axes, shown: Slice, lines: list[Streamline]) -> None:
    grid = shown.grid
    extent = (grid.low[0], grid.high[0], grid.low[1], grid.high[1])
    obstacle = np.ma.masked_equal(shown.obstacle, FREE)
    tints = ListedColormap(list(_TINTS))
    axes.imshow(
        obstacle.T, origin="lower", extent=extent, cmap=tints, vmin=0.5, vmax=5.5
    )
    log_u = np.ma.masked_invalid(shown.field.log_u / np.log(10))
    levels = np.arange(np.floor(log_u.min()), 1.0)
    centres = [grid.centres(axis) for axis in range(2)]
    filled = axes.contourf(*centres, log_u.T, levels=levels, cmap="viridis")
    for line in lines:
        axes.plot(*line.points.T, color=_LINE, linewidth=1.2)
        axes.plot(*line.points[0], "o", color=_LINE, markersize=3.5)
    axes.plot(*GOAL, "*", color="#ffd23f", markeredgecolor=_INK, markersize=17)
    axes.figure.colorbar(filled, ax=axes, pad=0.01)
    axes.set(aspect="auto", xlim=extent[:2], ylim=extent[2:])
    axes.set_xlabel("shoulder J1 [rad]")
    axes.set_ylabel("elbow J4 [rad]")
    axes.set_title("log10 u, the goal a star, and streamlines from the dots")
    patches = [Patch(color=c, label=k) for c, k in zip(_TINTS, KINDS, strict=True)]
    axes.legend(handles=patches, loc="upper center", ncols=5, fontsize=8.5)


def _draw_decay(axes: Axes) -> None:
    """Plot u along a corridor, against what double precision can hold."""
    widths, log_u = decay()
    axes.plot(widths, log_u, color=_DECAY, linewidth=2.4)
    for limit, words in _LIMITS:
        reached = float(np.interp(limit, log_u[::-1], widths[::-1]))
        axes.axhline(limit, color=_INK, linewidth=0.9, linestyle=(0, (4, 3)))
        axes.plot(reached, limit, "o", color=_INK, markersize=5)
        text = f"{words},\nfrom {reached:.0f} widths on"
        # On the side of the line that the curve leaves free.
        x, side = (8, "left") if reached > LONGEST / 2 else (LONGEST - 2, "right")
        axes.text(x, limit - 8, text, color=_INK, fontsize=9, ha=side, va="top")
    axes.set(xlim=(0, LONGEST), ylim=(log_u.min(), 60))
    axes.set_xlabel("distance from the goal in a corridor [widths]")
    axes.set_ylabel("log10 u", labelpad=0)
    axes.set_title("u along a corridor: why extended range")
    axes.spines[["top", "right"]].set_visible(False)
