"""An episode as a video, rendered from its states at real time."""

from collections.abc import Generator, Iterator, Sequence
from contextlib import closing, contextmanager
from dataclasses import dataclass
from pathlib import Path

import cv2
import imageio_ffmpeg
import mujoco
import numpy as np
from numpy.typing import NDArray
from tqdm import tqdm

from prospect_mj.checks import check_integer
from prospect_mj.episodes.episode import Episode
from prospect_mj.episodes.states import rendered
from prospect_mj.errors import InvalidValue, MissingEncoder
from prospect_mj.replay import eye
from prospect_mj.replay.playback import model_of
from prospect_mj.sim import overview
from prospect_mj.sim.camera import Image
from prospect_mj.sim.offscreen import OffscreenRenderer
from prospect_mj.storage import temporary

_FONT, _SIZE, _INK = cv2.FONT_HERSHEY_SIMPLEX, 0.5, (255, 255, 255)
_LINE, _MARGIN = 22, 12
"""[pixels]"""
_SHADE = 0.4
"""Brightness of the ground on which words are written, of that of the picture."""


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
    """Write an episode as an MP4 file in H.264, which browsers play.

    A bar tells how far it is, on a terminal.

    Args:
        episode: what happened.
        path: the file; it is there as a whole or not at all.
        settings: what it looks like.

    Raises:
        EpisodeError: if the episode can't be played back.
        ChildProcessError: if ffmpeg fails, as it does on a full disk.
        OSError: if the file can't be written for another reason.
    """
    settings = VideoSettings() if settings is None else settings
    unfinished = temporary(path).with_suffix(".mp4")
    times = moments(episode, settings.rate)
    # First, as it may refuse: ffmpeg would complain of a film without pictures.
    shown = pictures(episode, times, settings)
    bar = tqdm(total=len(times), desc="film", unit="picture", disable=None)
    try:
        with bar, closing(_writer(unfinished, settings)) as writer:
            for picture in shown:
                with _told_plainly(path):
                    writer.send(np.ascontiguousarray(picture))
                bar.update()
        with _told_plainly(path):
            _check_whole(unfinished, len(times))
        unfinished.replace(path)
    finally:
        unfinished.unlink(missing_ok=True)


def moments(episode: Episode, rate: float) -> NDArray[np.float64]:
    """When pictures are taken (n,) [s], at a rate [1/s]; the last one at the end."""
    start, end = episode.states.times[[0, -1]]
    n_pictures = 1 + int(np.ceil((end - start) * rate - 1e-9))
    return np.minimum(start + np.arange(n_pictures) / rate, end)


def pictures(
    episode: Episode, times: NDArray[np.float64], settings: VideoSettings
) -> Iterator[Image]:
    """Its pictures (height, width, 3), RGB, at some times [s] in order.

    Raises:
        EpisodeError: if the episode can't be played back.
    """
    return _rendered(model_of(episode), episode, times, settings)


def _rendered(
    model: mujoco.MjModel,
    episode: Episode,
    times: NDArray[np.float64],
    settings: VideoSettings,
) -> Iterator[Image]:
    size = settings.height, settings.width
    overview.light_for_people(model, size)
    # Shadows speckle the arms, and take two thirds of the time.
    model.vis.quality.shadowsize = 0
    states = episode.states
    rows = states.rows[np.searchsorted(states.times, times + 1e-9) - 1]
    with OffscreenRenderer(model, *size) as renderer:
        shown = rendered(renderer, rows, eye.camera())
        for now, picture in zip(times, shown, strict=True):
            yield _captioned(picture, episode, now) if settings.captions else picture


def _captioned(picture: Image, episode: Episode, now: float) -> Image:
    """With the action that runs, and with its result once it is there."""
    lines = [f"lid {episode.presentation.orientation}"]
    for number, span in enumerate(episode.actions, start=1):
        if span.start <= now:
            done = f": {span.outcome.result}" if span.end <= now else ""
            lines.append(f"{number}. {span.name}{done}")
    return _with_words(picture, lines)


def _with_words(picture: Image, lines: Sequence[str]) -> Image:
    """The picture with lines of text on a dark ground in its upper left corner."""
    picture = picture.copy()
    widths = [cv2.getTextSize(line, _FONT, _SIZE, 1)[0][0] for line in lines]
    ground = picture[: len(lines) * _LINE + _MARGIN, : max(widths) + 2 * _MARGIN]
    ground[:] = _SHADE * ground
    for number, line in enumerate(lines, start=1):
        place = _MARGIN, number * _LINE
        cv2.putText(picture, line, place, _FONT, _SIZE, _INK, 1, cv2.LINE_AA)
    return picture


@contextmanager
def _told_plainly(path: Path) -> Iterator[None]:
    """One line for what ffmpeg, and the library that runs it, have to say."""
    try:
        yield
    except (OSError, RuntimeError) as error:
        words = f"{path} can't be written: ffmpeg failed; the disk may be full"
        raise ChildProcessError(words) from error


def _check_whole(path: Path, n_pictures: int) -> None:
    """Notice an ffmpeg that failed at the end, which goes by in silence.

    Raises:
        RuntimeError: if it did.
    """
    found, _ = imageio_ffmpeg.count_frames_and_secs(path)
    if found != n_pictures:
        raise RuntimeError(f"{found} of {n_pictures} pictures are there")


def _writer(path: Path, settings: VideoSettings) -> Generator[None, Image, None]:
    """Takes pictures by `send`; the file is whole when it is closed.

    Raises:
        MissingEncoder: if there is no ffmpeg.
    """
    try:
        imageio_ffmpeg.get_ffmpeg_exe()
    except RuntimeError as error:
        raise MissingEncoder("no ffmpeg: pip install imageio-ffmpeg") from error
    writer = imageio_ffmpeg.write_frames(
        path,
        (settings.width, settings.height),
        fps=settings.rate,
        codec="libx264",
        # Any even size: players crop what is left of a block.
        macro_block_size=2,
        # The table of contents comes first, so that a browser plays at once.
        output_params=["-movflags", "+faststart"],
        ffmpeg_log_level="quiet",
    )
    next(writer)
    return writer
