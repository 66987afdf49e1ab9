"""The picture of docs/worlds.md: every world as the left eye sees it, and the post."""

from collections.abc import Callable

import cv2
import numpy as np

from prospect_mj.experiment.pictures.post_pictures import post_pictures
from prospect_mj.recording.config import RecordingConfig
from prospect_mj.recording.grower import task_settings
from prospect_mj.recording.worlds import WORLDS
from prospect_mj.sim.camera import Image
from prospect_mj.task.pick_place import PickPlaceTask
from prospect_mj.task.presentation import ORIENTATIONS

STEPS = len(WORLDS) + 1
"""One for each world, one for the post."""
SEED = 3
"""Of the presentation, the same in every world."""
CROP = (78, 160)
"""Rows and columns round the middle of the eye's picture [pixels]."""
SCALE = 2
"""By which each pixel of the eye is enlarged."""
ACROSS = 2
"""Worlds in a row."""
CAPTION, GAP = 34, 10
"""Height of a caption, and what separates worlds [pixels]."""
_PAPER, _INK = 255, (25, 30, 40)


def worlds_picture(tick: Callable[[], object]) -> bytes:
    """Every world with the lid to either side, and what the post does, as PNG.

    Args:
        tick: called after each of the `STEPS`.
    """
    cells = []
    for world in WORLDS:
        cells.append(captioned(_as_seen(world), world))
        tick()
    rows = [
        beside(cells[start : start + ACROSS]) for start in range(0, len(cells), ACROSS)
    ]
    width = rows[0].shape[1]
    frames = post_pictures((width - 3 * GAP) // 4)
    rows.append(beside([captioned(frame, words) for words, frame in frames.items()]))
    tick()
    whole = np.vstack([_widened(row, width) for row in rows])
    smallest = (cv2.IMWRITE_PNG_COMPRESSION, 9)
    colours = cv2.cvtColor(whole, cv2.COLOR_RGB2BGR)
    _, content = cv2.imencode(".png", colours, smallest)
    return content.tobytes()


def _as_seen(world: str) -> Image:
    """What the left eye sees of the jar, lid to the left beside lid to the right."""
    seen = []
    with PickPlaceTask(task_settings(RecordingConfig(world=world))) as task:
        for orientation in ORIENTATIONS:
            task.reset(orientation, np.random.default_rng(SEED))
            seen.append(_middle(task.images.left))
    return np.hstack(seen)


def _middle(picture: Image) -> Image:
    """The middle of a picture, enlarged so that its pixels stay what they are."""
    start = (np.array(picture.shape[:2]) - CROP) // 2
    row, column = start
    part = picture[row : row + CROP[0], column : column + CROP[1]]
    return part.repeat(SCALE, axis=0).repeat(SCALE, axis=1)


def captioned(picture: Image, words: str) -> Image:
    """A picture with words above it."""
    strip = np.full((CAPTION, picture.shape[1], 3), _PAPER, np.uint8)
    place, font = (2, CAPTION - 10), cv2.FONT_HERSHEY_DUPLEX
    cv2.putText(strip, words, place, font, 0.62, _INK, 1, cv2.LINE_AA)
    return np.vstack([strip, picture])


def beside(pictures: list[Image]) -> Image:
    """Pictures of one height side by side, with gaps between them."""
    gap = np.full((pictures[0].shape[0], GAP, 3), _PAPER, np.uint8)
    parts = [part for picture in pictures for part in (picture, gap)]
    return np.hstack(parts[:-1])


def _widened(picture: Image, width: int) -> Image:
    missing = width - picture.shape[1]
    return np.pad(picture, ((0, 0), (0, missing), (0, 0)), constant_values=_PAPER)
