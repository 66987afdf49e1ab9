"""Learning curves of all learners in one picture, with names beside them."""

from collections.abc import Mapping

import numpy as np
import pyarrow as pa
import pyarrow.compute as pc
from matplotlib.axes import Axes

from prospect_mj.experiment.development.rivals.settings import (
    DQN_ANNEALED,
    DQN_CONSTANT,
    LINEAR,
    LINEAR_MASKED,
    MASKABLE_PPO,
    RivalSettings,
)
from prospect_mj.experiment.paper.figures.direct_labels import Named, write_names
from prospect_mj.experiment.paper.figures.figure_frame import (
    BLUE,
    GREEN,
    INK,
    VERMILION,
    Heading,
    columns,
    middles,
    panels,
    set_trials,
    write,
)
from prospect_mj.experiment.paper.measures.bootstrap import Floats
from prospect_mj.experiment.paper.measures.curves import SMOOTHED, moving_means
from prospect_mj.experiment.run.learning_curve import BLOCK, NEAR_OPTIMAL
from prospect_mj.experiment.run.plots import png

NAMES = {
    LINEAR: "linear",
    LINEAR_MASKED: "linear, masked",
    DQN_ANNEALED: "DQN, annealed ε",
    DQN_CONSTANT: "DQN, constant ε",
    MASKABLE_PPO: "MaskablePPO",
}
"""Of the learners, for people."""
_COLOURS = {
    LINEAR: "#000000",
    LINEAR_MASKED: BLUE,
    DQN_ANNEALED: VERMILION,
    DQN_CONSTANT: "#cc79a7",
    MASKABLE_PPO: GREEN,
}
_DASHED = (0, (6, 3))
_HEIGHT = 4.8
_MOST = 10
"""Top of the axis: where trials are cut off [actions]."""


def learning_curves(curves: pa.Table, settings: RivalSettings) -> bytes:
    """Draw mean actions per trial of all learners.

    Args:
        curves: under `learning.CURVES`.
        settings: what was compared.

    Returns:
        The picture as PNG.
    """
    heading = Heading(
        "Rivals on the same task",
        f"means over runs and over {BLOCK * SMOOTHED} trials; bands: 95 % of means of "
        f"{settings.deep_runs} runs, resampled",
    )
    (axes,) = panels(heading, _HEIGHT, (1,))
    agents = pc.unique(curves["agent"]).to_pylist()
    data = {a: columns(curves.filter(pc.field("agent") == a)) for a in agents}
    trials = data[agents[0]]["trial"].astype(np.float64)
    set_trials([axes], heading, trials)
    axes.set_ylabel("actions per trial")
    axes.set_ylim(1.5, _MOST)
    axes.axhline(NEAR_OPTIMAL, color=INK, linewidth=0.8, linestyle=_DASHED)
    words = f"near-optimal: {NEAR_OPTIMAL}"
    write(axes, words, (trials[0], NEAR_OPTIMAL), (5, -3), va="top")
    named = _draw(axes, data, middles(trials))
    ends = np.array([[0.0, NEAR_OPTIMAL], [trials[-1], NEAR_OPTIMAL]])
    write_names(axes, named, [ends])
    return png(axes.figure)


def _draw(
    axes: Axes, data: Mapping[str, Mapping[str, Floats]], middle: Floats
) -> list[Named]:
    """Every learner's mean with its band; what is to be named."""
    named, places = [], _smooth(middle)
    for agent in data:
        curve = data[agent]
        mean, low, high = (_smooth(curve[name]) for name in ("actions", "low", "high"))
        colour = _COLOURS[agent]
        axes.fill_between(places, low, high, color=colour, alpha=0.12, lw=0)
        axes.plot(places, mean, color=colour, linewidth=1.6)
        line = np.column_stack([places, mean])
        named.append(Named(NAMES[agent], colour, [line]))
    return named


def _smooth(values: Floats) -> Floats:
    """Means over five successive sets."""
    return moving_means(values[None])[0]
