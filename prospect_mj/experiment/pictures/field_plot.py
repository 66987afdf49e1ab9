"""A picture of a harmonic function over two joints, with its streamlines."""

from collections.abc import Callable

import matplotlib
import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import ListedColormap
from matplotlib.figure import Figure
from matplotlib.patches import Patch

from prospect_mj.experiment.pictures import field_scene
from prospect_mj.experiment.pictures.corridor import LONGEST, decay
from prospect_mj.experiment.pictures.field_slice import (
    FREE,
    GOAL,
    KINDS,
    START,
    Slice,
    configurations,
    joint_slice,
)
from prospect_mj.experiment.run.plots import png

_INK = "#24313f"
_LINE = "#ffffff"
_DECAY = "#e4572e"
_TINTS = ("#ecdcc9", "#a98f72", "#b5524a", "#5f7f9f", "#a3abb4", "#7d9b6a")
"""Of what is in the way, in the order of `KINDS`."""
_WAY = matplotlib.colormaps["plasma"](np.linspace(0.25, 0.85, 5))[:, :3]
"""Of the configurations along the way that is shown."""
STARTS = np.array(
    [
        (-2.3, -0.4),
        (-2.4, 0.7),
        (-2.3, 1.6),
        (-1.5, -1.2),
        (-1.2, 1.5),
        (-0.9, 0.2),
        (-0.4, -1.4),
        (-0.1, 0.75),
        (0.5, -1.5),
        (0.6, -0.4),
        (1.1, 0.1),
        (1.62, 0.7),
        (1.47, 1.4),
        (2.35, 1.0),
        (2.3, 0.0),
        (2.3, -1.2),
    ]
)
"""Where further streamlines begin [rad]."""
_LIMITS = (
    (
        np.log10(np.finfo(float).eps / 2),
        "from {} widths on\n1 \N{MINUS SIGN} u is 1: no gradient",
    ),
    (
        np.log10(np.finfo(float).smallest_subnormal),
        "from {} widths on\nu is 0 in double precision",
    ),
)
"""Values of log10 u from which on down a form is of no use, and what it does there."""
_CUT_OFF = "#d9d9d9"
"""Of free cells from which no way leads to the goal."""
_PHOTO = (620, 860)
"""Rows and columns [pixels]."""
STEPS = 5
"""What is in the way, three panels, and the picture of them."""


def field_picture(tick: Callable[[], object]) -> bytes:
    """Draw the slice, the arm on one of its streamlines, and u along a corridor.

    Args:
        tick: called after each of the `STEPS`.

    Returns:
        The picture as PNG.
    """
    shown = joint_slice()
    tick()
    figure = drawing(shown, tick)
    content = png(figure)
    tick()
    return content


def drawing(shown: Slice, tick: Callable[[], object] = lambda: None) -> Figure:
    """The figure of a slice.

    Args:
        shown: the slice.
        tick: called after each of its three panels.
    """
    figure = Figure(figsize=(13, 6.2), dpi=110, layout="constrained")
    left, right = figure.subfigures(1, 2, width_ratios=(1.42, 1))
    way = shown.streamline(np.array(START)).points
    stations = way[np.linspace(0, len(way) - 1, len(_WAY)).astype(int)]
    axes = left.subplots()
    _draw_space(axes, shown)
    _draw_way(axes, way, stations)
    tick()
    above, below = right.subplots(2, 1, height_ratios=(2.3, 1))
    _draw_arm(above, stations)
    tick()
    _draw_decay(below)
    tick()
    return figure


