"""What happened, in pictures and words: the look, the actions and their results."""

import re
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import rerun as rr

from prospect_mj.control.result import Status
from prospect_mj.episodes.episode import ActionSpan, ControllerSpan, Episode
from prospect_mj.replay import colours
from prospect_mj.replay.colours import Colour
from prospect_mj.replay.timeline import changes, column
from prospect_mj.robot.names import EYES, SIDES

IMAGES, HISTOGRAM, LOG = "look/images", "look/histogram", "log"
LANES = "running"
ACTION = f"{LANES}/action"
_GREY = (165, 165, 172)


class _Stretch(NamedTuple):
    """A part of a lane."""

    words: str
    colour: Colour
    start: float
    """[s]"""
    end: float
    """[s]"""


def log_look(stream: rr.RecordingStream, episode: Episode) -> None:
    """Log what the robot saw before it began; it doesn't look again."""
    look = episode.look
    for name, image in zip(EYES, look.images, strict=True):
        stream.log(f"{IMAGES}/{name}", rr.Image(image).compress(90), static=True)
    stream.log(HISTOGRAM, rr.BarChart(look.histogram, color=_GREY), static=True)


def log_lanes(stream: rr.RecordingStream, episode: Episode) -> None:
    """Log which action and which controllers ran."""
    start = episode.states.times[0]
    # An action that was not let run takes no time, and has no stretch.
    moved = [
        _of_action(number, span)
        for number, span in enumerate(episode.actions, start=1)
        if span.end > span.start
    ]
    _log_lane(stream, ACTION, moved, start)
    for side in SIDES:
        stretches = [
            _of_controller(controller)
            for span in episode.actions
            for controller in span.controllers
            if controller.side == side
        ]
        _log_lane(stream, f"{LANES}/{side}_arm", stretches, start)


def _of_action(number: int, span: ActionSpan) -> _Stretch:
    """The number keeps two of the same name apart."""
    result = span.outcome.result
    words, colour = f"{number}. {span.name}", colours.of_action(span.name)
    if result != "success":
        words, colour = f"{words}: {result}", colours.FAILED
    return _Stretch(words, colour, span.start, span.end)


def _of_controller(span: ControllerSpan) -> _Stretch:
    words = _spoken(span.name)
    colour = colours.of_controller(words)
    if span.status != Status.CONVERGED:
        words, colour = f"{words}: {span.status}", colours.FAILED
    return _Stretch(words, colour, span.start, span.end)


def _spoken(name: str) -> str:
    """A controller's class in words; short ones, as a stretch may be."""
    plain = name.removeprefix("Harmonic").removesuffix("Controller")
    words = " ".join(re.findall("[A-Z][a-z]*", plain)).lower()
    return {"hand motion": "fingers"}.get(words, words or name)


def _log_lane(
    stream: rr.RecordingStream, path: str, stretches: Sequence[_Stretch], start: float
) -> None:
    """A lane of what ran when, with gaps."""
    told = [*changes(stretches)]
    if not told:
        return
    times, shown = zip(*told, strict=True)
    states = ["" if number is None else stretches[number].words for number in shown]
    at = column(np.array(times) - start)
    stream.send_columns(path, [at], rr.StateChange.columns(state=states))
    looks = {stretch.words: stretch.colour for stretch in stretches}
    look = rr.StateConfiguration(values=[*looks], colors=[*looks.values()])
    stream.log(path, look, static=True)


def log_words(
    stream: rr.RecordingStream, episode: Episode, explored: Sequence[bool]
) -> None:
    """Log the result of each action.

    Args:
        stream: where to.
        episode: what happened.
        explored: of each action, whether the learner chose it at random.
    """
    start = episode.states.times[0]
    lid = f"the lid lies to the {episode.presentation.orientation}"
    times, words = [0.0], [f"look: jar {episode.look.status}; {lid}"]
    levels = ["INFO"]
    for number, span in enumerate(episode.actions, start=1):
        random = bool(explored) and explored[number - 1]
        times.append(span.end - start)
        words.append(f"{number}. {_told(span, random)}")
        levels.append("INFO" if span.outcome.result == "success" else "WARN")
    times.append(episode.states.times[-1] - start)
    words.append("inserted" if episode.inserted else "not inserted")
    levels.append("INFO" if episode.inserted else "ERROR")
    entries = rr.TextLog.columns(text=words, level=levels)
    stream.send_columns(LOG, [column(times)], entries)


def _told(span: ActionSpan, random: bool) -> str:
    """One action in words; why, if it failed."""
    outcome = span.outcome
    chosen = " (a random choice)" if random else ""
    words = f"{span.name}{chosen}: {outcome.result}, {outcome.sim_seconds:.1f} s"
    reasons = [c.reason for c in span.controllers if c.status != Status.CONVERGED]
    return f"{words} ({'; '.join(reasons)})" if reasons else words
