"""Values and detectors of every context, which is a haptic state and an action.

A context begins as a whole, with one mean value. Once it has a detector it is split:
pictures of the one and of the other class have values of their own, its leaves.
"""

from typing import NamedTuple, Self

import numpy as np
from numpy.typing import NDArray

from prospect_mj.agent.discovery.detector import Detector, likelier_class
from prospect_mj.agent.discovery.examples import Context
from prospect_mj.agent.discovery.feature import Feature
from prospect_mj.agent.settings import DiscoverySettings

WHOLE = -1
"""Stands for a leaf where a context has none."""


class Contexts(NamedTuple):
    """Arrays over all contexts: (n_haptic, n_actions), or one row for each of them."""

    mean: NDArray[np.float64]
    """[actions], over all pictures; after a split, too."""
    count: NDArray[np.int64]
    """Targets that the mean was learned from."""
    leaf_value: NDArray[np.float64]
    """(..., 2) [actions], of pictures of either class; without meaning if whole."""
    leaf_count: NDArray[np.int64]
    """(..., 2): targets that each was learned from."""
    n_detectors: NDArray[np.int64]
    """How many it has."""
    ranges: NDArray[np.int64]
    """(..., features_per_context, 4): their features."""
    cut: NDArray[np.float64]
    """(..., features_per_context) [1]."""
    distance: NDArray[np.float64]
    """(..., features_per_context) [1]."""
    present: NDArray[np.int64]
    """(..., features_per_context, 2)."""
    total: NDArray[np.int64]
    """(..., features_per_context, 2)."""
    lent: NDArray[np.bool_]
    """Whether its detector is another context's (`share_first`)."""
    told: NDArray[np.bool_]
    """Whether it is split by the true orientation (`forced_splits`)."""
    first_split: NDArray[np.int64]
    """Number of the trial after which it was split, from 0; -1: not yet."""

    @classmethod
    def whole(cls, settings: DiscoverySettings) -> Self:
        """Contexts that know nothing."""
        shape = settings.n_haptic, settings.n_actions
        slots = *shape, settings.features_per_context
        return cls(
            mean=np.zeros(shape),
            count=np.zeros(shape, np.int64),
            leaf_value=np.zeros((*shape, 2)),
            leaf_count=np.zeros((*shape, 2), np.int64),
            n_detectors=np.zeros(shape, np.int64),
            ranges=np.zeros((*slots, 4), np.int64),
            cut=np.zeros(slots),
            distance=np.zeros(slots),
            present=np.zeros((*slots, 2), np.int64),
            total=np.zeros((*slots, 2), np.int64),
            lent=np.zeros(shape, np.bool_),
            told=np.zeros(shape, np.bool_),
            first_split=np.full(shape, -1, np.int64),
        )

    def is_split(self, context: Context) -> bool:
        """Whether a context has leaves."""
        return bool(self.told[context] or self.n_detectors[context] > 0)

    def leaf(
        self, context: Context, picture: NDArray[np.float64], orientation: int
    ) -> int:
        """The leaf that a picture, (101,) [1], falls into, or WHOLE."""
        if self.told[context]:
            return orientation
        if not self.n_detectors[context]:
            return WHOLE
        return likelier_class(self.detectors(context), picture)

    def value(self, context: Context, leaf: int) -> float:
        """The value of a leaf [actions], the mean if WHOLE."""
        if leaf == WHOLE:
            return float(self.mean[context])
        return float(self.leaf_value[*context, leaf])

    def learn(self, context: Context, leaf: int, target: float, least: float) -> None:
        """Move the mean and the leaf's value towards a target.

        The rate is that of an average, 1 / n, but never below `least`: from then on
        the past is forgotten, slowly if `least` is small.
        """
        self.count[context] += 1
        rate = max(1.0 / self.count[context], least)
        self.mean[context] += rate * (target - self.mean[context])
        if leaf != WHOLE:
            place = *context, leaf
            self.leaf_count[place] += 1
            rate = max(1.0 / self.leaf_count[place], least)
            self.leaf_value[place] += rate * (target - self.leaf_value[place])

    def inherit(self, context: Context) -> None:
        """Let both leaves be what the whole was."""
        self.leaf_value[context] = self.mean[context]
        self.leaf_count[context] = self.count[context]

    def detectors(self, context: Context) -> list[Detector]:
        """The detectors of a context."""
        return [
            Detector(
                Feature(*self.ranges[*context, slot].tolist()),
                float(self.cut[*context, slot]),
                float(self.distance[*context, slot]),
                self.present[*context, slot],
                self.total[*context, slot],
            )
            for slot in range(self.n_detectors[context])
        ]

    def put(self, context: Context, detectors: list[Detector]) -> None:
        """Give a context these detectors in place of those that it has."""
        self.n_detectors[context] = len(detectors)
        for slot, one in enumerate(detectors):
            place = *context, slot
            self.ranges[place], self.cut[place] = one.feature, one.cut
            self.distance[place] = one.distance
            self.present[place], self.total[place] = one.present, one.total
