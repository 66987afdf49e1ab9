"""What a learner has learned, grey level by grey level."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from prospect_mj.agent.features import N_BINS
from prospect_mj.experiment.paper.figures.figure_frame import (
    BLUE,
    GREEN,
    INK,
    SMALL,
    VERMILION,
    write,
)
from prospect_mj.experiment.portraits.decisive_bins import MadeUpMind
from prospect_mj.experiment.portraits.value_tables import draw_tables, signed
from prospect_mj.experiment.run.plots import png
from prospect_mj.experiment.run.records import ACTION_NAMES

COLOURS = {"left": BLUE, "right": VERMILION}
"""Of what belongs to an orientation, by side of the lid."""
_AGAINST = "#cc79a7"
_BLOCKS = {
    "product": ("$v$", "$v\\,h_L$", "$v\\,h_R$"),
    "one_hot": ("$v$ where no hand holds the jar", "$v\\,h_L$", "$v\\,h_R$"),
}
_HEIGHTS = (1.5, 0.9, 1.05, 1.05, 1.05, 1.5)
_BINS = np.arange(N_BINS)


def weights(mind: MadeUpMind, reading: str, of: str) -> bytes:
    """Draw the weights over histogram bins, and what they make of both orientations.

    From above: mean histograms and their difference; the weights of the three blocks of
    features, on one scale; what each bin contributes to the choice of the hand
    (`decisive_bins`); Q of all actions.

    Args:
        mind: what is drawn.
        reading: `FeatureSettings.reading` of the run.
        of: what it is of, in words.

    Returns:
        The picture as PNG.
    """
    figure = Figure(figsize=(8, 12), dpi=150, layout="constrained")
    above, below = figure.subfigures(2, height_ratios=(sum(_HEIGHTS), 2.5))
    panels = above.subplots(len(_HEIGHTS), sharex=True, height_ratios=_HEIGHTS)
    histograms, difference, *images, decisive = panels
    title = {"fontweight": "bold", "fontsize": 12, "color": "black"}
    over = {"xycoords": "axes fraction", "va": "bottom"}
    write(histograms, "Which grey levels decide", (0, 1), (0, 38), **over, **title)
    write(histograms, of, (0, 1), (0, 22), **over)
    _draw_histograms(histograms, mind)
    _draw_difference(difference, mind)
    _draw_weights(images, mind, _BLOCKS[reading])
    _draw_contributions(decisive, mind)
    decisive.set_xlim(-0.5, N_BINS - 0.5)
    decisive.set_xlabel("histogram bin, from dark to bright")
    draw_tables(below, mind.q_values, ACTION_NAMES, mind.states)
    return png(figure)


def _draw_histograms(axes: Axes, mind: MadeUpMind) -> None:
    for side, v in mind.v.items():
        axes.step(_BINS, v, where="mid", color=COLOURS[side], label=f"lid {side}")
    axes.set(ylim=(0, None), ylabel="mean $v$")
    place = {"loc": "lower right", "bbox_to_anchor": (1, 1), "borderaxespad": 0}
    axes.legend(frameon=False, fontsize=SMALL, ncols=len(mind.v), **place)
    _tidy(axes)


def _draw_difference(axes: Axes, mind: MadeUpMind) -> None:
    difference = mind.v["left"] - mind.v["right"]
    colours = np.where(difference > 0, COLOURS["left"], COLOURS["right"])
    axes.bar(_BINS, difference, width=1, color=colours)
    axes.axhline(0, color=INK, linewidth=0.8)
    axes.set_ylabel("lid left\nminus right")
    _tidy(axes)


def _draw_weights(
    panels: list[Axes], mind: MadeUpMind, blocks: tuple[str, ...]
) -> None:
    """An image (6, 100) per block, all on one scale that is symmetric about zero."""
    # Where nothing was learned yet, and weights began at zero, any scale will do.
    largest = np.abs(mind.weights).max() or 1.0
    for number, (axes, name) in enumerate(zip(panels, blocks, strict=True)):
        image = axes.imshow(
            mind.weights[:, number],
            aspect="auto",
            interpolation="nearest",
            cmap="RdBu",
            vmin=-largest,
            vmax=largest,
        )
        axes.set_yticks(range(len(ACTION_NAMES)), ACTION_NAMES, fontsize=7.5)
        axes.tick_params(axis="y", length=0)
        axes.set_title(
            f"weights of {name}", loc="left", fontsize=SMALL, color=INK, pad=3
        )
    bar = panels[0].figure.colorbar(image, ax=panels, pad=0.01, aspect=30)
    bar.set_label("weight [actions]", fontsize=SMALL)
    bar.ax.tick_params(labelsize=SMALL)


def _draw_contributions(axes: Axes, mind: MadeUpMind) -> None:
    share = mind.contributions
    axes.bar(_BINS, share, width=1, color=np.where(share > 0, GREEN, _AGAINST))
    axes.axhline(0, color=INK, linewidth=0.8)
    axes.set_ylabel("contribution\n[actions]")
    axes.set_title(_decision(mind), loc="left", fontsize=SMALL, color=INK, pad=3)
    _tidy(axes)


def _decision(mind: MadeUpMind) -> str:
    """What the contributions add up to, in words."""
    told = [
        f"{signed(value)} with the lid {s}" for s, value in mind.preferences.items()
    ]
    return (
        "what each bin adds to the choice of the hand (above 0: of that on the lid's "
        f"side), {signed(mind.contributions.sum())} in all:\n"
        f"Q(grasp-left) \N{MINUS SIGN} Q(grasp-right) is {' and '.join(told)}"
    )


def _tidy(axes: Axes) -> None:
    axes.spines[["top", "right"]].set_visible(False)
    axes.grid(axis="y", color="#e6e6e6", linewidth=0.8)
    axes.set_axisbelow(True)
