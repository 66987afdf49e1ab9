"""Which pixels belong to the object: those that the table cannot explain.

The border of the searched region shows the table. A pixel is the object's if it is
brighter than the table gets, or if its colour leaves the table's hue: light and shadow
move the colour of a matt surface along one line through black, so what counts is the
distance from that line. The first test finds a jar on a dark table, the second one on a
light table.
"""

from dataclasses import dataclass
from typing import NamedTuple

import cv2
import numpy as np
from numpy.typing import NDArray

from prospect_mj.sim.camera import Image


class Region(NamedTuple):
    """A rectangle of an image [pixels]."""

    column: int
    row: int
    width: int
    height: int

    def crop(self, image: NDArray) -> NDArray:
        """View of that part of an image (rows, columns, ...)."""
        rows = slice(self.row, self.row + self.height)
        return image[rows, self.column : self.column + self.width]


@dataclass(frozen=True)
class SegmentationSettings:
    """How the object is told from the table."""

    border: int = 6
    """Width of the frame of the region that shows the table [pixels]."""
    smoothing: int = 5
    """Side of the Gaussian filter against sensor noise [pixels]."""
    percentile: float = 98.0
    """Of brightness and hue distance in the border that is still the table [%]."""
    margin: float = 4.0
    """By which an object's pixel exceeds that percentile [grey levels]."""
    opening: int = 3
    """Bridges narrower than this are cut [pixels]."""
    closing: int = 9
    """Gaps narrower than this are filled [pixels]."""


def segment(patch: Image, settings: SegmentationSettings) -> NDArray[np.uint8]:
    """Find the largest thing that is not table.

    Args:
        patch: (rows, columns, 3) RGB [grey levels], with table along its border.
        settings: thresholds and filters.

    Returns:
        (rows, columns) 1 on the object, 0 elsewhere; all 0 if there is none.
    """
    smooth = cv2.GaussianBlur(patch, (settings.smoothing,) * 2, 0)
    channels = np.array(cv2.split(smooth), np.float64)
    frame = _frame(patch.shape[:2], settings.border)
    brightness = channels.max(axis=0)
    hue = _distance_from_hue(channels, channels[:, frame].sum(axis=1))
    excess = np.maximum(
        brightness - np.percentile(brightness[frame], settings.percentile),
        hue - np.percentile(hue[frame], settings.percentile),
    )
    return _largest(_cleaned((excess > settings.margin).astype(np.uint8), settings))


def _frame(shape: tuple[int, int], width: int) -> NDArray[np.bool_]:
    frame = np.ones(shape, bool)
    frame[width:-width, width:-width] = False
    return frame


def _distance_from_hue(
    channels: NDArray[np.float64], hue: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Distance (rows, columns) of colours from the line of all shades of `hue` (3,)."""
    unit = hue / max(float(np.linalg.norm(hue)), 1e-6)
    along = np.tensordot(unit, channels, axes=1)
    return np.sqrt(np.maximum((channels**2).sum(axis=0) - along**2, 0.0))


def _cleaned(
    mask: NDArray[np.uint8], settings: SegmentationSettings
) -> NDArray[np.uint8]:
    for operation, side in (
        (cv2.MORPH_OPEN, settings.opening),
        (cv2.MORPH_CLOSE, settings.closing),
    ):
        kernel = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (side, side))
        mask = cv2.morphologyEx(mask, operation, kernel)
    return mask


def _largest(mask: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Keep the largest connected component."""
    count, labels, stats, _ = cv2.connectedComponentsWithStats(mask)
    if count == 1:
        return mask
    largest = 1 + int(np.argmax(stats[1:, cv2.CC_STAT_AREA]))
    return (labels == largest).astype(np.uint8)
