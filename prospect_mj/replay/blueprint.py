"""How Rerun's viewer lays an episode out, so that the first look tells the story."""

import rerun.blueprint as rrb

from prospect_mj.replay import rerun_signals, rerun_story
from prospect_mj.replay.timeline import TIMELINE
from prospect_mj.sim import overview


def blueprint(with_values: bool) -> rrb.Blueprint:
    """Scene and lanes to the left; what was seen, felt and thought to the right.

    Args:
        with_values: whether there are estimates of a learner to be shown.
    """
    scene = rrb.Spatial3DView(
        origin="scene",
        name="Torso",
        background=(245, 245, 247),
        line_grid=False,
        eye_controls=_eye(),
    )
    lanes = rrb.StateTimelineView(origin="running", name="What runs")
    left = rrb.Vertical(scene, lanes, row_shares=[4, 1])
    return rrb.Blueprint(
        rrb.Horizontal(left, _seen_and_felt(with_values), column_shares=[3, 2]),
        rrb.BlueprintPanel(state="hidden"),
        rrb.SelectionPanel(state="hidden"),
        rrb.TimePanel(state="collapsed", timeline=TIMELINE),
    )


def _seen_and_felt(with_values: bool) -> rrb.Vertical:
    look = rrb.Horizontal(
        rrb.Spatial2DView(origin=f"{rerun_story.IMAGES}/left_eye", name="Left eye"),
        rrb.Spatial2DView(origin=f"{rerun_story.IMAGES}/right_eye", name="Right eye"),
        rrb.BarChartView(origin=rerun_story.HISTOGRAM, name="Histogram"),
    )
    curves = [
        _curves("errors", "Errors [mm, deg]"),
        _curves("grasp_residual", "Grasp residual"),
        _curves("forces", "Forces [N]"),
    ]
    if with_values:
        curves.append(_curves(rerun_signals.Q_VALUES, "Q-values"))
    words = rrb.TextLogView(origin=rerun_story.LOG, name="What came of it")
    shares = [3, *([2] * len(curves)), 2]
    return rrb.Vertical(look, *curves, words, row_shares=shares)


def _curves(origin: str, name: str) -> rrb.TimeSeriesView:
    """Curves with their names where new ones seldom are."""
    return rrb.TimeSeriesView(
        origin=origin, name=name, plot_legend=rrb.Corner2D.RightTop
    )


def _eye() -> rrb.archetypes.EyeControls3D:
    """From where the overview camera looks."""
    return rrb.archetypes.EyeControls3D(
        position=overview.place(), look_target=overview.LOOK_AT, eye_up=(0, 0, 1)
    )
