"""What each action was worth to the learner before the first one of every trial."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.text import Text
from numpy.typing import NDArray
from scipy.optimize import isotonic_regression

from prospect_mj.experiment.paper.figures.figure_frame import (
    BLUE,
    GREEN,
    INK,
    SMALL,
    VERMILION,
)
from prospect_mj.experiment.paper.measures.bootstrap import Floats
from prospect_mj.experiment.portraits.run_frame import name_of, run_panels, say_empty
from prospect_mj.experiment.run.learning_curve import OPTIMUM
from prospect_mj.experiment.run.plots import png
from prospect_mj.experiment.run.records import ACTION_NAMES
from prospect_mj.experiment.view.run_view import RunView
from prospect_mj.task.presentation import ORIENTATIONS

_KINDS = (BLUE, GREEN, VERMILION)
_HANDS = ("-", (0, (3, 1.2)))
"""Lines of the left hand, or of what it gives away, and of the right one."""
_FEW = 30
"""So few trials are drawn as dots, too."""
_OUT = 16
"""How far names are from the end of their lines [points]."""


def start_values(run: RunView) -> bytes:
    """Draw Q of all actions in the start state, over the trials of each orientation.

    A dotted line is what the best action is worth to a learner that has learned all:
    two actions, the second one discounted, -(1 + gamma).

    Returns:
        The picture as PNG.
    """
    title = "What each action was worth at the start of a trial"
    of = f"{name_of(run)}: Q before the first action"
    panels = run_panels(run, title, of, 7.2, (1, 1))
    shown = np.array(run.trials["orientation"].to_pylist())
    values = first_values(run)
    panels[0].sharey(panels[1])
    drawn = []
    for axes, orientation in zip(panels, ORIENTATIONS, strict=True):
        trials = np.flatnonzero(shown == orientation)
        axes.set_ylabel(f"lid {orientation}: Q [actions]")
        names = _draw_values(axes, trials, values[trials])
        drawn.append([*names, _draw_best(axes, run.config.learner.discount)])
    for axes, names in zip(panels, drawn, strict=True):
        _spread(axes, names)
    return png(panels[0].figure)


def first_values(run: RunView) -> Floats:
    """Q of every action before the first one of every trial, (n, 6) [actions]."""
    first = run.actions["step"].to_numpy() == 0
    values = np.array(run.actions["q_values"].to_pylist(), np.float64)
    return values[first]


def apart(heights: Floats, least: float) -> Floats:
    """Heights as near as can be to those given, each so far from the next one.

    With h_1 <= ... <= h_n in order, p_i - i d must not fall, and the sum of
    (p_i - h_i)^2 is to be smallest: p_i - i d is the isotonic regression of h_i - i d.

    Args:
        heights: (n,).
        least: d, in the same unit.

    Returns:
        p (n,), in the order of `heights`.
    """
    order, steps = heights.argsort(), least * np.arange(heights.size)
    spread = np.empty_like(heights)
    spread[order] = isotonic_regression(heights[order] - steps).x + steps
    return spread


def _draw_values(axes: Axes, trials: NDArray[np.intp], values: Floats) -> list[Text]:
    """A line (n, 6) per action, and its name at the end; the names' heights overlap."""
    if not trials.size:
        say_empty(axes)
        return []
    names, marker = [], "." if trials.size <= _FEW else None
    for number, name in enumerate(ACTION_NAMES):
        colour, line = _KINDS[number // 2], _HANDS[number % 2]
        style = {"color": colour, "linestyle": line, "linewidth": 1.2}
        axes.plot(trials + 0.5, values[:, number], marker=marker, **style)
        names.append(_name(axes, name, values[-1, number], colour))
    return names


def _draw_best(axes: Axes, discount: float) -> Text:
    best = -sum(discount**step for step in range(OPTIMUM))
    axes.axhline(best, color=INK, linewidth=1, linestyle=(0, (1, 1.5)))
    return _name(axes, f"best possible: \N{MINUS SIGN}{-best:.2f}", best, INK)


def _name(axes: Axes, words: str, height: float, colour: str) -> Text:
    """Words beside the axes, with a line to a height in the data."""
    line = {"arrowstyle": "-", "color": colour, "lw": 0.6}
    return axes.annotate(
        words,
        (1, height),
        xycoords=axes.get_yaxis_transform(),
        xytext=(_OUT, 0),
        textcoords="offset points",
        va="center",
        fontsize=SMALL,
        color=colour,
        arrowprops=line | {"relpos": (0, 0.5), "shrinkA": 1, "shrinkB": 1},
    )


def _spread(axes: Axes, names: list[Text]) -> None:
    """Move names up or down until none covers another."""
    # Only now is known how high the axes will be.
    axes.figure.draw_without_rendering()
    points = 72 / axes.figure.dpi
    ends = axes.transData.transform([(0, name.xy[1]) for name in names])[:, 1] * points
    for name, end, height in zip(names, ends, apart(ends, 1.35 * SMALL), strict=True):
        name.set_position((_OUT, height - end))
