"""Learning curves of several seeds, and their mean with its band."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.ticker import MaxNLocator
from numpy.typing import NDArray

from prospect_mj.experiment.estimate import LEVEL, band_of_few
from prospect_mj.experiment.paper.figures.figure_frame import (
    BLUE,
    Heading,
    panels,
    segments,
    set_trials,
)
from prospect_mj.experiment.run.learning_curve import (
    BLOCK,
    OPTIMUM,
    WINDOW,
    block_means,
)
from prospect_mj.experiment.run.plots import draw_levels, png

_Floats = NDArray[np.float64]
_PALE = "#9fb4c4"


def learning_curves(
    n_actions: NDArray[np.integer], pretrain: int, max_actions: int
) -> bytes:
    """Draw actions per trial in sets of ten, as the paper's figure 5.

    Args:
        n_actions: (runs, trials) [actions].
        pretrain: the first so many trials were pretraining.
        max_actions: where trials are cut off [actions].

    Returns:
        The picture as PNG.
    """
    n_runs, n_trials = n_actions.shape
    size = BLOCK if n_trials >= WINDOW else 1
    curves = np.stack([block_means(run, size) for run in n_actions])
    trials = size * np.arange(curves.shape[1], dtype=np.float64)
    heading = _heading(n_runs, size, pretrain)
    (axes,) = panels(heading, 4.5, (1,))
    set_trials([axes], heading, trials)
    axes.set_xlim(0, n_trials)
    axes.xaxis.set_major_locator(MaxNLocator(integer=True))
    axes.set_ylabel("actions per trial")
    axes.set_ylim(0, max_actions * 1.08)
    draw_levels(axes, max_actions)
    # No trial is shorter or longer, so no mean is.
    bounds = np.clip(band_of_few(curves), OPTIMUM, max_actions)
    for part in segments(heading, trials):
        middles = trials[part] + size / 2
        _draw(axes, middles, curves[:, part], bounds[:, part])
    return png(axes.figure)


def _heading(n_runs: int, size: int, pretrain: int) -> Heading:
    sets = f" in sets of {size} trials" if size > 1 else ""
    what = f"one seed{sets}"
    if n_runs > 1:
        band_words = f"{100 * LEVEL:.0f} % band (Student's)"
        what = f"mean over {n_runs} seeds{sets}, {band_words}; single seeds pale"
    return Heading("Actions per trial over seeds", what, pretrain)


def _draw(
    axes: Axes,
    middles: _Floats,
    curves: _Floats,
    bounds: _Floats,
) -> None:
    """Single curves (r, s) behind, the band (2, s), and the mean in front."""
    axes.plot(middles, curves.T, color=_PALE, linewidth=0.6, alpha=0.6)
    axes.fill_between(middles, *bounds, color=BLUE, alpha=0.3, lw=0, zorder=2.5)
    axes.plot(middles, curves.mean(axis=0), color=BLUE, linewidth=1.8, zorder=3)
