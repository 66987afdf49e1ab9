"""What was discovered: grey levels over histograms, and back on the jar's picture."""

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator
from numpy.typing import NDArray

from prospect_mj.agent.features import N_BINS
from prospect_mj.experiment.development.figures.grid import name, tidy
from prospect_mj.experiment.development.study.found import Discovered, Range, Says
from prospect_mj.experiment.development.study.pictures import NO_JAR, JarPicture
from prospect_mj.experiment.paper.figures.figure_frame import (
    BLUE,
    INK,
    SMALL,
    VERMILION,
)
from prospect_mj.experiment.paper.measures.bootstrap import Floats
from prospect_mj.experiment.run.plots import png
from prospect_mj.sim.camera import Image

_COLOURS = {"left": BLUE, "right": VERMILION}
_BINS = np.arange(N_BINS)
_MARK = np.array([[0, 114, 178], [213, 94, 0]])
"""Blue and vermilion [grey levels], for the lid on the left and on the right."""
_LEAST = 0.25
"""Of the largest; levels that say less are not marked in pictures."""
_PALE, _PAPER = 0.55, 250
"""Contrast of the jar [1], and what stands for all else [grey levels]."""
_SHOWN = ("insertion", "grasp")
"""Contexts of the discovery learner that are drawn."""
_OF = (
    "lines, left scale: mean histograms with the lid on the left (blue), on the right "
    "(vermilion); bars, right scale: what each\ngrey level says to a learner, in the "
    "same colours, as a share of features and runs, or of the largest weight;\nbelow: "
    "features of one run of the discovery learner, dashed what is taken off; pictures: "
    "the pixels of these levels"
)
_HEAD, _ROW = 0.97, 1.8
"""Height of the heading, and of a row [inches]."""
_BESIDE = 1.1
"""Where the name of the right scale is [widths of the panel]."""


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
            _draw_jar(panel, amid(marked(picture, one.levels), room))
    axes[-1, 0].set_xlabel("grey level, from dark to bright")
    for panel, picture in zip(axes[0, 1:], pictures, strict=True):
        name(panel, f"lid {picture.orientation}")
    return png(figure)


def marked(picture: JarPicture, levels: Floats) -> Image:
    """The picture in pale grey, pixels of levels that say something in their colour.

    Args:
        picture: of the jar.
        levels: (100,), what each says; see `study.found`.

    Returns:
        (rows, columns, 3) RGB [grey levels].
    """
    grey = picture.image.mean(axis=2, keepdims=True)
    pale = np.repeat(255 - _PALE * (255 - grey), 3, axis=2)
    strength = levels / max(np.abs(levels).max(), np.finfo(float).tiny)
    of_pixel = np.append(strength, 0.0)[picture.level]
    outside = picture.level == NO_JAR
    of_pixel[outside], pale[outside] = 0.0, _PAPER
    weight = np.where(np.abs(of_pixel) < _LEAST, 0.0, np.abs(of_pixel))[..., None]
    colour = _MARK[(of_pixel < 0).astype(int)]
    return ((1 - weight) * pale + weight * colour).astype(np.uint8)


def amid(image: Image, room: NDArray[np.int64]) -> Image:
    """The same picture in the middle of a larger one.

    Args:
        image: (rows, columns, 3) RGB [grey levels].
        room: rows and columns of the larger one.

    Returns:
        (*room, 3) RGB [grey levels], paper around it.
    """
    shown = np.full((*room, 3), _PAPER, np.uint8)
    rows, columns = image.shape[:2]
    top, left = (room - (rows, columns)) // 2
    shown[top : top + rows, left : left + columns] = image
    return shown


def _is_weighed(one: Says) -> bool:
    return one.learner != "discovery"


def _draw_levels(
    axes: Axes, what: Discovered, one: Says, ranges: Sequence[Range]
) -> None:
    tidy(axes)
    name(axes, f"{one.learner}: {one.context}, {one.runs} runs")
    highest = 1.15 * max(v.max() for v in what.v.values())
    lowest = -0.06 * highest * (len(ranges) + 0.8)
    for side, v in what.v.items():
        axes.step(_BINS, v, where="mid", color=_COLOURS[side], linewidth=1.1)
    for row, each in enumerate(ranges):
        _draw_range(axes, each, -0.06 * highest * (row + 1), what)
    axes.set_xlim(-0.5, N_BINS - 0.5)
    axes.set_ylim(lowest, highest)
    ticks = MaxNLocator(4, steps=(1, 2, 5, 10)).tick_values(0, highest)
    axes.set_yticks(ticks[(ticks >= 0) & (ticks <= highest)])
    axes.set_ylabel("histogram [1]", fontsize=SMALL)
    most = np.abs(one.levels).max() if one.levels.any() else 1.0
    # What is said most reaches half as high as the histograms.
    _draw_bars(axes, one.levels, 2.0 * most * np.array([lowest / highest, 1.0]))


def _draw_bars(under: Axes, levels: Floats, ends: Floats) -> None:
    """Draw what levels say below other curves, with a scale of its own at the right."""
    axes = under.twinx()
    under.set_zorder(axes.get_zorder() + 1)
    under.patch.set_visible(False)
    colours = np.where(levels > 0, _COLOURS["left"], _COLOURS["right"])
    axes.bar(_BINS, np.abs(levels), width=1, color=colours, alpha=0.35)
    axes.set_ylim(*ends)
    most = ends[1] / 2.0
    axes.set_yticks([0.0, most], ["0", f"{most:.2g}"], fontsize=SMALL)
    axes.set_ylabel("says [1]", fontsize=SMALL)
    axes.yaxis.set_label_coords(_BESIDE, 0.5)
    axes.spines[["top", "left"]].set_visible(False)


def _draw_range(axes: Axes, one: Range, height: float, what: Discovered) -> None:
    """A feature as a line below the histograms, dashed where it is taken off."""
    difference = what.v["left"] - what.v["right"]
    more = difference[one.begin : one.end].sum()
    less = difference[one.less_begin : one.less_end].sum()
    left = more > less
    for begin, end, says_left, dashed in (
        (one.begin, one.end, left, False),
        (one.less_begin, one.less_end, not left, True),
    ):
        if begin < end:
            colour = _COLOURS["left" if says_left else "right"]
            style = (0, (1, 0.6)) if dashed else "-"
            ends = [begin - 0.5, end - 0.5]
            axes.plot(ends, [height] * 2, color=colour, linewidth=3, linestyle=style)


def _draw_jar(axes: Axes, image: Image) -> None:
    axes.imshow(image, interpolation="nearest")
    axes.set_anchor("N")
    axes.set_axis_off()
