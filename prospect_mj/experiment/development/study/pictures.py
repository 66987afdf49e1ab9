"""Pictures of the jar, presented again, with the histogram's bin of every pixel."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from prospect_mj.recording.grower import presentation_rng, task_settings
from prospect_mj.recording.recording import Recording
from prospect_mj.sim.camera import Image
from prospect_mj.task.pick_place import PickPlaceTask
from prospect_mj.task.presentation import ORIENTATIONS, Orientation

NO_JAR = -1
_MARGIN = 8
"""Round the jar [pixels]."""
_LUMA = np.array([299, 587, 114])
"""Weights of red, green and blue in brightness, as in `vision.histogram`."""


class JarPicture(NamedTuple):
    """The jar as the left eye saw it."""

    orientation: Orientation
    image: Image
    """(rows, columns, 3) RGB [grey levels]."""
    level: NDArray[np.int64]
    """(rows, columns): bin of the histogram that a pixel counts in, or NO_JAR."""


def jar_pictures(recording: Recording, number: int = 0) -> list[JarPicture]:
    """Present the jar once more in both orientations, and look at it.

    Args:
        recording: one of whose presentations it is.
        number: of the presentation, for each orientation.

    Raises:
        RenderingUnavailable: if there is no OpenGL.
    """
    config = recording.key.config
    with PickPlaceTask(task_settings(config)) as task:
        return [_seen(task, recording, side, number) for side in ORIENTATIONS]


def _seen(
    task: PickPlaceTask, recording: Recording, side: Orientation, number: int
) -> JarPicture:
    look = task.reset(side, presentation_rng(recording.key.config, side, number))
    whole, image = look.masks[0] == 1, task.images.left
    level = np.full(whole.shape, NO_JAR)
    level[whole] = bins(image[whole], look.histogram)
    rows, columns = (np.flatnonzero(whole.any(axis=axis)) for axis in (1, 0))
    cut = tuple(
        slice(max(at[0] - _MARGIN, 0), at[-1] + _MARGIN + 1) for at in (rows, columns)
    )
    return JarPicture(side, image[cut].copy(), level[cut])


def bins(pixels: Image, histogram: NDArray[np.int64]) -> NDArray[np.int64]:
    """The bin of each pixel, from the histogram of all of them.

    A bin is never darker than the one before, so that the darkest pixels are those of
    the first bin, as many as it counts.

    Args:
        pixels: (n, 3) RGB [grey levels].
        histogram: (100,) [pixels], whose sum is n.

    Returns:
        (n,), from 0.
    """
    order = np.argsort(pixels.astype(np.int64) @ _LUMA, kind="stable")
    found = np.empty(len(pixels), np.int64)
    found[order] = np.repeat(np.arange(len(histogram)), histogram)
    return found
