"""The state feature generator: image histogram and grasp predicates to 303 features.

Wheeler, Fagg & Grupen (ICDL 2002), section 3.1: the feature vector is "the Cartesian
product of the visual and haptic features, the haptic features themselves, and a
constant 1". With v the scaled histogram and h_L, h_R the two grasp predicates,

    product:  phi = (v,            v h_L, v h_R, h_L, h_R, 1)
    one_hot:  phi = (v (none held), v h_L, v h_R, h_L, h_R, 1)

are the two readings of it that have 303 elements. They span the same functions; in the
first, what is learned about the picture generalises over the haptic states.
"""

from dataclasses import dataclass
from typing import Literal, NamedTuple, get_args

import numpy as np
from numpy.typing import ArrayLike, NDArray

from prospect_mj.checks import check_choice, check_number
from prospect_mj.errors import InvalidValue

N_BINS = 100
N_FEATURES = 3 * N_BINS + 3

Holding = Literal["none", "left", "right"]
Reading = Literal["product", "one_hot"]
Normalisation = Literal["energy", "max_bin", "unit_sum"]

# Grasp predicates (h_L, h_R) per haptic state.
_PREDICATES: dict[str, tuple[float, float]] = {
    "none": (0.0, 0.0),
    "left": (1.0, 0.0),
    "right": (0.0, 1.0),
}


@dataclass(frozen=True)
class FeatureSettings:
    """How a histogram and the grasp predicates become a feature vector."""

    reading: Reading = "product"
    """Of the paper's Cartesian product: product has v itself beside v h_L and v h_R,
    one_hot has v only where no hand holds the jar."""
    normalisation: Normalisation = "energy"
    """Scale of the histogram v: |v|^2 = `energy`, largest bin = 1, or sum = 1."""
    energy: float = 2.4
    """|v|^2 under "energy" [1]. The paper does not state it; 2.4 was chosen, with the
    initial weights, by four of its numbers (docs/reproduction.md), as the learning
    speed depends on step size times |v|^2."""

    def __post_init__(self) -> None:
        """Refuse choices and numbers that make no feature vector."""
        check_choice("feature reading", self.reading, get_args(Reading))
        valid = get_args(Normalisation)
        check_choice("feature normalisation", self.normalisation, valid)
        check_number("energy", self.energy, 0, 100, above=True)


class FeatureBounds(NamedTuple):
    """The smallest box that contains every feature vector."""

    low: NDArray[np.float64]
    """(303,) [1]."""
    high: NDArray[np.float64]
    """(303,) [1]."""


class StateFeatureGenerator:
    """Turns raw bin counts and the haptic state into the learner's features."""

    def __init__(self, settings: FeatureSettings | None = None) -> None:
        """Generate features in the way that `settings` says."""
        self.settings = FeatureSettings() if settings is None else settings

    def generate(self, counts: ArrayLike, holding: Holding) -> NDArray[np.float64]:
        """Compute the feature vector of one state.

        Args:
            counts: (100,) [pixels] per intensity bin; all zero if the object was not
                seen, which gives v = 0.
            holding: the hand whose grasp predicate is on, or "none".

        Returns:
            (303,) [1], a new array.
        """
        check_choice("holding", holding, _PREDICATES)
        visual = self.scaled_histogram(counts)
        left, right = _PREDICATES[holding]
        none = 1.0 - left - right
        first = 1.0 if self.settings.reading == "product" else none
        haptic = np.array([left, right, 1.0])
        return np.concatenate([first * visual, left * visual, right * visual, haptic])

    def scaled_histogram(self, counts: ArrayLike) -> NDArray[np.float64]:
        """Scale bin counts to the settings' norm.

        Args:
            counts: (100,) [pixels].

        Returns:
            v (100,) [1]; zero where `counts` is all zero.
        """
        histogram = _checked_counts(counts)
        peak = histogram.max()
        if peak == 0:
            return histogram
        # By the peak first, so that no sum or square can overflow.
        return self._scale(histogram / peak)

    def _scale(self, relative: NDArray[np.float64]) -> NDArray[np.float64]:
        match self.settings.normalisation:
            case "energy":
                scale = np.sqrt(self.settings.energy / np.sum(relative**2))
            case "max_bin":
                scale = 1.0
            case "unit_sum":
                scale = 1.0 / np.sum(relative)
        return relative * scale

    @property
    def bounds(self) -> FeatureBounds:
        """Finite bounds of all features, for an observation space."""
        energy = self.settings.normalisation == "energy"
        # One step up: a histogram of one bin may round to just above the root.
        largest = np.nextafter(np.sqrt(self.settings.energy), np.inf) if energy else 1.0
        high = np.ones(N_FEATURES)
        high[: 3 * N_BINS] = largest
        low = np.zeros(N_FEATURES)
        return FeatureBounds(low, high)


def _checked_counts(counts: ArrayLike) -> NDArray[np.float64]:
    """Copy `counts` as floats, or say what is wrong with them."""
    histogram = np.array(counts, dtype=np.float64)
    if histogram.shape != (N_BINS,):
        raise InvalidValue("histogram shape", histogram.shape, f"({N_BINS},)")
    bad = ~np.isfinite(histogram) | (histogram < 0)
    if bad.any():
        worst = float(histogram[bad][0])
        raise InvalidValue("histogram bin", worst, "a finite number >= 0")
    return histogram
