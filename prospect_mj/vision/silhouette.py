"""The outline of a long object in one image: mid-line, ends, and width along it."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import maximum_filter1d, minimum_filter1d

from prospect_mj.vision.segmentation import Region

# Share of the length at each end where the outline shows the caps, not the sides.
_CAP = 0.08
# Half width of the strip round the mid-line whose extremes are its ends [pixels].
_STRIP = 3.0
# The direction of an outline settles after one fit; the second one is for safety.
_FITS = 2


@dataclass(frozen=True, eq=False)
class Silhouette:
    """Shape of a mask in pixels (column, row) of the whole image."""

    region: Region
    """The searched part of the image."""
    mask: NDArray[np.uint8]
    """(rows, columns) of the region, 1 on the object."""
    pixels: NDArray[np.float64]
    """(n, 2): the object's pixels, row by row."""
    origin: NDArray[np.float64]
    """(2,): a point of the mid-line."""
    direction: NDArray[np.float64]
    """(2,): unit vector along the mid-line, to the right in the image."""
    start: float
    """Where the first slice begins, from the origin along the direction [pixels]."""
    half_widths: NDArray[np.float64]
    """(slices,) [pixels]: half the width of each slice, one pixel long."""
    ends: NDArray[np.float64]
    """(2, 2): where the mid-line leaves the object, left one first."""

    @property
    def area(self) -> int:
        """Pixels of the object."""
        return len(self.pixels)

    @property
    def length(self) -> float:
        """Between the ends [pixels]."""
        return float(np.linalg.norm(self.ends[1] - self.ends[0]))

    @property
    def touches_border(self) -> bool:
        """Whether the searched region may have cut the object off."""
        edges = (self.mask[0], self.mask[-1], self.mask[:, 0], self.mask[:, -1])
        return any(bool(edge.any()) for edge in edges)

    def even_pixels(self, clearance: int, tolerance: float) -> NDArray[np.float64]:
        """The object's pixels (m, 2) that are far from ends and from steps in width.

        Args:
            clearance: how far [pixels].
            tolerance: the difference in half width that makes a step [pixels].
        """
        window, ends = 2 * clearance + 1, {"mode": "constant", "cval": 0.0}
        wide = maximum_filter1d(self.half_widths, window, **ends)
        thin = minimum_filter1d(self.half_widths, window, **ends)
        return self.pixels[(wide - thin < tolerance)[self._slices_of(self.pixels)]]

    def half_width_at(self, pixels: NDArray[np.float64]) -> NDArray[np.float64]:
        """Half the width of the slices in which the pixels (n, 2) lie, (n,)."""
        return self.half_widths[self._slices_of(pixels)]

    def _slices_of(self, pixels: NDArray[np.float64]) -> NDArray[np.intp]:
        along = (pixels - self.origin) @ self.direction
        slices = np.floor(along - self.start).astype(np.intp)
        return np.clip(slices, 0, len(self.half_widths) - 1)


def silhouette_of(mask: NDArray[np.uint8], region: Region) -> Silhouette:
    """Measure the outline of a mask that is not empty.

    Args:
        mask: (rows, columns) of `region`, 1 on the object.
        region: where the mask lies in the image.
    """
    rows, columns = np.nonzero(mask)
    pixels = np.column_stack([columns + region.column, rows + region.row]).astype(float)
    origin = pixels.mean(axis=0)
    direction = _principal_direction(pixels - origin)
    for _ in range(_FITS):
        origin, direction = _mid_line(pixels, origin, direction)
    start, low, high = _slices(pixels, origin, direction)
    along, across = _along_across(pixels, origin, direction)
    axial = along[np.abs(across) < _STRIP]
    return Silhouette(
        region=region,
        mask=mask,
        pixels=pixels,
        origin=origin,
        direction=direction,
        start=start,
        half_widths=(high - low + 1) / 2,
        ends=origin + np.outer([axial.min(), axial.max()], direction),
    )


def _principal_direction(offsets: NDArray[np.float64]) -> NDArray[np.float64]:
    _, vectors = np.linalg.eigh(offsets.T @ offsets)
    longest = vectors[:, 1]
    return longest if longest[0] >= 0 else -longest


def _along_across(
    pixels: NDArray[np.float64],
    origin: NDArray[np.float64],
    direction: NDArray[np.float64],
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    offsets = pixels - origin
    return offsets @ direction, offsets @ np.array([-direction[1], direction[0]])


def _slices(
    pixels: NDArray[np.float64],
    origin: NDArray[np.float64],
    direction: NDArray[np.float64],
) -> tuple[float, NDArray[np.float64], NDArray[np.float64]]:
    """Start of the first slice, and lowest and highest offset in each of them."""
    along, across = _along_across(pixels, origin, direction)
    start = float(along.min())
    slices = np.floor(along - start).astype(int)
    # A slice without a pixel's centre has width 0; the mask has no wider holes.
    low, high = np.zeros((2, slices.max() + 1))
    np.minimum.at(low, slices, across)
    np.maximum.at(high, slices, across)
    return start, low, high


def _mid_line(
    pixels: NDArray[np.float64],
    origin: NDArray[np.float64],
    direction: NDArray[np.float64],
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Least-squares line through the middles of the slices, without the caps."""
    start, low, high = _slices(pixels, origin, direction)
    skipped = int(_CAP * len(low))
    inner = slice(skipped, len(low) - skipped)
    along = start + np.arange(len(low))[inner] + 0.5
    slope, height = np.polyfit(along, (low + high)[inner] / 2, 1)
    normal = np.array([-direction[1], direction[0]])
    turned = direction + slope * normal
    return origin + height * normal, turned / np.linalg.norm(turned)
