"""A picture of the supervised automaton, and of what supervision keeps it from."""

import textwrap
from typing import Any

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.text import Text

from prospect_mj.experiment.pictures.automaton_graph import (
    Attempt,
    Forbidden,
    Group,
    Node,
    summary,
)
from prospect_mj.experiment.pictures.automaton_layout import (
    BEGINNINGS,
    HEIGHT,
    WIDTH,
    Point,
    bend,
    place,
    words_at,
)
from prospect_mj.experiment.run.plots import png

_INK = "#24313f"
_END = "#3b7fb5"
_LOST = "#a9b2bb"
_RED = "#b8322a"
_PINK = "#fbe6e3"
_FILLS = {
    Group.SEEN: "#eef3f8",
    Group.LEFT: "#e3eef7",
    Group.RIGHT: "#e3eef7",
    Group.INSERTED: "#e2f1e4",
    Group.UNKNOWN: "#efefef",
}
_OTHER_HANDS = {Group.LEFT: "right hand empty", Group.RIGHT: "left hand empty"}
_DASHES = (0, (4, 2))
_THICK, _THIN = 1.7, 1.1
_MARKED = 2.6
_CROSS = "\N{MULTIPLICATION X}"
_LEGEND_HEIGHT = 0.08

Style = dict[str, Any]


def automaton() -> bytes:
    """Draw the automaton under supervision.

    Returns:
        The picture as PNG.
    """
    return png(drawing())


def drawing() -> Figure:
    """The picture before it is rendered."""
    width = 13.0
    height = width * HEIGHT / WIDTH / (1 - _LEGEND_HEIGHT)
    figure = Figure(figsize=(width, height), dpi=130)
    axes = figure.add_axes((0, _LEGEND_HEIGHT, 1, 1 - _LEGEND_HEIGHT))
    axes.set(xlim=(-WIDTH / 2, WIDTH / 2), ylim=(0, HEIGHT))
    axes.set_axis_off()
    graph = summary()
    boxes = {node: _box(axes, node, graph.nodes[node]) for node in graph}
    # Arrows end at the frames, which have no size before they are laid out.
    figure.draw_without_rendering()
    for source, target, edge in graph.edges(data=True):
        attempt = source if isinstance(source, Attempt) else target
        disabled = graph.nodes[attempt]["disabled"]
        style = _arrow_style(target, disabled, bend(source, target))
        _arrow(axes, place(source), boxes[target], style, boxes[source])
        words = _words(edge.get("results", ()), disabled)
        _write(axes, words_at(source, target), words, style["color"])
    for group, start in BEGINNINGS.items():
        style = _arrow_style(group, disabled=False, bent=0.0) | {"color": _END}
        _arrow(axes, start, boxes[group], style)
        words = "look:\nsuccess" if group is Group.SEEN else "look:\nnot seen"
        _write(axes, start, words, _END)
    _legend(figure)
    return figure


def _box(axes: Axes, node: Node, told: Style) -> Text:
    """Draw a node; `told` is what the graph knows of it."""
    frame: Style = {"boxstyle": "round,pad=0.45", "ec": _INK, "lw": 1.2}
    colour, size = _INK, 9.5
    if isinstance(node, Group):
        text = f"{node}\n{_OTHER_HANDS.get(node, 'both hands empty')}"
        frame |= {"fc": _FILLS[node], "lw": _MARKED if told["marked"] else 1.2}
    elif isinstance(node, Forbidden):
        text, colour, size = textwrap.fill(node.constraint, 15), _RED, 9.0
        frame |= {"fc": _PINK, "ec": _RED, "lw": 1.6, "boxstyle": "square,pad=0.5"}
    else:
        line = _RED if told["disabled"] else _INK
        fill, colour = ("white", _RED) if told["disabled"] else (_INK, "white")
        text, size = node.action.label.replace("-", " "), 8.5
        rounded = "round,pad=0.35,rounding_size=0.9"
        frame |= {"fc": fill, "ec": line, "boxstyle": rounded}
    text_style: Style = {"color": colour, "size": size, "ha": "center", "va": "center"}
    return axes.text(*place(node), text, bbox=frame, zorder=3, **text_style)


def _arrow_style(target: Node, disabled: bool, bent: float) -> Style:
    """Thick and whole for a start, thin and dashed for an end, red if disabled."""
    starts = isinstance(target, Attempt)
    end = _LOST if target is Group.UNKNOWN else _END
    return {
        "color": _RED if disabled else _INK if starts else end,
        "lw": _THICK if starts else _THIN,
        "ls": "-" if starts and not disabled else _DASHES,
        "connectionstyle": f"arc3,rad={bent}",
    }


def _arrow(
    axes: Axes, start: Point, target: Text, style: Style, source: Text | None = None
) -> None:
    """Draw an arrow from a place, or from the frame of a source that is there."""
    ends: Style = {
        "arrowstyle": "-|>",
        "mutation_scale": 11,
        "shrinkA": 0,
        "shrinkB": 1,
        "patchA": None if source is None else source.get_bbox_patch(),
        "patchB": target.get_bbox_patch(),
    }
    axes.annotate("", target.get_position(), start, arrowprops=ends | style, zorder=1)


def _words(results: tuple[str, ...], disabled: bool) -> str:
    """The results that an arrow stands for; a cross on a start that is disabled."""
    if not results:
        return _CROSS if disabled else ""
    ordered = sorted(results, key=lambda result: (result != "success", result))
    return ",\n".join(ordered).replace("_", " ")


def _write(axes: Axes, where: Point, words: str, colour: str) -> None:
    if words:
        axes.text(
            *where,
            words,
            size=13 if words == _CROSS else 8,
            color=colour,
            ha="center",
            va="center",
            zorder=2,
            bbox={"fc": "white", "ec": "none", "pad": 1.0},
        )


def _legend(figure: Figure) -> None:
    thin: Style = {"lw": _THIN, "ls": _DASHES}
    handles = [
        Line2D([], [], color=_INK, lw=_THICK, label="start of an action, controllable"),
        Line2D([], [], color=_END, label="its end, uncontrollable", **thin),
        Line2D([], [], color=_RED, label="disabled by the supervisor", **thin),
        Patch(fc=_PINK, ec=_RED, label="forbidden"),
        Patch(fc="white", ec=_INK, lw=_MARKED, label="a trial may end here"),
    ]
    figure.legend(handles=handles, loc="lower center", ncols=5, frameon=False)
