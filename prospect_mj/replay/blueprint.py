"""How Rerun's viewer lays an episode out, so that the first look tells the story."""

from collections.abc import Mapping, Sequence

import numpy as np
import rerun as rr
import rerun.blueprint as rrb

from prospect_mj.replay import eye, rerun_scene, rerun_story
from prospect_mj.replay.panels import (
    FINGERTIPS,
    IK_ANGLE,
    IK_POSITION,
    INSERTION,
    JOINT_ERROR,
    Q_VALUES,
    RESIDUAL,
    WAY_LEFT,
    WRIST,
    Panel,
)
from prospect_mj.replay.timeline import TIMELINE

_SKY = (205, 211, 219)
_HEADROOM = 1.35
"""Height of a panel per that of its highest curve; the legend has the rest."""
_MARGIN = 0.08
"""Above and below the estimates, of the height that they take."""
_BESIDE = 1.3
"""Width of the panel of six curves per that of the episode, for the same reason."""
_TALL = 1.2
"""Height of a row with one view alone per that of the others."""


def blueprint(title: str, panels: Sequence[Panel], end: float) -> rrb.Blueprint:
    """Scene, lanes and words to the left; what was seen, felt and thought to the right.

    Args:
        title: what is shown.
        panels: of curves.
        end: how long it lasts [s].
    """
    happening = rrb.Vertical(_scene(title), _lanes(end), _words(), row_shares=[9, 3, 4])
    return rrb.Blueprint(
        rrb.Horizontal(happening, _measured(panels, end), column_shares=[11, 9]),
        rrb.BlueprintPanel(state="hidden"),
        rrb.SelectionPanel(state="hidden"),
        rrb.TimePanel(state="collapsed", timeline=TIMELINE),
    )


def _scene(title: str) -> rrb.Spatial3DView:
    return rrb.Spatial3DView(
        origin=rerun_scene.ROOT,
        name=title,
        background=_SKY,
        line_grid=False,
        eye_controls=rrb.archetypes.EyeControls3D(
            position=eye.place(), look_target=eye.TARGET, eye_up=(0, 0, 1)
        ),
    )


def _lanes(end: float) -> rrb.StateTimelineView:
    return rrb.StateTimelineView(
        origin=rerun_story.LANES, name="Action and controllers", time_view=_time(end)
    )


def _words() -> rrb.TextLogView:
    columns = rrb.archetypes.TextLogColumns(
        timeline_columns=[TIMELINE], text_log_columns=["LogLevel", "Body"]
    )
    return rrb.TextLogView(
        origin=rerun_story.LOG, name="What came of it", columns=columns
    )


def _measured(panels: Sequence[Panel], end: float) -> rrb.Vertical:
    look = rrb.Horizontal(
        rrb.Spatial2DView(origin=f"{rerun_story.IMAGES}/left_eye", name="Left eye"),
        rrb.Spatial2DView(origin=f"{rerun_story.IMAGES}/right_eye", name="Right eye"),
        rrb.BarChartView(
            origin=rerun_story.HISTOGRAM,
            name="Histogram of grey levels",
            plot_legend=rrb.PlotLegend(visible=False),
        ),
        column_shares=[2, 2, 3],
    )
    views = {panel.origin: _curves(panel, end) for panel in panels}
    rows = [[look], *_rows(views)]
    shares = [_TALL if len(row) == 1 else 1.0 for row in rows]
    return rrb.Vertical(*(_row(row) for row in rows), row_shares=shares)


def _rows(views: Mapping[str, rrb.TimeSeriesView]) -> list[list[rrb.View | rrb.Tabs]]:
    """Two to a row, those away that there is nothing of."""
    named = [
        [views.get(IK_POSITION), views.get(IK_ANGLE)],
        [_tabs(views, WAY_LEFT, JOINT_ERROR), views.get(RESIDUAL)],
        [views.get(FINGERTIPS), _tabs(views, WRIST, INSERTION)],
        [views.get(Q_VALUES)],
    ]
    rows = [[view for view in row if view is not None] for row in named]
    return [row for row in rows if row]


def _tabs(
    views: Mapping[str, rrb.TimeSeriesView], *names: str
) -> rrb.Tabs | rrb.View | None:
    """One in front of the other."""
    there = [views[name] for name in names if name in views]
    if len(there) < 2:
        return there[0] if there else None
    return rrb.Tabs(*there)


def _row(views: Sequence[rrb.View | rrb.Container]) -> rrb.View | rrb.Container:
    return views[0] if len(views) == 1 else rrb.Horizontal(*views)


def _curves(panel: Panel, end: float) -> rrb.TimeSeriesView:
    shown = _BESIDE * end if panel.origin == Q_VALUES else end
    return rrb.TimeSeriesView(
        origin=panel.origin,
        name=panel.title,
        axis_x=_time(shown),
        axis_y=rrb.ScalarAxis(range=_range(panel)),
        plot_legend=rrb.Corner2D.RightTop,
    )


def _range(panel: Panel) -> tuple[float, float]:
    """From 0 to above the highest value; that of estimates is as wide as they are."""
    values = np.concatenate([curve.values for curve in panel.curves])
    low, high = float(np.nanmin(values)), float(np.nanmax(values))
    if panel.origin == Q_VALUES:
        margin = _MARGIN * (high - low) or 1.0
        return low - margin, high + margin
    return min(0.0, low), _HEADROOM * max(0.0, high) or 1.0


def _time(end: float) -> rrb.TimeAxis:
    """From the beginning of the episode."""
    stretch = rr.TimeRange(
        start=rr.TimeRangeBoundary.absolute(seconds=0.0),
        end=rr.TimeRangeBoundary.absolute(seconds=end),
    )
    return rrb.TimeAxis(view_range=stretch)
