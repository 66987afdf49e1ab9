"""The strategies of one run: their shares, and every single trial."""

from typing import NamedTuple

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Patch
from matplotlib.ticker import PercentFormatter
from numpy.typing import NDArray

from prospect_mj.experiment.paper.figures.figure_frame import SMALL
from prospect_mj.experiment.paper.figures.strategy_figure import LOOKS
from prospect_mj.experiment.paper.measures.bootstrap import Floats
from prospect_mj.experiment.populations.strategies import Strategy, easy
from prospect_mj.experiment.portraits.run_frame import name_of, run_panels, say_empty
from prospect_mj.experiment.portraits.trial_strategies import (
    TrialStrategies,
    set_edges,
    set_size,
)
from prospect_mj.experiment.run.plots import png
from prospect_mj.experiment.view.run_view import RunView
from prospect_mj.recording.hands import NUMBERS

_SHOWN = [LOOKS[strategy.name.lower()] for strategy in Strategy]
_FEW = 200
"""So many trials have room for a gap between them."""
_ROOM = 1.08
"""Height of a panel [1], so that the shade of the pretraining is seen over its bars."""


class _Kind(NamedTuple):
    """Trials that are shown together."""

    words: str
    trials: NDArray[np.bool_]
    """(n,)."""


def strategies(run: RunView) -> bytes:
    """Draw how the trials of a run were solved.

    Above, shares in sets of trials, of easy and difficult ones apart if there was a
    dominant hand; below, a tick for each trial.

    Returns:
        The picture as PNG.
    """
    found = TrialStrategies.of(run.trials, run.actions, run.config.world)
    kinds, single = _kinds(run, found)
    edges = set_edges(run.n_trials, run.config.pretrain)
    size = set_size(run.n_trials)
    of = f"{name_of(run)}: shares in sets of {size} trials; below, every single trial"
    heights = (2.2,) * len(kinds) + (0.9,) * len(single)
    height = 1.6 + sum(heights)
    panels = run_panels(run, "How the trials were solved", of, height, heights)
    for axes, kind in zip(panels, kinds, strict=False):
        _draw_shares(axes, edges, found.shares(kind.trials, edges))
        axes.set_ylabel(f"share of\n{kind.words} trials")
    for axes, kind in zip(panels[len(kinds) :], single, strict=True):
        _draw_trials(axes, kind.trials, found.strategy)
        axes.set_ylabel(kind.words, rotation=0, ha="right", va="center")
    _draw_legend(panels[0])
    return png(panels[0].figure)


def _kinds(run: RunView, found: TrialStrategies) -> tuple[list[_Kind], list[_Kind]]:
    """The kinds of trials whose shares are shown, and those that are shown singly."""
    if run.config.pretrain:
        is_easy = easy(found.lid, run.config.dominant)
        kinds = [_Kind("easy", is_easy), _Kind("difficult", ~is_easy)]
        return kinds, kinds
    sides = NUMBERS.items()
    single = [_Kind(f"lid\n{side}", found.lid == number) for side, number in sides]
    return [_Kind("all", np.ones(run.n_trials, np.bool_))], single


def _draw_shares(axes: Axes, edges: NDArray[np.intp], shares: Floats) -> None:
    """Shares (4, s) stacked up; nothing where there are no such trials."""
    there = np.isfinite(shares).all(axis=0)
    if not there.any():
        say_empty(axes)
    widths, begin = np.diff(edges)[there], edges[:-1][there]
    low = np.zeros(there.sum())
    for look, share in zip(_SHOWN, shares[:, there], strict=True):
        style = {"color": look.colour, "edgecolor": "white", "linewidth": 0.4}
        axes.bar(begin, share, widths, low, align="edge", **style)
        low = low + share
    axes.set_ylim(0, _ROOM)
    axes.yaxis.set_major_formatter(PercentFormatter(1, decimals=0, symbol=" %"))


def _draw_trials(
    axes: Axes, of_kind: NDArray[np.bool_], strategy: NDArray[np.int8]
) -> None:
    """A tick for each trial of a kind, at its strategy's height and in its colour."""
    single = strategy.size <= _FEW
    gap = 0.05 if single else 0.0
    if not of_kind.any():
        say_empty(axes)
    for number, look in enumerate(_SHOWN):
        trials = np.flatnonzero(of_kind & (strategy == number))
        ticks = [(trial + gap, 1 - 2 * gap) for trial in trials]
        # With an edge, a trial is seen even where it is thinner than a dot.
        axes.broken_barh(
            ticks, (number, 0.85), color=look.colour, lw=0 if single else 0.4
        )
    axes.set(yticks=[], ylim=(-0.15, len(_SHOWN)))


def _draw_legend(axes: Axes) -> None:
    patches = [Patch(color=look.colour, label=look.name) for look in _SHOWN]
    place = {"loc": "outside lower center", "ncols": len(_SHOWN)}
    axes.figure.legend(handles=patches, frameon=False, fontsize=SMALL, **place)
