"""Phase portraits: what the fingers feel of both ends of a jar, and models of it."""

from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Ellipse
from matplotlib.patheffects import withStroke
from matplotlib.ticker import MultipleLocator

from prospect_mj.experiment.development.figures.grid import Size, grid, name
from prospect_mj.experiment.development.haptics.grasp import (
    CRADLE,
    HAND_OVER,
    KINDS,
    Grasp,
)
from prospect_mj.experiment.paper.figures.figure_frame import (
    BLUE,
    INK,
    SMALL,
    VERMILION,
)
from prospect_mj.experiment.paper.measures.bootstrap import Floats
from prospect_mj.experiment.run.plots import png
from prospect_mj.haptics import TrajectoryModels, categories
from prospect_mj.haptics.models import STAGES, stages

_ENDS = {"body": BLUE, "lid": VERMILION}
"""In the order of their numbers."""
_PLURAL = {CRADLE: "grasps out of the cradle", HAND_OVER: "hand-overs"}
_DEVIATIONS = 2
_OF = (
    "dots: samples of all grasps; ellipses: the models that these grasps are of, by "
    "their number, at two deviations,\ndotted with a prime after a correction of the "
    "hand"
)
_LEAST, _TICK = -0.0005, 0.01
"""Where the axis of residuals begins, and between its ticks [1]."""
_HALO = (withStroke(linewidth=2.5, foreground="#ffffff"),)


def portraits(
    grasps: Mapping[str, Sequence[Grasp]], models: Mapping[str, TrajectoryModels]
) -> bytes:
    """Draw the phase portraits of the grasps of some jars, and their models.

    Args:
        grasps: of each jar.
        models: of each jar.

    Returns:
        The picture as PNG.
    """
    size = Size(len(KINDS), len(grasps), max(3.2 * len(grasps), 8.0), 7.0)
    made = grid("Phase portraits of grasps", _OF, size, sharey="row")
    for column, (jar, felt) in zip(made.axes.T, grasps.items(), strict=True):
        for axes, kind in zip(column, KINDS, strict=True):
            shown = [grasp for grasp in felt if grasp.kind == kind]
            _draw_samples(axes, shown)
            _draw_models(axes, models[jar], shown)
            name(axes, f"{jar}\n{len(shown)} {_PLURAL[kind]}")
        column[-1].set_xlabel("residual ε [1]")
    made.axes[0, 0].set_xlim(left=_LEAST)
    made.axes[0, 0].xaxis.set_major_locator(MultipleLocator(_TICK))
    for axes in made.axes[:, 0]:
        axes.set_ylabel("rate dε/dt [1/s]")
    _name_below(made.figure, made.axes[0, 0])
    return png(made.figure)


def _draw_samples(axes: Axes, grasps: Sequence[Grasp]) -> None:
    for end, (held, colour) in enumerate(_ENDS.items()):
        samples = [grasp.samples for grasp in grasps if grasp.end == end]
        x, y = np.concatenate(samples)[:, :2].T if samples else ([], [])
        style = {"ms": 2.5, "mew": 0, "alpha": 0.45, "color": colour}
        axes.plot(x, y, "o", label=f"held by the {held}", **style)


def _draw_models(axes: Axes, models: TrajectoryModels, grasps: Sequence[Grasp]) -> None:
    """Draw the models that some of the grasps are of, where these have samples."""
    paths = [grasp.samples for grasp in grasps]
    if not paths:
        return
    of = categories(paths, models)
    for number in np.unique(of):
        own = np.concatenate([paths[one] for one in np.flatnonzero(of == number)])
        for stage in range(STAGES):
            samples = own[stages(own) == stage, :2]
            if _is_any_inside(samples, models, int(number), stage):
                _draw_model(axes, models, int(number), stage)


def _is_any_inside(
    samples: Floats, models: TrajectoryModels, number: int, stage: int
) -> bool:
    """Whether the ellipse of a model has one of the samples (n, 2) in it."""
    mean, deviation = models.mean[number][stage], models.deviation[number][stage]
    away = (samples - mean) / deviation
    return bool((np.linalg.norm(away, axis=1) <= _DEVIATIONS).any())


def _draw_model(axes: Axes, models: TrajectoryModels, number: int, stage: int) -> None:
    """An ellipse round the mean, with its number, beginning with 1, above it."""
    mean = models.mean[number][stage]
    wide, high = 2 * _DEVIATIONS * np.array(models.deviation[number][stage])
    style = {"fc": "none", "ec": INK, "lw": 0.9, "ls": ["-", ":"][stage]}
    axes.add_patch(Ellipse(mean, wide, high, **style))
    words = f"{number + 1}" + "'" * stage
    top = mean[0], mean[1] + high / 2
    offset = {"textcoords": "offset points", "ha": "center", "va": "bottom"}
    style = {"fontsize": SMALL - 1, "color": INK, "path_effects": _HALO, "zorder": 4}
    axes.annotate(words, top, (0, 1), **style, **offset)


def _name_below(figure: Figure, axes: Axes) -> None:
    """One legend for all panels."""
    handles, labels = axes.get_legend_handles_labels()
    style = {"frameon": False, "fontsize": SMALL, "ncols": len(labels)}
    legend = figure.legend(handles, labels, loc="outside lower center", **style)
    for handle in legend.legend_handles:
        handle.set(markersize=5, alpha=1)
