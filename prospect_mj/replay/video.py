"""An episode as a video, rendered from its states at real time."""

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import cv2
import mujoco
import numpy as np

from prospect_mj.checks import check_integer
from prospect_mj.episodes.episode import Episode
from prospect_mj.errors import InvalidValue
from prospect_mj.replay.playback import model_of
from prospect_mj.sim import overview
from prospect_mj.sim.camera import Image
from prospect_mj.sim.offscreen import OffscreenRenderer
from prospect_mj.storage import temporary

_STATE = mujoco.mjtState.mjSTATE_INTEGRATION
_MARGIN, _BASE = 16, 14
_INK, _HALO = (255, 255, 255), (40, 40, 40)


@dataclass(frozen=True)
class VideoSettings:
    """What a video looks like."""

    width: int = 854
    """[pixels]"""
    height: int = 480
    """[pixels]"""
    rate: int = 25
    """Pictures per second of simulated time [1/s]."""
    captions: bool = True
    """Whether the action that runs is written into the picture."""

    def __post_init__(self) -> None:
        """Refuse what no codec takes."""
        for name in ("width", "height"):
            check_integer(name, getattr(self, name), 64, 1920)
            if getattr(self, name) % 2:
                raise InvalidValue(name, getattr(self, name), "an even number")
        check_integer("rate", self.rate, 1, 100)


def film(episode: Episode, path: Path, settings: VideoSettings | None = None) -> None:
    """Write an episode as an MP4 file.

    Args:
        episode: what happened.
        path: the file; it is there as a whole or not at all.
        settings: what it looks like.

    Raises:
        EpisodeError: if the episode can't be played back.
        InvalidValue: if the file can't be written.
    """
    settings = VideoSettings() if settings is None else settings
    unfinished = temporary(path).with_suffix(".mp4")
    try:
        with _writer(unfinished, settings) as writer:
            for picture in pictures(episode, settings):
                writer.write(cv2.cvtColor(picture, cv2.COLOR_RGB2BGR))
        unfinished.replace(path)
    finally:
        unfinished.unlink(missing_ok=True)


def pictures(episode: Episode, settings: VideoSettings) -> Iterator[Image]:
    """Its pictures (height, width, 3), RGB, in order."""
    model, size = model_of(episode), (settings.height, settings.width)
    overview.light_for_people(model, size)
    data = mujoco.MjData(model)
    camera = overview.camera()
    times = episode.states.times
    wanted = np.arange(times[0], times[-1], 1 / settings.rate)
    with OffscreenRenderer(model, *size) as renderer:
        for now in wanted:
            row = episode.states.rows[np.searchsorted(times, now + 1e-9) - 1]
            mujoco.mj_setState(model, data, row, _STATE)
            mujoco.mj_forward(model, data)
            renderer.update_scene(data, camera)
            picture = renderer.render()
            yield _captioned(picture, episode, now) if settings.captions else picture


def _captioned(picture: Image, episode: Episode, now: float) -> Image:
    """With the action that runs, and with its result once it is there."""
    lines = [f"lid {episode.presentation.orientation}"]
    for number, span in enumerate(episode.actions, start=1):
        if span.start <= now:
            done = f": {span.outcome.result}" if span.end <= now else ""
            lines.append(f"{number}. {span.outcome.action.label}{done}")
    picture = picture.copy()
    for number, line in enumerate(lines):
        place = _MARGIN, _MARGIN + _BASE + int(1.6 * _BASE * number)
        for colour, thickness in ((_HALO, 3), (_INK, 1)):
            cv2.putText(
                picture,
                line,
                place,
                cv2.FONT_HERSHEY_SIMPLEX,
                0.5,
                colour,
                thickness,
                cv2.LINE_AA,
            )
    return picture


@contextmanager
def _writer(path: Path, settings: VideoSettings) -> Iterator[cv2.VideoWriter]:
    codec = cv2.VideoWriter.fourcc(*"mp4v")
    size = settings.width, settings.height
    writer = cv2.VideoWriter(str(path), codec, float(settings.rate), size)
    try:
        if not writer.isOpened():
            raise InvalidValue("video", str(path), "a file that can be written")
        yield writer
    finally:
        writer.release()
