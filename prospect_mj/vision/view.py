"""One eye's share of a look: outline and grey levels, and what they say in space.

The object is taken for a horizontal solid of revolution. Its axis is a point (`centre`)
and a direction (`axis`); all lengths follow from the outline once these are assumed.
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from prospect_mj.sim.pinhole import Pinhole
from prospect_mj.vision.silhouette import Silhouette

Vectors = NDArray[np.float64]


class Surface(NamedTuple):
    """Where pixels lie on the solid."""

    points: Vectors
    """(n, 3) [m]."""
    turn: NDArray[np.float64]
    """(n,): sine of the angle round the axis from the line of sight; 1 on the rim."""


@dataclass(frozen=True, eq=False)
class View:
    """An object's outline in the image of an eye whose place is known."""

    eye: Pinhole
    silhouette: Silhouette
    grey: NDArray[np.float64]
    """Smoothed image (rows, columns) [grey levels]."""

    def direction_at(self, height: float) -> Vectors:
        """Axis (3,) that this eye alone would tell at a height [m]; horizontal, y > 0.

        The eye and the mid-line span a plane; its trace at that height is the axis.
        """
        rays = self.eye.rays(self.silhouette.ends)
        trace = rays[1] / rays[1, 2] - rays[0] / rays[0, 2]
        return trace / np.linalg.norm(trace) * (-1.0 if trace[1] < 0 else 1.0)

    def surface(self, pixels: Vectors, centre: Vectors, axis: Vectors) -> Surface:
        """Lay pixels (n, 2) of the object on the side of the solid."""
        rays = self.eye.rays(pixels)
        towards, away = self._facing(centre, axis)
        slopes = rays @ towards
        flat = rays * (away / slopes)[:, None]
        radii = self._radii(pixels, flat)
        across = (self.eye.position + flat - centre) @ np.cross(axis, towards)
        lift = np.sqrt(np.maximum(radii**2 - across**2, 0.0))
        # Nearer to the eye by the lift, a ray is also nearer to the line of sight.
        across *= 1.0 + lift / away
        lift = np.sqrt(np.maximum(radii**2 - across**2, 0.0))
        points = self.eye.position + rays * ((away + lift) / slopes)[:, None]
        return Surface(points, np.abs(across) / radii)

    def reach(self, centre: Vectors, axis: Vectors) -> Vectors:
        """How far the object reaches from `centre` along the axis, (2,) [m], low first.

        What the eye sees of an end is the near side of its rim if the cap is turned
        away, and the far side if it looks at the cap.
        """
        pixels = self.silhouette.ends
        rays = self.eye.rays(pixels)
        towards, away = self._facing(centre, axis)
        slopes = rays @ towards
        radii = self.end_radii(centre, axis)
        near, far = (
            rays @ axis * (away + side * radii) / slopes for side in (1.0, -1.0)
        )
        # `near` and `far` start at the eye; beyond an end the eye looks at its cap.
        outward = np.where(near > near.mean(), 1.0, -1.0)
        ends = np.where(outward * near < 0, far, near)
        return np.sort(ends + (self.eye.position - centre) @ axis)

    def end_radii(self, centre: Vectors, axis: Vectors) -> NDArray[np.float64]:
        """Radius (2,) [m] near the left and the right end of the image's mid-line."""
        ends = self.silhouette.ends
        pixels = ends + 0.1 * (ends[::-1] - ends)
        rays = self.eye.rays(pixels)
        towards, away = self._facing(centre, axis)
        return self._radii(pixels, rays * (away / (rays @ towards))[:, None])

    def _facing(self, centre: Vectors, axis: Vectors) -> tuple[Vectors, float]:
        """Unit vector (3,) square to the axis towards the eye, and the centre's reach.

        The second is the coordinate of `centre` seen from the eye, hence negative.
        """
        sight = self.eye.position - centre
        square = sight - (sight @ axis) * axis
        towards = square / np.linalg.norm(square)
        return towards, float(-sight @ towards)

    def _radii(self, pixels: Vectors, offsets: Vectors) -> NDArray[np.float64]:
        """Radius (n,) [m] of the slices of pixels at these offsets from the eye."""
        depth = offsets @ self.eye.rotation[:, 2]
        return self.silhouette.half_width_at(pixels) * depth / self.eye.focal
