"""What an agent observes: the features, alone or with the images of the first look."""

from typing import TYPE_CHECKING, Protocol

import numpy as np
from gymnasium import spaces
from numpy.typing import NDArray

from prospect_mj.agent.features import (
    N_BINS,
    FeatureSettings,
    Holding,
    StateFeatureGenerator,
)

if TYPE_CHECKING:
    from prospect_mj.sim.camera import StereoPair

FEATURES, LEFT_IMAGE, RIGHT_IMAGE = "features", "left_image", "right_image"

Observation = NDArray[np.float64] | dict[str, NDArray[np.generic]]
"""The features, or a dictionary of features and images."""


class Observer(Protocol):
    """Makes observations of a trial."""

    @property
    def space(self) -> spaces.Space[Observation]:
        """Where they lie."""
        ...

    def begin(self, histogram: NDArray[np.int64], images: "StereoPair | None") -> None:
        """Take in the look that a trial begins with.

        Args:
            histogram: (100,) [pixels].
            images: None on recorded physics.
        """
        ...

    def observe(self, holding: Holding, category: int) -> Observation:
        """The observation at present, in memory of its own.

        Args:
            holding: the hand that holds the jar.
            category: of its grasp; without meaning where there are none.
        """
        ...


class FeatureObserver:
    """Observes the features.

    Args:
        settings: their reading and scale.
        categories: K, number of the categories of grasps.

    Attributes:
        space: `Box((n_features,))`; 303 without categories.
    """

    def __init__(self, settings: FeatureSettings, categories: int = 0) -> None:
        """Nothing has been seen yet."""
        self._generator = StateFeatureGenerator(settings, categories)
        low, high = self._generator.bounds
        self.space = spaces.Box(low, high, dtype=np.float64)
        self._histogram: NDArray[np.int64] = np.zeros(N_BINS, np.int64)

    def begin(self, histogram: NDArray[np.int64], images: "StereoPair | None") -> None:
        """Keep the histogram."""
        self._histogram = histogram

    def observe(self, holding: Holding, category: int) -> NDArray[np.float64]:
        """The features (n_features,)."""
        return self._generator.generate(self._histogram, holding, category)


class ImageObserver:
    """Observes the features and what both eyes saw before the first action.

    Args:
        features: observes these.
        size: columns and rows of an image [pixels].

    Attributes:
        space: a `Dict` of `features`, `left_image` and `right_image`.
    """

    def __init__(self, features: FeatureObserver, size: tuple[int, int]) -> None:
        """Nothing has been seen yet."""
        self._features = features
        columns, rows = size
        image = spaces.Box(0, 255, (rows, columns, 3), np.uint8)
        self.space = spaces.Dict(
            {FEATURES: features.space, LEFT_IMAGE: image, RIGHT_IMAGE: image}
        )
        self._images: StereoPair | None = None

    def begin(self, histogram: NDArray[np.int64], images: "StereoPair | None") -> None:
        """Keep histogram and images."""
        self._features.begin(histogram, images)
        self._images = images

    def observe(
        self, holding: Holding, category: int
    ) -> dict[str, NDArray[np.generic]]:
        """Features (n_features,) and images (rows, columns, 3)."""
        return {
            FEATURES: self._features.observe(holding, category),
            LEFT_IMAGE: self._images.left.copy(),
            RIGHT_IMAGE: self._images.right.copy(),
        }
