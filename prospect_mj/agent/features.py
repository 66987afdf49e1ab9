"""The state feature generator: image histogram and grasp predicates to 303 features.

Wheeler, Fagg & Grupen (ICDL 2002), section 3.1: the feature vector is "the Cartesian
product of the visual and haptic features, the haptic features themselves, and a
constant 1". With v the scaled histogram and h_L, h_R the two grasp predicates,

    product:  phi = (v,            v h_L, v h_R, h_L, h_R, 1)
    one_hot:  phi = (v (none held), v h_L, v h_R, h_L, h_R, 1)

are the two readings of it that have 303 elements. They span the same functions; in the
first, what is learned about the picture generalises over the haptic states.

With K categories of grasps c_1, ..., c_K are haptic features as well, all of them zero
where no hand holds the jar (`agent.haptics`); v c_1, ..., v c_K follow v h_R, and
c_1, ..., c_K follow h_R.
"""

from dataclasses import dataclass
from typing import Literal, NamedTuple, get_args

import numpy as np
from numpy.typing import ArrayLike, NDArray

from prospect_mj.agent.haptics import (
    N_BINS,
    haptic_bits,
    haptic_state,
    n_features,
)
from prospect_mj.checks import check_choice, check_integer, check_number
from prospect_mj.errors import InvalidValue

N_FEATURES = n_features(0)
MOST_CATEGORIES = 100
"""Kinds of grasps that features may tell apart."""

Holding = Literal["none", "left", "right"]
Reading = Literal["product", "one_hot"]
Normalisation = Literal["energy", "max_bin", "unit_sum"]

HOLDINGS: tuple[Holding, ...] = get_args(Holding)
"""By their numbers in `agent.haptics`."""


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
    """(n_features,) [1]."""
    high: NDArray[np.float64]
    """(n_features,) [1]."""


class HapticState(NamedTuple):
    """What the hands feel."""

    holding: Holding
    """The hand whose grasp predicate is on."""
    category: int = 0
    """Of its grasp, from 0; 0 without categories or where no hand holds."""


class StateFeatureGenerator:
    """Turns raw bin counts and the haptic state into the learner's features.

    Args:
        settings: reading and scale; None for the defaults.
        categories: K, number of the categories of grasps.

    Attributes:
        settings: as given.
        categories: as given.
    """

    def __init__(
        self, settings: FeatureSettings | None = None, categories: int = 0
    ) -> None:
        """Generate features in the way that `settings` says."""
        check_integer("haptic categories", categories, 0, MOST_CATEGORIES)
        self.settings = FeatureSettings() if settings is None else settings
        self.categories = categories
        self._bits = haptic_bits(categories).astype(np.float64)

    def generate(
        self, counts: ArrayLike, holding: Holding, category: int = 0
    ) -> NDArray[np.float64]:
        """Compute the feature vector of one state.

        Args:
            counts: (100,) [pixels] per intensity bin; all zero if the object was not
                seen, which gives v = 0.
            holding: the hand whose grasp predicate is on, or "none".
            category: of its grasp, from 0; without meaning where no hand holds, or
                there are no categories.

        Returns:
            (n_features,) [1], a new array; 303 without categories.
        """
        visual = self.scaled_histogram(counts)
        bits = self._bits[self._state(holding, category)]
        first = 1.0 if self.settings.reading == "product" or not bits.any() else 0.0
        blocks = [first * visual, *(bit * visual for bit in bits)]
        return np.concatenate([*blocks, bits, [1.0]])

    @property
    def states(self) -> tuple[HapticState, ...]:
        """Every haptic state, in the order of its number in `agent.haptics`."""
        nobody, *hands = HOLDINGS
        kinds = range(max(self.categories, 1))
        held = (HapticState(hand, kind) for hand in hands for kind in kinds)
        return HapticState(nobody), *held

    def _state(self, holding: Holding, category: int) -> int:
        """Number of the haptic state."""
        check_choice("holding", holding, HOLDINGS)
        if self.categories and holding != "none":
            check_integer("haptic category", category, 0, self.categories - 1)
        return haptic_state(HOLDINGS.index(holding), category, self.categories)

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
        high = np.ones(n_features(self.categories))
        high[: N_BINS * (1 + self._bits.shape[1])] = largest
        low = np.zeros(len(high))
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
