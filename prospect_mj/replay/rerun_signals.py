"""Panels of curves in Rerun."""

from collections.abc import Iterable

import numpy as np
import rerun as rr

from prospect_mj.replay.panels import Curve, Panel
from prospect_mj.replay.timeline import column

_WIDTH, _DOT = 1.5, 3.0
"""[points]"""


def log_panels(stream: rr.RecordingStream, panels: Iterable[Panel]) -> None:
    """Log all curves of all panels, each under its panel's path."""
    for panel in panels:
        for curve in panel.curves:
            _log_curve(stream, entity(panel, curve), curve)


def entity(panel: Panel, curve: Curve) -> str:
    """The path of a curve's entity."""
    return f"{panel.origin}/{curve.name.replace(' ', '_')}"


def _log_curve(stream: rr.RecordingStream, path: str, curve: Curve) -> None:
    """A curve with gaps where there is nothing."""
    there = ~np.isnan(curve.values)
    # A row with nothing in it ends a stretch, or a line would be drawn over the gap;
    # of dots it would be one at 0.
    shown = there if curve.dots else there | np.append(False, there[:-1])
    scalars = rr.Scalars.columns(scalars=curve.values[there])
    rows = scalars.partition(there[shown].astype(np.int64))
    stream.send_columns(path, [column(curve.times[shown])], rows)
    stream.log(path, _look(curve), static=True)


def _look(curve: Curve) -> rr.SeriesPoints | rr.SeriesLines:
    named = {"names": [curve.name], "colors": [curve.colour]}
    if curve.dots:
        return rr.SeriesPoints(**named, marker_sizes=[_DOT], markers="circle")
    mode = "StepAfter" if curve.steps else "Linear"
    return rr.SeriesLines(**named, widths=[_WIDTH], interpolation_mode=mode)
