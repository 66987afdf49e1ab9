"""One eye's share of a look: outline and grey levels, and what they say in space."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from prospect_mj.sim.pinhole import Pinhole
from prospect_mj.vision.silhouette import Silhouette


@dataclass(frozen=True, eq=False)
class View:
    """An object's outline in the image of an eye whose place is known."""

    eye: Pinhole
    silhouette: Silhouette
    grey: NDArray[np.float32]
    """Smoothed image (rows, columns) [grey levels]."""

    def direction_at(self, height: float) -> NDArray[np.float64]:
        """Axis (3,) if it is horizontal at this height [m]; y > 0."""
        rays = self.eye.rays(self.silhouette.ends)
        falls = (height - self.eye.position[2]) / rays[:, 2]
        points = rays * falls[:, None]
        axis = points[0] - points[1]
        return axis / np.linalg.norm(axis) * np.sign(axis[1])

    def reach(
        self, centre: NDArray[np.float64], axis: NDArray[np.float64]
    ) -> NDArray[np.float64]:
        """Where along the axis the object ends, (2,) from the centre, low first [m].

        The eye sees the near side of the ends, one radius in front of the axis.
        """
        ends = self.silhouette.ends
        points, _ = self._lifted(ends, self.eye.rays(ends), centre, axis)
        return np.sort((points - centre) @ axis)