def _draw_space(axes: Axes, shown: Slice) -> None:
    """Obstacles, log u and streamlines."""
    grid = shown.grid
    extent = (grid.low[0], grid.high[0], grid.low[1], grid.high[1])
    pixels = {"origin": "lower", "extent": extent, "interpolation": "nearest"}
    obstacle = np.ma.masked_equal(shown.obstacle, FREE)
    most = len(KINDS) + 0.5
    axes.set_facecolor(_CUT_OFF)
    axes.imshow(obstacle.T, cmap=ListedColormap(_TINTS), vmin=0.5, vmax=most, **pixels)
    log_u = np.ma.masked_invalid(shown.field.log_u / np.log(10))
    filled = axes.imshow(log_u.T, cmap="viridis", vmax=0.0, **pixels)
    levels = np.arange(np.floor(log_u.min()), 0.0, 0.5)
    thin = {"colors": _LINE, "alpha": 0.25, "linewidths": 0.6, "linestyles": "-"}
    axes.contour(grid.centres(0), grid.centres(1), log_u.T, levels=levels, **thin)
    for start in STARTS:
        points = shown.streamline(start).points
        axes.plot(*points.T, color=_LINE, linewidth=1.0)
        axes.plot(*points[0], "o", color=_LINE, markersize=3)
    axes.figure.colorbar(filled, ax=axes, pad=0.01, shrink=0.9, label="log10 u")
    axes.set(aspect="auto", xlabel="shoulder J1 [rad]", ylabel="shoulder J2 [rad]")
    axes.set_title("A harmonic function over two joints, and its streamlines")
    _draw_legend(axes, set(np.unique(shown.obstacle).tolist()))


def _draw_legend(axes: Axes, seen: set[int]) -> None:
    """What is in the way, as far as it is seen."""
    kinds = [(_TINTS[i], KINDS[i]) for i in range(len(KINDS)) if i + 1 in seen]
    kinds.append((_CUT_OFF, "free, but cut off"))
    patches = [Patch(color=tint, label=kind) for tint, kind in kinds]
    style = {"fontsize": 8.5, "frameon": False, "handlelength": 1.3}
    place = "outside lower center"
    axes.figure.legend(handles=patches, loc=place, ncols=7, columnspacing=1.2, **style)


def _draw_way(axes: Axes, way: np.ndarray, stations: np.ndarray) -> None:
    """One streamline, and numbered places on it."""
    axes.plot(*way.T, color=_LINE, linewidth=2.4)
    axes.plot(*GOAL, "*", color=_WAY[-1], markersize=30, markeredgecolor=_LINE)
    for number, (place, tint) in enumerate(zip(stations, _WAY, strict=True), 1):
        if number < len(stations):
            axes.plot(*place, "o", color=tint, markersize=15, markeredgecolor=_LINE)
        ink = {"color": _LINE, "fontsize": 9, "fontweight": "bold"}
        axes.text(*place, str(number), ha="center", va="center_baseline", **ink)


def _draw_arm(axes: Axes, stations: np.ndarray) -> None:
    """The arm at all of these places, in their tints."""
    picture = field_scene.photograph(configurations(stations), _WAY, _PHOTO)
    axes.imshow(picture)
    axes.set(xticks=[], yticks=[])
    axes.spines[:].set_visible(False)
    axes.set_title("The arm at places 1 to 5: up and round the post")


def _draw_decay(axes: Axes) -> None:
    """Plot u along a corridor, against what double precision can hold."""
    widths, log_u = decay()
    axes.plot(widths, log_u, color=_DECAY, linewidth=2.2)
    for limit, words in _LIMITS:
        reached = float(np.interp(limit, log_u[::-1], widths[::-1]))
        axes.axhline(limit, color=_INK, linewidth=0.9, linestyle=(0, (4, 3)))
        axes.plot(reached, limit, "o", color=_INK, markersize=5)
        # On the side of the curve that is free.
        early = reached < LONGEST / 2
        x, y = (LONGEST - 4, limit - 8) if early else (8, limit + 8)
        align = (
            {"ha": "right", "va": "top"} if early else {"ha": "left", "va": "bottom"}
        )
        axes.text(x, y, words.format(round(reached)), color=_INK, fontsize=9, **align)
    axes.set(xlim=(0, LONGEST), ylim=(log_u.min(), 20))
    axes.set_xlabel("distance from the goal in a corridor [widths]")
    axes.set_ylabel("log10 u")
    axes.set_title("u along a corridor: why extended range")
    axes.spines[["top", "right"]].set_visible(False)
