"""The outline of a long object in one image: its mid-line, ends and width."""

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from prospect_mj.vision.segmentation import Region

# Share of the length at each end that the mid-line ignores: there the outline is cap.
_CAP = 0.08


@dataclass(frozen=True, eq=False)
class Silhouette:
    """Shape of a mask, in pixels (column, row) of the whole image."""

    region: Region
    """The searched part of the image that the mask covers."""
    mask: NDArray[np.uint8]
    """(rows, columns) of the region, 1 on the object."""
    area: int
    """[pixels]"""
    ends: NDArray[np.float64]
    """(2, 2): where the mid-line leaves the object, left end first."""
    widths: NDArray[np.float64]
    """(2,) [pixels]: across the mid-line, in the left and in the right half."""
    straightness: float
    """Root mean square distance of the middles from the mid-line [pixels]."""

    @property
    def middle(self) -> NDArray[np.float64]:
        """Half-way between the ends, (2,)."""
        return self.ends.mean(axis=0)

    @property
    def length(self) -> float:
        """Between the ends [pixels]."""
        return float(np.linalg.norm(self.ends[1] - self.ends[0]))

    @property
    def touches_border(self) -> bool:
        """Whether the searched region may have cut the object off."""
        edges = (self.mask[0], self.mask[-1], self.mask[:, 0], self.mask[:, -1])
        return any(edge.any() for edge in edges)

    @property
    def box(self) -> Region:
        """Bounding box in the whole image."""
        column, row, width, height = cv2.boundingRect(self.mask)
        return Region(self.region.column + column, self.region.row + row, width, height)


def silhouette_of(mask: NDArray[np.uint8], region: Region) -> Silhouette:
    """Measure a mask that is not empty.

    Args:
        mask: (rows, columns) of `region`, 1 on the object.
        region: where the mask lies in the image.
    """
    rows, columns = np.nonzero(mask)
    points = np.column_stack([columns, rows]).astype(np.float64)
    origin = points.mean(axis=0)
    direction = _principal_direction(points - origin)
    along, middle, width = _slices(mask, origin, direction)
    slope, height = np.polyfit(along, middle, 1, w=np.sqrt(width))
    ...
