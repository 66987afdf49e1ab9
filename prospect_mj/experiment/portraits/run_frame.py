"""What pictures over the trials of a run share: panels, and the phases of the run."""

from collections.abc import Sequence

from matplotlib.axes import Axes
from matplotlib.ticker import MaxNLocator

from prospect_mj.experiment.paper.figures.figure_frame import (
    INK,
    SHADE,
    Heading,
    panels,
    write,
)
from prospect_mj.experiment.view.run_view import RunView

_LONGEST = 24
"""Letters that are shown of a folder's name."""


def run_panels(
    run: RunView, title: str, of: str, height: float, ratios: tuple[float, ...]
) -> list[Axes]:
    """Panels over all finished trials, one upon the other, with the pretraining shaded.

    Args:
        run: the run.
        title: stands over the first one.
        of: what the panels show.
        height: of the figure [inches].
        ratios: the panels' heights relative to each other.
    """
    pretrain = min(run.config.pretrain, run.n_trials)
    axes = panels(Heading(title, of, pretrain), height, ratios)
    axes[0].set_xlim(0, run.n_trials)
    axes[-1].xaxis.set_major_locator(MaxNLocator(integer=True))
    _shade(axes, pretrain, run)
    return axes


def say_empty(axes: Axes) -> None:
    """Say in a panel that no trial belongs into it."""
    place = {"xycoords": "axes fraction", "ha": "center", "va": "center"}
    write(axes, "no such trial", (0.5, 0.5), (0, 0), **place)


def name_of(run: RunView) -> str:
    """A run in words, few enough to stand over a picture."""
    name = run.path.resolve().name
    if len(name) > _LONGEST:
        name = f"{name[: _LONGEST - 1]}\N{HORIZONTAL ELLIPSIS}"
    # Else Matplotlib would read mathematics between two of them.
    name = name.replace("$", r"\$")
    return f"run {name}, seed {run.config.seed}"


def _shade(axes: Sequence[Axes], pretrain: int, run: RunView) -> None:
    if not pretrain:
        return
    for one in axes:
        one.axvspan(0, pretrain, color=SHADE, lw=0, zorder=0)
        if pretrain < run.n_trials:
            one.axvline(pretrain, color=INK, linewidth=0.8)
    style = {"xycoords": "axes fraction", "va": "bottom", "style": "italic"}
    first = f"pretraining: lid {run.config.dominant} only (easy)"
    write(axes[0], first, (0, 1), (3, 3), **style)
    if pretrain < run.n_trials:
        then = f"both orientations from trial {pretrain}"
        write(axes[0], then, (1, 1), (-3, 3), ha="right", **style)
