"""Q-values as tables: a row per action, a column per state."""

from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import SubFigure
from matplotlib.patches import Rectangle

from prospect_mj.agent.features import HapticState
from prospect_mj.experiment.paper.figures.figure_frame import (
    INK,
    SMALL,
    VERMILION,
)
from prospect_mj.experiment.paper.measures.bootstrap import Floats
from prospect_mj.task.presentation import Orientation

_LONG = 1e5
"""A number that is written by its power of ten."""
_HELD = {"none": "no hand", "left": "left hand", "right": "right hand"}


def draw_tables(
    figure: SubFigure,
    tables: Mapping[Orientation, Floats],
    actions: Sequence[str],
    states: Sequence[HapticState],
) -> None:
    """Draw a table per orientation, side by side; the best of a state has a frame.

    Args:
        figure: where they go.
        tables: (n_actions, n_states) [actions], by side of the lid.
        actions: names of the rows.
        states: those of the columns.
    """
    panels = figure.subplots(1, len(tables), sharey=True)
    low = min(table.min() for table in tables.values())
    high = max(table.max() for table in tables.values())
    for axes, (side, values) in zip(panels, tables.items(), strict=True):
        axes.imshow(values, aspect="auto", cmap="cividis", vmin=low, vmax=high)
        _write_numbers(axes, values, (low + high) / 2)
        _frame_best(axes, values)
        axes.set_xticks(range(len(states)), _names(states))
        title = f"lid {side}: mean Q [actions], the best one framed\n{_held_by(states)}"
        axes.set_title(title, loc="left", fontsize=SMALL, color=INK)
        axes.xaxis.tick_top()
        axes.tick_params(length=0, labelsize=SMALL)
        axes.spines[:].set_visible(False)
    panels[0].set_yticks(range(len(actions)), actions)


def _held_by(states: Sequence[HapticState]) -> str:
    """What the names of the states tell."""
    told = "" if len(states) == len(_HELD) else ", and the grasp's category"
    return f"the jar is held by{told}"


def _names(states: Sequence[HapticState]) -> list[str]:
    """Who holds the jar; with categories of grasps short, and which one it is."""
    if len(states) == len(_HELD):
        return [_HELD[state.holding] for state in states]
    return [
        "none" if s.holding == "none" else f"{s.holding}\n{s.category}" for s in states
    ]


def signed(value: float) -> str:
    """A number with its sign, and with two decimals as far as there is room for it."""
    if abs(value) >= _LONG:
        return f"{value:+.1e}".replace("-", "\N{MINUS SIGN}")
    # Adding zero makes a negative one positive.
    return f"{round(value, 2) + 0.0:+.2f}".replace("-", "\N{MINUS SIGN}")


def _write_numbers(axes: Axes, values: Floats, middle: float) -> None:
    for (row, column), value in np.ndenumerate(values):
        colour = "white" if value < middle else "black"
        words = signed(value).removeprefix("+")
        style = {"ha": "center", "va": "center", "fontsize": SMALL}
        axes.text(column, row, words, color=colour, **style)


def _frame_best(axes: Axes, values: Floats) -> None:
    for column, row in enumerate(values.argmax(axis=0)):
        corner = column - 0.47, row - 0.45
        axes.add_patch(
            Rectangle(corner, 0.94, 0.9, fill=False, edgecolor=VERMILION, lw=2)
        )
