"""What was discovered: grey levels over histograms, and back on the jar's picture."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from prospect_mj.agent.features import N_BINS
from prospect_mj.experiment.development.figures.grid import name, tidy
from prospect_mj.experiment.development.figures.jar import amid, draw_jar, marked
from prospect_mj.experiment.development.study.found import Discovered, Range, Says
from prospect_mj.experiment.development.study.pictures import JarPicture
from prospect_mj.experiment.paper.figures.figure_frame import (
    BLUE,
    INK,
    SMALL,
    VERMILION,
)
from prospect_mj.experiment.paper.measures.bootstrap import Floats
from prospect_mj.experiment.run.plots import png

_COLOURS = {"left": BLUE, "right": VERMILION}
_BINS = np.arange(N_BINS)
_SHOWN = ("insertion", "grasp")
"""Contexts of the discovery learner that are drawn."""
_OF = (
    "lines, left scale: mean histograms with the lid on the left (blue), on the right "
    "(vermilion); bars, right scale: what each\ngrey level says to a learner, in the "
    "same colours, as a share of features and runs, or of the largest weight;\nbelow: "
    "features of one run of the discovery learner, hollow what is taken off; pictures: "
    "the pixels of these levels"
)
_LINE = 0.075
"""Between features below the histograms [heights of these]."""
_ROUNDED = 1e-9
_HEAD, _ROW = 0.97, 1.8
"""Height of the heading, and of a row [inches]."""
_BESIDE = 1.1
"""Where the name of the right scale is [widths of the panel]."""


class _Line(NamedTuple):
    """Levels of a feature, drawn below the histograms."""

    begin: int
    end: int
    colour: str
    filled: bool
    """Hollow, if they are taken off."""


def found(what: Discovered, pictures: Sequence[JarPicture]) -> bytes:
    """Draw it.

    Args:
        what: was found.
        pictures: of the jar, lid to the left and to the right.

    Returns:
        The picture as PNG.
    """
    says = [one for one in what.says if one.context in _SHOWN or _is_weighed(one)]
    figure = Figure((9.0, _HEAD + _ROW * len(says)), dpi=150, layout="constrained")
    height = figure.get_figheight()
    figure.get_layout_engine().set(rect=(0, 0, 1, 1 - _HEAD / height))
    style = {"ha": "left", "va": "top"}
    title = {"fontsize": 12, "fontweight": "bold"}
    figure.text(0.01, 1 - 0.06 / height, "What the learners go by", **style, **title)
    line = {"fontsize": SMALL, "color": INK, "linespacing": 1.4}
    figure.text(0.01, 1 - 0.32 / height, _OF, **style, **line)
    room = np.max([one.level.shape for one in pictures], axis=0, initial=0)
    ratios = [2.4, *(1 for _ in pictures)]
    axes = figure.subplots(len(says), len(ratios), squeeze=False, width_ratios=ratios)
    for row, one in zip(axes, says, strict=True):
        ranges = [r for r in what.example if r.context == one.context]
        _draw_levels(row[0], what, one, [] if _is_weighed(one) else ranges)
        for panel, picture in zip(row[1:], pictures, strict=True):
            draw_jar(panel, amid(marked(picture, one.levels), room))
    axes[-1, 0].set_xlabel("grey level, from dark to bright")
    for panel, picture in zip(axes[0, 1:], pictures, strict=True):
        name(panel, f"lid {picture.orientation}")
    return png(figure)


def _is_weighed(one: Says) -> bool:
    return one.learner != "discovery"


def _draw_levels(
    axes: Axes, what: Discovered, one: Says, ranges: Sequence[Range]
) -> None:
    tidy(axes)
    name(axes, f"{one.learner}: {one.context}, {one.runs} runs")
    highest = 1.15 * max(v.max() for v in what.v.values())
    lines = [line for one_range in ranges for line in _lines(one_range, what)]
    lowest = -_LINE * highest * (len(lines) + 0.8)
    for side, v in what.v.items():
        axes.step(_BINS, v, where="mid", color=_COLOURS[side], linewidth=1.1)
    for row, line in enumerate(lines):
        _draw_line(axes, line, -_LINE * highest * (row + 1), 0.6 * _LINE * highest)
    axes.set_xlim(-0.5, N_BINS - 0.5)
    axes.set_ylim(lowest, highest)
    ticks = MaxNLocator(4, steps=(1, 2, 5, 10)).tick_values(0, highest)
    axes.set_yticks(ticks[(ticks >= 0) & (ticks <= highest)])
    axes.set_ylabel("histogram [1]", fontsize=SMALL)
    most = np.abs(one.levels).max() if one.levels.any() else 1.0
    # What is said most reaches half as high as the histograms.
    ends = 2.0 * most * np.array([lowest / highest, 1.0])
    _draw_bars(
        axes, one.levels, ends, "weight [1]" if _is_weighed(one) else "share [1]"
    )


def _draw_bars(under: Axes, levels: Floats, ends: Floats, title: str) -> None:
    """Draw what levels say below other curves, with a scale of its own at the right.

    Args:
        under: panel of the curves.
        levels: (100,), what each says; positive for the left.
        ends: lowest and highest that there is room for.
        title: of the scale.
    """
    axes = under.twinx()
    under.set_zorder(axes.get_zorder() + 1)
    under.patch.set_visible(False)
    colours = np.where(levels > 0, _COLOURS["left"], _COLOURS["right"])
    axes.bar(_BINS, np.abs(levels), width=1, color=colours, alpha=0.35)
    axes.set_ylim(*ends)
    ticks = MaxNLocator(2, steps=(1, 2, 5, 10)).tick_values(0.0, ends[1] / 2.0)
    shown = [tick for tick in ticks if 0.0 <= tick <= ends[1] / 2.0 + _ROUNDED]
    axes.set_yticks(shown, [f"{tick:.2g}" for tick in shown], fontsize=SMALL)
    axes.set_ylabel(title, fontsize=SMALL)
    axes.yaxis.set_label_coords(_BESIDE, 0.5)
    axes.spines[["top", "left"]].set_visible(False)


def _lines(one: Range, what: Discovered) -> Iterator[_Line]:
    """A feature below the histograms, and what it takes off on a line of its own."""
    difference = what.v["left"] - what.v["right"]
    more = difference[one.begin : one.end].sum()
    less = difference[one.less_begin : one.less_end].sum()
    colours = list(_COLOURS.values())
    if more <= less:
        colours.reverse()
    yield _Line(one.begin, one.end, colours[0], True)
    if one.less_begin < one.less_end:
        yield _Line(one.less_begin, one.less_end, colours[1], False)


def _draw_line(axes: Axes, line: _Line, middle: float, height: float) -> None:
    colour = {"facecolor": line.colour if line.filled else "none"}
    style = {**colour, "edgecolor": line.colour, "linewidth": 1.0}
    wide = line.end - line.begin
    axes.barh(middle, wide, height, left=line.begin - 0.5, **style)
