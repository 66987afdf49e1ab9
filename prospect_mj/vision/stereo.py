"""Where a horizontal solid of revolution lies, from its outlines in both eyes.

The outlines give the axis: a line that each eye sees on the mid-line of its outline.
They also give the radius along it. What they leave open is the distance, and the
surface's picture decides that: for the right distance, every pixel of the left image,
laid on the solid and seen with the right eye, finds its own grey level there.
Nothing about the object is known beforehand but that it is long, round and horizontal.
"""

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from prospect_mj.sim.pinhole import Pinhole
from prospect_mj.vision.silhouette import Silhouette

Grey = NDArray[np.float32]


@dataclass(frozen=True)
class StereoSettings:
    """The search for the distance."""

    nearest: float = 0.70
    """From the left eye along the mid-point's ray [m]."""
    farthest: float = 1.00
    """[m]"""
    steps: tuple[float, ...] = (0.010, 0.003)
    """Between the distances tried, coarse first [m]."""
    window: int = 3
    """Distances to each side of the best that the next finer search covers."""
    stride: int = 3
    """Every how manieth pixel is compared."""


@dataclass(frozen=True, eq=False)
class AxisEstimate:
    """The object's axis, and how well both eyes agree about it."""

    position: NDArray[np.float64]
    """Middle of the axis (3,) [m]."""
    axis: NDArray[np.float64]
    """(3,): horizontal unit vector with y > 0."""
    length: float
    """Between the ends [m]."""
    radii: tuple[float, float]
    """Mean radius [m] of the fifth at the end with less y and at that with more."""
    correlation: float
    """Of the grey levels of both eyes at the best distance; 1 is perfect."""
    disagreement: float
    """Angle between the axes that either eye alone would tell [rad]."""


@dataclass(frozen=True, eq=False)
class View:
    """One eye's share of the look."""

    eye: Pinhole
    silhouette: Silhouette
    grey: Grey
    """Smoothed image (rows, columns) [grey levels]."""


def locate(left: View, right: View, settings: StereoSettings) -> AxisEstimate:
    """Estimate the axis of the object that both views show."""
    match = _Match(left, right, settings)
    distances = np.arange(settings.nearest, settings.farthest, settings.coarse)
    distances = match.around_best(distances, settings.coarse, settings.fine)
    distance, correlation = match.peak(distances)
    centre = match.centre(distance)
    directions = [view.direction_at(centre[2]) for view in (left, right)]
    axis = _unit(np.sum(directions, axis=0))
    reaches = np.array([view.reach(centre, axis) for view in (left, right)])
    low, high = reaches.mean(axis=0)
    return AxisEstimate(
        position=centre + 0.5 * (low + high) * axis,
        axis=axis,
        length=float(high - low),
        radii=left.end_radii(centre, axis),
        correlation=correlation,
        disagreement=float(np.arccos(np.clip(np.dot(*directions), -1, 1))),
    )


class _Match:
    """How well the right image shows what the left one does, for a given distance."""

    def __init__(self, left: View, right: View, settings: StereoSettings) -> None:
        self._left, self._right = left, right
        self._pixels = left.silhouette.pixels[:: settings.stride]
        self._rays = left.eye.rays(self._pixels)
        self._half_widths = left.silhouette.half_width_at(self._pixels)
        self._ray = left.eye.rays(left.silhouette.ends.mean(axis=0)[None])[0]
        columns, rows = self._pixels.astype(int).T
        self._seen = left.grey[rows, columns]

    def centre(self, distance: float) -> NDArray[np.float64]:
        """Point (3,) [m] of the axis behind the middle of the left outline."""
        return self._left.eye.position + distance * self._ray

    def correlation(self, distance: float) -> float:
        """Of the grey levels in both eyes, in [-1, 1]."""
        centre = self.centre(distance)
        directions = [v.direction_at(centre[2]) for v in (self._left, self._right)]
        axis = _unit(np.sum(directions, axis=0))
        points, facing = self._left.surface(
            centre, axis, self._rays, self._half_widths
        )
        there = self._right.eye.project(points[facing]).astype(np.float32)
        found = cv2.remap(self._right.grey, there[None], None, cv2.INTER_LINEAR)[0]
        return float(np.corrcoef(found, self._seen[facing])[0, 1])
