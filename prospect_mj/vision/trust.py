"""Whether a look may be trusted: reasons to doubt what both eyes seem to show."""

from dataclasses import dataclass

import numpy as np

from prospect_mj.vision.silhouette import Silhouette
from prospect_mj.vision.stereo import AxisEstimate


@dataclass(frozen=True)
class TrustSettings:
    """What a look must show for its pose to be used."""

    min_area: int = 400
    """Less than this in both eyes is nothing at all [pixels]."""
    max_area_ratio: float = 1.15
    """Of the two outlines; beyond it something hides the object from one eye."""
    length: tuple[float, float] = (0.163, 0.180)
    """Of an object that the hands and the well are made for [m]."""
    thin_end: tuple[float, float] = (0.033, 0.040)
    """Radius of the end that goes into the well [m]."""
    thick_end: tuple[float, float] = (0.0415, 0.050)
    """Radius of the end that does not [m]; which of both it is doesn't matter here."""
    min_correlation: float = 0.99
    """Of both eyes' grey levels on the object's surface."""
    max_disagreement: float = 0.03
    """Between the axes that either eye alone would tell [rad]."""


def doubt_outlines(left: Silhouette, right: Silhouette, trust: TrustSettings) -> str:
    """Say what is wrong with a pair of outlines, or return an empty string."""
    areas = sorted((left.area, right.area))
    if left.touches_border or right.touches_border:
        return "the object reaches out of the searched region"
    if areas[1] > trust.max_area_ratio * areas[0]:
        return f"outlines of {left.area} and {right.area} pixels are not one object's"
    return ""


def doubt_estimate(estimate: AxisEstimate, trust: TrustSettings) -> str:
    """Say why a pose can't be trusted, or return an empty string."""
    if not _within(estimate.length, trust.length):
        return f"a length of {1e3 * estimate.length:.0f} mm is not an object's"
    thin, thick = np.sort(estimate.radii)
    if not (_within(thin, trust.thin_end) and _within(thick, trust.thick_end)):
        return f"radii of {1e3 * thin:.0f} and {1e3 * thick:.0f} mm are not an object's"
    if estimate.correlation < trust.min_correlation:
        return f"the eyes' pictures differ (correlation {estimate.correlation:.2f})"
    if estimate.disagreement > trust.max_disagreement:
        degrees = np.degrees(estimate.disagreement)
        return f"the eyes disagree by {degrees:.1f} degrees about the axis"
    return ""


def _within(value: float, limits: tuple[float, float]) -> bool:
    return limits[0] <= value <= limits[1]
