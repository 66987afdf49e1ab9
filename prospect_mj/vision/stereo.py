"""Where a horizontal solid of revolution lies, from its outlines in both eyes.

The outlines tell the axis, as each eye sees it on the mid-line of its outline, and the
radius along it. What they leave open is the distance. The surface's picture decides
that: at the right distance every pixel of the left image, laid on the solid and seen
with the right eye, meets its own grey level there. Nothing about the object is known
beforehand but that it is long, round and horizontal.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import map_coordinates
from scipy.optimize import minimize_scalar

from prospect_mj.vision.view import Vectors, View


@dataclass(frozen=True)
class StereoSettings:
    """The search for the distance."""

    nearest: float = 0.74
    """From the left eye to the axis [m]."""
    farthest: float = 0.96
    """[m]"""
    step: float = 0.02
    """Between the distances tried first [m]; the peak is some 5 cm wide."""
    tolerance: float = 1e-6
    """Of the distance in the end [m]; a coarse one is at the mercy of rounding."""
    stride: int = 7
    """Every how manieth pixel is compared."""
    clearance: int = 10
    """Pixels this near to an end or a step in width are left out: the eye may look at
    a cap or a shoulder there, and a ring of the surface leaves its slice [pixels]."""
    step_width: float = 3.0
    """Difference in half width that counts as a step [pixels]."""
    min_compared: int = 50
    """Fewer pixels than this agree by chance; they count as uncorrelated."""
    grazing: float = 0.8
    """Sine of the angle from which on pixels of the flanks are left out."""


@dataclass(frozen=True, eq=False)
class AxisEstimate:
    """The object's axis, and how well both eyes agree about it."""

    position: Vectors
    """Middle of the axis (3,) [m]."""
    axis: Vectors
    """(3,): horizontal unit vector with y > 0."""
    length: float
    """Between the ends [m]."""
    radii: NDArray[np.float64]
    """(2,) [m]: near the left and the right end in the image."""
    correlation: float
    """Of the grey levels of both eyes at the best distance; 1 is perfect."""
    disagreement: float
    """Angle between the axes that either eye alone would tell [rad]."""


def locate(left: View, right: View, settings: StereoSettings) -> AxisEstimate:
    """Estimate the axis of the object that both views show."""
    match = _Match(left, right, settings)
    distance = match.best_distance()
    centre, axis = match.assumed(distance)
    low, high = np.mean([view.reach(centre, axis) for view in (left, right)], axis=0)
    alone = [view.direction_at(centre[2]) for view in (left, right)]
    return AxisEstimate(
        position=centre + 0.5 * (low + high) * axis,
        axis=axis,
        length=float(high - low),
        radii=left.end_radii(centre, axis),
        correlation=match.correlation(distance),
        disagreement=float(np.arccos(np.clip(alone[0] @ alone[1], -1.0, 1.0))),
    )


class _Match:
    """How well the right eye sees what the left eye does, if it is at a distance."""

    def __init__(self, left: View, right: View, settings: StereoSettings) -> None:
        self._left, self._right, self._settings = left, right, settings
        self._pixels = left.silhouette.even_pixels(
            settings.clearance, settings.step_width
        )[:: settings.stride]
        columns, rows = self._pixels.astype(int).T
        self._seen = left.grey[rows, columns]
        self._sight = left.eye.rays(left.silhouette.ends.mean(axis=0)[None])[0]

    def best_distance(self) -> float:
        """Distance [m] of the highest correlation: a scan, then Brent's method."""
        s = self._settings
        tried = np.arange(s.nearest, s.farthest, s.step)
        start = tried[np.argmax([self.correlation(distance) for distance in tried])]
        found = minimize_scalar(
            lambda distance: -self.correlation(distance),
            bounds=(start - s.step, start + s.step),
            method="bounded",
            options={"xatol": s.tolerance},
        )
        return float(found.x)

    def assumed(self, distance: float) -> tuple[Vectors, Vectors]:
        """Point (3,) [m] and direction (3,) of the axis at this distance."""
        centre = self._left.eye.position + distance * self._sight
        both = [view.direction_at(centre[2]) for view in (self._left, self._right)]
        axis = np.sum(both, axis=0)
        return centre, axis / np.linalg.norm(axis)

    def correlation(self, distance: float) -> float:
        """Of the grey levels that both eyes see of the same points, in [-1, 1]."""
        surface = self._left.surface(self._pixels, *self.assumed(distance))
        shared = surface.turn < self._settings.grazing
        if np.count_nonzero(shared) < self._settings.min_compared:
            return 0.0
        columns, rows = self._right.eye.project(surface.points[shared]).T
        found = map_coordinates(
            self._right.grey, [rows, columns], order=1, mode="nearest"
        )
        return _correlation(found, self._seen[shared])


def _correlation(a: NDArray[np.float64], b: NDArray[np.float64]) -> float:
    """Pearson's coefficient; 0 where one of them does not vary."""
    a, b = a - a.mean(), b - b.mean()
    spread = np.sqrt((a @ a) * (b @ b))
    return float(a @ b / spread) if spread > 0 else 0.0
