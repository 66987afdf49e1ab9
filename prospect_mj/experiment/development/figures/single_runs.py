"""Single runs: which strategy prevails in each window of their difficult trials."""

from collections.abc import Mapping

import numpy as np
from matplotlib.colors import ListedColormap
from matplotlib.figure import Figure
from matplotlib.text import Text
from numpy.typing import NDArray

from prospect_mj.experiment.development.figures.grid import (
    COLOURS,
    Size,
    grid,
    name,
)
from prospect_mj.experiment.development.measures.sequences import (
    NO_MAJORITY,
    WINDOW,
    difficult_trials,
    windows,
)
from prospect_mj.experiment.paper.figures.figure_frame import INK, SMALL
from prospect_mj.experiment.populations.population import Population
from prospect_mj.experiment.populations.strategies import Strategy
from prospect_mj.experiment.run.plots import png

RUNS = 40
"""That are drawn of each learner."""

_OF = """\
each row one of {shown} runs of {all}, the soonest optimal above; failed actions \
suppressed
{colours}"""
_COLOURS = (
    "each cell ten of its difficult trials; colour: what more than a half of them are:"
)
_NONE = "#ffffff"
"""Of a cell in which no strategy prevails."""
_LEFT, _HEIGHT, _GAP = 0.01, 0.885, 0.008
"""Of the colours' line, and between its words [shares of the figure]."""


def single_runs(populations: Mapping[str, Population]) -> bytes:
    """Draw some runs of each learner, those that are optimal sooner above.

    Args:
        populations: of each learner, by its name.

    Returns:
        The picture as PNG.
    """
    size = Size(1, len(populations), 8.0, 4.6)
    numbers = [len(population.lid) for population in populations.values()]
    of = _OF.format(shown=min(RUNS, *numbers), all=max(numbers), colours=_COLOURS)
    made = grid("What prevails in single runs", of, size)
    colours = [COLOURS[kind] for kind in Strategy]
    for axes, (learner, population) in zip(
        made.axes.flat, populations.items(), strict=True
    ):
        cells = prevailing_cells(population)
        axes.imshow(
            cells,
            cmap=ListedColormap([_NONE, *colours]),
            vmin=NO_MAJORITY - 0.5,
            vmax=len(colours) - 0.5,
            aspect="auto",
            interpolation="nearest",
            extent=(0, WINDOW * cells.shape[1], len(cells), 0),
        )
        axes.grid(visible=False)
        axes.set_yticks([])
        axes.set_xlabel("difficult trial")
        name(axes, learner)
    made.axes[0, 0].set_ylabel("run")
    _key(made.figure)
    return png(made.figure)


def prevailing_cells(population: Population) -> NDArray[np.int64]:
    """The strategy that prevails in each window of some runs.

    Returns:
        (runs, windows): numbers of `Strategy`, or `NO_MAJORITY`, as far as all runs
        have trials; the run that is optimal first comes first.
    """
    runs = [windows(run) for run in difficult_trials(population)[:RUNS]]
    cells = np.array([run[: min(map(len, runs))] for run in runs])
    is_optimal = cells == Strategy.OPTIMAL
    first = np.where(is_optimal.any(axis=1), is_optimal.argmax(axis=1), cells.shape[1])
    return cells[np.argsort(first, kind="stable")]


def _key(figure: Figure) -> None:
    """The colours' names behind their line, each in its own."""
    right = _LEFT + _width(figure.text(_LEFT, _HEIGHT, _COLOURS, fontsize=SMALL))
    figure.texts[-1].remove()
    for kind, colour in COLOURS.items():
        style = {"color": colour, "fontweight": "bold", "fontsize": SMALL}
        words = kind.name.lower()
        text = figure.text(right + _GAP, _HEIGHT, words, va="top", **style)
        right += _GAP + _width(text)
    style = {"color": INK, "fontsize": SMALL}
    figure.text(right + _GAP, _HEIGHT, "(white: none)", va="top", **style)


def _width(text: Text) -> float:
    """Of words [shares of the figure]."""
    return text.get_window_extent().width / text.figure.bbox.width
