"""Where the picture of the automaton has its nodes, curves and words."""

from typing import NamedTuple

from prospect_mj.actions.action import Action
from prospect_mj.experiment.pictures.automaton_graph import (
    Attempt,
    Forbidden,
    Group,
    Node,
)
from prospect_mj.robot import names

WIDTH, HEIGHT = 27.2, 12.4
"""Of the drawing; one unit is as long across as it is up."""


class Point(NamedTuple):
    """A place in the drawing, from the middle of its lower edge."""

    x: float
    y: float


_GROUPS = {
    Group.SEEN: Point(0, 11.2),
    Group.LEFT: Point(-5.8, 6.2),
    Group.RIGHT: Point(5.8, 6.2),
    Group.UNKNOWN: Point(0, 6.2),
    Group.INSERTED: Point(0, 1.0),
}

_ATTEMPTS = {
    Attempt(Group.SEEN, Action.GRASP_LEFT): Point(-4.2, 9.6),
    Attempt(Group.SEEN, Action.GRASP_RIGHT): Point(4.2, 9.6),
    Attempt(Group.LEFT, Action.SWAP_LEFT_TO_RIGHT): Point(0, 8.2),
    Attempt(Group.RIGHT, Action.SWAP_RIGHT_TO_LEFT): Point(0, 4.2),
    Attempt(Group.LEFT, Action.INSERT_LEFT): Point(-4.2, 2.8),
    Attempt(Group.RIGHT, Action.INSERT_RIGHT): Point(4.2, 2.8),
    Attempt(Group.LEFT, Action.GRASP_LEFT): Point(-8.0, 9.3),
    Attempt(Group.LEFT, Action.GRASP_RIGHT): Point(-8.0, 4.2),
    Attempt(Group.RIGHT, Action.GRASP_RIGHT): Point(8.0, 9.3),
    Attempt(Group.RIGHT, Action.GRASP_LEFT): Point(8.0, 4.2),
}

_FORBIDDEN = {
    "an open hand over a held jar": Point(12.1, 9.3),
    "two arms in one workspace": Point(12.1, 4.2),
    "both hands pull on one jar": Point(12.1, 1.0),
}
"""Of the right side."""

BEGINNINGS = {Group.SEEN: Point(-4.4, 11.2), Group.UNKNOWN: Point(-2.9, 6.2)}
"""From where the arrows of the first look come."""


def place(node: Node) -> Point:
    """The middle of a node."""
    if isinstance(node, Forbidden):
        x, y = _FORBIDDEN[node.constraint]
        return Point(-names.sign(node.holder) * x, y)
    return _ATTEMPTS[node] if isinstance(node, Attempt) else _GROUPS[node]


def goes_back(source: Node, target: Node) -> bool:
    """Whether an outcome leaves everything in the group where the attempt began."""
    return isinstance(source, Attempt) and source.group == target


def bend(source: Node, target: Node) -> float:
    """Curvature of an arrow: the height of its arc over half its length."""
    if not goes_back(source, target):
        return 0.0
    x = place(source).x
    if x == 0:
        # The two swaps are each other's rotation; all else is left and right.
        return 0.5
    return (0.45 if target is Group.SEEN else -0.5) * (1 if x < 0 else -1)


def words_at(source: Node, target: Node) -> Point:
    """Where the words of an arrow are written: on its curve, clear of other arrows."""
    swapped_back = goes_back(source, target) and place(source).x == 0
    t = 0.26 if swapped_back else 0.46 if isinstance(target, Forbidden) else 0.5
    (x, y), (end_x, end_y) = place(source), place(target)
    # A quadratic Bezier curve, as matplotlib's arc3: its control point is off the
    # middle by the bend times the length.
    arc = 2 * t * (1 - t) * bend(source, target)
    return Point(
        x + t * (end_x - x) + arc * (end_y - y), y + t * (end_y - y) - arc * (end_x - x)
    )
