"""Pictures of a run."""

import io

import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator
from numpy.typing import ArrayLike, NDArray

from prospect_mj.experiment.run.learning_curve import (
    BLOCK,
    OPTIMUM,
    WINDOW,
    block_means,
    moving_mean,
)

_DOTS = "#9db8d2"
_LINE = "#1f4e79"
_LEVELS = "#8a8a8a"
_SHADE = "#f4efe2"
_SHADE_TEXT = "#8a7a4a"


def learning_curve(
    n_actions: ArrayLike, pretrain: int, max_actions: int, title: str
) -> bytes:
    """Draw actions per trial over a run, as the paper's figure 5.

    Args:
        n_actions: (n_trials,) [actions], at least one trial.
        pretrain: the first so many trials were pretraining.
        max_actions: where trials are cut off [actions].
        title: heading.

    Returns:
        The picture as PNG.
    """
    actions = np.asarray(n_actions, dtype=np.float64)
    figure = Figure(figsize=(8, 4.5), dpi=150, layout="constrained")
    axes = figure.add_subplot()
    _frame(axes, len(actions), max_actions, title)
    draw_levels(axes, max_actions)
    _draw_means(axes, actions)
    _draw_moving_means(axes, actions, pretrain)
    _draw_legend(axes)
    if pretrain:
        _draw_pretraining(axes, min(pretrain, len(actions)), max_actions)
    return png(figure)


def _frame(axes: Axes, n_trials: int, max_actions: int, title: str) -> None:
    axes.set_title(title, loc="left", fontsize=12, fontweight="bold", pad=12)
    axes.set_xlabel("trial")
    axes.set_ylabel("actions per trial")
    axes.set_xlim(0, n_trials)
    axes.xaxis.set_major_locator(MaxNLocator(integer=True))
    axes.set_ylim(0, max_actions * 1.12)
    axes.spines[["top", "right"]].set_visible(False)
    axes.grid(axis="y", color="#ececec", linewidth=0.8)
    axes.set_axisbelow(True)


def draw_levels(axes: Axes, max_actions: int) -> None:
    """Mark the fewest actions of a solved trial, and those of the longest one."""
    levels = ((OPTIMUM, f"optimum: {OPTIMUM}", "top"),)
    levels += ((max_actions, f"cut off after {max_actions}", "bottom"),)
    for level, label, side in levels:
        axes.axhline(level, color=_LEVELS, linewidth=1, linestyle=(0, (5, 4)))
        axes.annotate(
            label,
            (1, level),
            xycoords=("axes fraction", "data"),
            xytext=(-3, 3 if side == "bottom" else -4),
            textcoords="offset points",
            ha="right",
            va=side,
            fontsize=9,
            color=_LEVELS,
        )


def _draw_means(axes: Axes, actions: NDArray[np.float64]) -> None:
    """A dot per set of ten trials, at its middle; in a short run one per trial."""
    size = BLOCK if len(actions) >= WINDOW else 1
    means = block_means(actions, size)
    middles = (np.arange(len(means)) + 0.5) * size
    label = f"mean of {size} trials" if size > 1 else "single trials"
    axes.plot(middles, means, "o", color=_DOTS, markersize=4, label=label)


def _draw_moving_means(axes: Axes, actions: NDArray[np.float64], pretrain: int) -> None:
    """A line at the middle of its window; none mixes pretraining and what follows."""
    label = f"moving mean of {WINDOW} trials"
    for first, last in ((0, pretrain), (pretrain, len(actions))):
        smooth = moving_mean(actions[first:last], WINDOW)
        if smooth.size:
            middles = first + np.arange(smooth.size) + WINDOW / 2
            axes.plot(middles, smooth, color=_LINE, linewidth=2.2, label=label)
            label = None


def _draw_legend(axes: Axes) -> None:
    axes.legend(
        loc="lower right",
        bbox_to_anchor=(1, 1),
        ncols=2,
        frameon=False,
        fontsize=9,
        borderaxespad=0.2,
    )


def _draw_pretraining(axes: Axes, pretrain: int, max_actions: int) -> None:
    axes.axvspan(0, pretrain, color=_SHADE, zorder=0)
    axes.axvline(pretrain, color=_SHADE_TEXT, linewidth=1)
    axes.annotate(
        "pretraining, one orientation",
        (0, max_actions * 1.06),
        xytext=(6, 0),
        textcoords="offset points",
        va="center",
        fontsize=9,
        color=_SHADE_TEXT,
    )


def png(figure: Figure) -> bytes:
    """Encode a figure; equal figures give equal bytes."""
    stream = io.BytesIO()
    FigureCanvasAgg(figure).print_png(stream)
    return stream.getvalue()
