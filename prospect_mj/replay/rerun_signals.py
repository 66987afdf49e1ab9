"""What controllers and sensors measure, as curves in Rerun."""

import numpy as np
import rerun as rr
from numpy.typing import NDArray

from prospect_mj.actions.action import Action
from prospect_mj.episodes.episode import QUANTITIES, Episode
from prospect_mj.replay.playback import Frames
from prospect_mj.replay.rerun_scene import COLOURS
from prospect_mj.replay.timeline import column
from prospect_mj.robot.names import SIDES, Side

Q_VALUES, WRIST, TOUCH = "q_values", "forces/wrist", "forces/fingertips"
UNITS = {
    "position_error": ("errors/position", 1e3, "mm"),
    "angle_error": ("errors/angle", np.rad2deg(1.0), "deg"),
    "joint_error": ("errors/joint", np.rad2deg(1.0), "deg"),
    "way_left": ("way_left", 1.0, "rad"),
    "residual": ("grasp_residual", 1.0, "1"),
    "contact_force": ("forces/insertion", 1.0, "N"),
    "load": ("forces/load", 1.0, "N"),
}
"""Where each quantity is drawn, in which unit, and how many of it make one."""


def log_measured(stream: rr.RecordingStream, episode: Episode) -> None:
    """Log what the controllers measured, each where there is something."""
    times = episode.signals.times - episode.states.times[0]
    for number, name in enumerate(QUANTITIES):
        path, scale, unit = UNITS[name]
        for arm, side in enumerate(SIDES):
            values = scale * episode.signals.measured[:, arm, number].astype(float)
            _curve(stream, f"{path}/{side}", side, f"{side} [{unit}]", times, values)


def log_forces(stream: rr.RecordingStream, frames: Frames) -> None:
    """Log what wrists and fingertips feel."""
    for arm, side in enumerate(SIDES):
        wrist, name = frames.wrist_forces[:, arm], f"{side} wrist [N]"
        _curve(stream, f"{WRIST}/{side}", side, name, frames.times, wrist)
        press, name = frames.touch_forces[:, arm].sum(axis=1), f"{side} fingers [N]"
        _curve(stream, f"{TOUCH}/{side}", side, name, frames.times, press)


def log_q_values(
    stream: rr.RecordingStream, episode: Episode, values: NDArray[np.float64]
) -> None:
    """Log the learner's estimates (a, 6) when each action was chosen."""
    starts = [span.start - episode.states.times[0] for span in episode.actions]
    # Once more at the end, or the last one would be a point.
    times = [*starts, episode.states.times[-1] - episode.states.times[0]]
    for action in Action:
        estimates = [*values[:, action], values[-1, action]]
        path = f"{Q_VALUES}/{action.label}"
        curve = rr.Scalars.columns(scalars=estimates)
        stream.send_columns(path, [column(times)], curve)
        lines = rr.SeriesLines(names=[action.label], interpolation_mode="StepAfter")
        stream.log(path, lines, static=True)


def _curve(
    stream: rr.RecordingStream,
    path: str,
    side: Side,
    name: str,
    times: NDArray[np.float64],
    values: NDArray[np.float64],
) -> None:
    """A curve with gaps where there is nothing; none without anything."""
    there = ~np.isnan(values)
    if not there.any():
        return
    # A row with nothing in it ends a stretch, or a line would be drawn over the gap.
    shown = there | np.append(False, there[:-1])
    curve = rr.Scalars.columns(scalars=values[there])
    rows = curve.partition(there[shown].astype(np.int64))
    stream.send_columns(path, [column(times[shown])], rows)
    lines = rr.SeriesLines(names=[name], colors=[COLOURS[side]], widths=[1.5])
    stream.log(path, lines, static=True)
