"""Dots with their intervals, beside each other where several are of one place."""

from math import isinf, isnan
from typing import NamedTuple

from matplotlib.axes import Axes
from matplotlib.transforms import ScaledTranslation

from prospect_mj.experiment.paper.measures.bootstrap import Interval

BEYOND = 660
"""Where what is never gone is drawn [trials]; six hundred follow the pretraining."""

SIZE, _ARROW = 4.2, 6.0
"""Diameter of a dot, and height of an arrow [points]."""
_GAP = 0.6
"""Between dots of one place [points]."""
_LINE = 1.5
"""Width of an interval [points]."""
_POINTS = 72.0
"""In an inch."""


class Look(NamedTuple):
    """How a measure is drawn."""

    colour: str
    aside: float = 0.0
    """From its place, across the axis of values, up or to the right [points]."""
    upright: bool = False
    """Whether values go upwards; else to the right."""
    scale: float = 1.0
    """Of the axis, to one of the measure."""


def asides(number: int) -> list[float]:
    """Where dots of one place are, so that equal values don't hide each other.

    They are moved across the axis of values: what they say stays true.

    Args:
        number: of the dots.

    Returns:
        From the place's middle [points], in rising order.
    """
    step = SIZE + _GAP
    return [step * (one - (number - 1) / 2) for one in range(number)]


def dot(axes: Axes, found: Interval, place: float, look: Look) -> None:
    """Draw a dot and its interval, or an arrow for what is never gone.

    Args:
        axes: the panel.
        found: what is drawn; nothing if it isn't there.
        place: on the other axis.
        look: how it is drawn.
    """
    if isnan(found.estimate):
        return
    low, value, high = (
        min(look.scale * (found.estimate if isnan(one) else one), BEYOND)
        for one in (found.low, found.estimate, found.high)
    )
    shift = (look.aside, 0.0) if look.upright else (0.0, look.aside)
    inches = axes.figure.dpi_scale_trans
    moved = ScaledTranslation(*(one / _POINTS for one in shift), inches)
    style = {"color": look.colour, "transform": axes.transData + moved}
    ends, there = ([low, high], [place, place]), ([value], [place])
    if look.upright:
        ends, there = ends[::-1], there[::-1]
    axes.plot(*ends, linewidth=_LINE, alpha=0.6, **style)
    arrow = "^" if look.upright else ">"
    marker, size = (arrow, _ARROW) if isinf(found.estimate) else ("o", SIZE)
    axes.plot(*there, marker=marker, markersize=size, markeredgewidth=0, **style)
