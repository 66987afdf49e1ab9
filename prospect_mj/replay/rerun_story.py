"""What happened, in pictures and words: the look, the actions and their results."""

import mujoco
import rerun as rr

from prospect_mj.episodes.episode import ActionSpan, Episode
from prospect_mj.replay.timeline import column
from prospect_mj.robot.names import EYES, SIDES

IMAGES, HISTOGRAM, LOG = "look/images", "look/histogram", "log"
ACTION, CONTROLLER = "running/action", "running/controller"


def log_look(
    stream: rr.RecordingStream, model: mujoco.MjModel, episode: Episode
) -> None:
    """Log what the robot saw before it began; it doesn't look again."""
    look = episode.look
    for name, image in zip(EYES, look.images, strict=True):
        stream.log(f"{IMAGES}/{name}", rr.Image(image).compress(90), static=True)
    stream.log(HISTOGRAM, rr.BarChart(look.histogram, color=(90, 90, 90)), static=True)


def log_actions(stream: rr.RecordingStream, episode: Episode) -> None:
    """Log which action and which controllers ran, and what came of it."""
    start = episode.states.times[0]
    _log_lane(stream, ACTION, _actions(episode), start)
    for side in SIDES:
        spans = [
            (controller.name, controller.start, controller.end)
            for action in episode.actions
            for controller in action.controllers
            if controller.side == side
        ]
        _log_lane(stream, f"{CONTROLLER}/{side}", spans, start)
    _log_words(stream, episode)


def _actions(episode: Episode) -> list[tuple[str, float, float]]:
    """Those that moved something."""
    return [
        (span.outcome.action.label, span.start, span.end)
        for span in episode.actions
        if span.end > span.start
    ]


def _log_lane(
    stream: rr.RecordingStream,
    path: str,
    spans: list[tuple[str, float, float]],
    start: float,
) -> None:
    """A lane of what ran when, with gaps."""
    if not spans:
        return
    times, states = [], []
    for number, (name, first, last) in enumerate(sorted(spans, key=lambda s: s[1])):
        times.append(first - start)
        states.append(name)
        following = spans[number + 1][1] if number + 1 < len(spans) else None
        if following is None or following > last + 1e-6:
            times.append(last - start)
            states.append("")
    changes = rr.StateChange.columns(state=states)
    stream.send_columns(path, [column(times)], changes)


def _log_words(stream: rr.RecordingStream, episode: Episode) -> None:
    start = episode.states.times[0]
    lid = f"the lid lies to the {episode.presentation.orientation}"
    times, words = [0.0], [f"look: jar {episode.look.status}; {lid}"]
    levels = ["INFO"]
    for number, span in enumerate(episode.actions, start=1):
        times.append(span.end - start)
        words.append(f"{number}. {_told(span)}")
        levels.append("INFO" if span.outcome.result == "success" else "WARN")
    times.append(episode.states.times[-1] - start)
    words.append("inserted" if episode.inserted else "not inserted")
    levels.append("INFO" if episode.inserted else "ERROR")
    entries = rr.TextLog.columns(text=words, level=levels)
    stream.send_columns(LOG, [column(times)], entries)


def _told(span: ActionSpan) -> str:
    """One action in words; why, if it failed."""
    outcome = span.outcome
    words = f"{outcome.action.label}: {outcome.result}, {outcome.sim_seconds:.1f} s"
    reasons = [c.reason for c in span.controllers if c.status != "converged"]
    return f"{words} ({'; '.join(reasons)})" if reasons else words
