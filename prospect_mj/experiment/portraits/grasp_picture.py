"""Phase portraits of grasps: the contacts' residual and its rate."""

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.ticker import LogLocator, NullFormatter

from prospect_mj.control.grasp_settings import GraspSettings
from prospect_mj.control.result import Status
from prospect_mj.experiment.paper.figures.figure_frame import (
    BLUE,
    GREEN,
    INK,
    SMALL,
    VERMILION,
    write,
)
from prospect_mj.experiment.paper.measures.bootstrap import Floats
from prospect_mj.experiment.portraits.grasp_phases import GraspPhases
from prospect_mj.experiment.run.plots import png

_LOOKS = {
    Status.CONVERGED: (BLUE, "o"),
    Status.STALLED: (VERMILION, "s"),
    Status.LOST: ("#cc79a7", "v"),
    Status.OUT_OF_TIME: ("#8c5a00", "D"),
}
"""Colour, and mark at the end, of grasps by how they came out."""
_END = {"markersize": 7, "mfc": "none", "mew": 1.1}
_START = {"markersize": 5, "mew": 0}
"""The one fits in the other, as most grasps end where they start."""
_ACCEPTED = "#e3f1ea"
_PANELS = {"lid": "the hand on the lid", "body": "the hand on the body"}
_LINE = 13
"""From line to line of the heading [points]."""
_ARROW = 0.03
"""The shortest step with an arrow [share of the panel]."""


def portraits(grasps: Sequence[GraspPhases], of: str) -> bytes:
    """Draw residual and rate of grasps, those of lid and body apart, in time's order.

    A trajectory goes from measurement to measurement. It is at a rate of zero while the
    fingers rest on the jar, and below from one probe to the next, as the hand corrects
    its place. Shaded is where the contacts are accepted as balanced.

    Args:
        grasps: in any order.
        of: what they are, in words.

    Returns:
        The picture as PNG.
    """
    figure = Figure(figsize=(8, 4.8), dpi=150, layout="constrained")
    panels = figure.subplots(1, 2, sharex=True, sharey=True)
    _set_limits(panels[0], _all_phases(grasps))
    for axes, (end, words) in zip(panels, _PANELS.items(), strict=True):
        mine = [grasp for grasp in grasps if grasp.end == end]
        _draw_accepted(axes)
        for grasp in mine:
            _draw_trajectory(axes, grasp)
        axes.set_title(_counted(words, mine), loc="left", fontsize=SMALL, color=INK)
        axes.set_xlabel(r"residual of the contacts, $\epsilon$")
        axes.spines[["top", "right"]].set_visible(False)
    panels[0].set_ylabel(r"rate, $d\epsilon/dt$ [1/s]")
    _write_heading(panels[0], [of, *_at_once(grasps)])
    _draw_legend(figure, {grasp.status for grasp in grasps})
    return png(figure)


def _write_heading(axes: Axes, lines: Sequence[str]) -> None:
    """The title, and lines below it that are wider than their panel."""
    over = {"xycoords": "axes fraction", "va": "bottom"}
    title = {"fontsize": 12, "fontweight": "bold", "color": "black"}
    for number, words in enumerate(reversed(lines)):
        write(axes, words, (0, 1), (0, 24 + _LINE * number), **over, in_layout=False)
    above = 24 + _LINE * len(lines)
    write(axes, "Phase portraits of grasps", (0, 1), (0, above + 3), **over, **title)


def _at_once(grasps: Sequence[GraspPhases]) -> list[str]:
    """What there is to see if most grasps have hardly any trajectory."""
    balanced = [g.status is Status.CONVERGED and g.probes == 1 for g in grasps]
    if 2 * sum(balanced) <= len(grasps):
        return []
    told = f"{sum(balanced)} of {len(grasps)} grasps balance at the first probe"
    return [f"{told}: they end where they start"]


def _all_phases(grasps: Sequence[GraspPhases]) -> Floats:
    """(n, 2), of all grasps together."""
    return np.concatenate([np.empty((0, 2)), *(grasp.phases for grasp in grasps)])


def _counted(words: str, grasps: Sequence[GraspPhases]) -> str:
    without = sum(len(grasp.phases) == 0 for grasp in grasps)
    hidden = f", {without} without a lasting touch" if without else ""
    return f"{words}: {len(grasps)} grasps{hidden}"


def _set_limits(axes: Axes, phases: Floats) -> None:
    """Room for all of (n, 2), and for the region that is accepted."""
    settings = GraspSettings()
    residual, rate = phases.T
    eps, reach = settings.residual_threshold, 1.25 * settings.rate_threshold
    axes.set_xscale("log")
    low, high = residual.min(initial=eps / 10), residual.max(initial=5 * eps)
    axes.set_xlim(low / 1.3, high * 1.3)
    # Of more than three decades only the powers of ten have room.
    subs = (1, 2, 5) if high < 1000 * low else (1,)
    axes.xaxis.set_major_locator(LogLocator(subs=subs))
    low, high = rate.min(initial=-reach), rate.max(initial=reach)
    axes.set_ylim(1.1 * low, 1.1 * high)
    axes.xaxis.set_major_formatter("{x:g}")
    axes.xaxis.set_minor_formatter(NullFormatter())


def _draw_accepted(axes: Axes) -> None:
    settings = GraspSettings()
    eps, rate = settings.residual_threshold, settings.rate_threshold
    low = axes.get_xlim()[0]
    axes.fill_between([low, eps], -rate, rate, color=_ACCEPTED, lw=0, zorder=0)
    style = {"color": GREEN, "linewidth": 0.9, "linestyle": (0, (5, 3))}
    axes.axvline(eps, **style)
    for level in (-rate, rate):
        axes.axhline(level, **style)
    axes.axhline(0, color=INK, linewidth=0.6)


def _draw_trajectory(axes: Axes, grasp: GraspPhases) -> None:
    if not len(grasp.phases):
        return
    colour, mark = _LOOKS[grasp.status]
    axes.plot(*grasp.phases.T, color=colour, linewidth=0.9, alpha=0.75)
    axes.plot(*grasp.phases[-1], mark, color=colour, zorder=3, **_END)
    axes.plot(*grasp.phases[0], ".", color=INK, zorder=4, **_START)
    arrow = {"arrowstyle": "-|>,head_width=0.18,head_length=0.35", "color": colour}
    shares = axes.transAxes.inverted().transform(axes.transData.transform(grasp.phases))
    steps = np.hypot(*np.diff(shares, axis=0).T)
    for number in np.flatnonzero(steps > _ARROW):
        middle = shares[number : number + 2].mean(axis=0)
        places = {"xytext": shares[number], "textcoords": "axes fraction"}
        style = arrow | {"shrinkA": 0, "shrinkB": 0, "lw": 0}
        axes.annotate("", middle, xycoords="axes fraction", arrowprops=style, **places)


def _draw_legend(figure: Figure, there: set[Status]) -> None:
    handles = [
        Line2D([], [], c=colour, marker=mark, lw=1, label=str(status), **_END)
        for status, (colour, mark) in _LOOKS.items()
        if status in there
    ]
    handles.append(Line2D([], [], c=INK, marker=".", ls="", label="start", **_START))
    settings = GraspSettings()
    accepted = (
        rf"accepted: $\epsilon < {settings.residual_threshold:g}$, "
        rf"$|d\epsilon/dt| < {settings.rate_threshold:g}$/s"
    )
    handles.append(Patch(color=_ACCEPTED, label=accepted))
    place = {"loc": "outside lower center", "ncols": len(handles), "columnspacing": 1.2}
    figure.legend(handles=handles, frameon=False, fontsize=SMALL, **place)
