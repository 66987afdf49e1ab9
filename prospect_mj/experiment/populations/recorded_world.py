"""What trials take place in: recorded outcomes, and what a grasp feels like in them."""

from dataclasses import dataclass
from typing import Self

import numpy as np
from numpy.typing import NDArray

from prospect_mj.checks import check_integer
from prospect_mj.errors import InvalidValue
from prospect_mj.recording.arrays import UNKNOWN
from prospect_mj.recording.hands import GRASPS, INSERTIONS
from prospect_mj.recording.recording import Recording


@dataclass(frozen=True, eq=False)
class RecordedWorld:
    """A recording, with or without categories of the grasps in it."""

    recording: Recording
    """Outcomes and histograms."""
    categories: int = 0
    """K, number of the categories of grasps."""
    category: NDArray[np.int64] | None = None
    """(n,): that of the grasp in which each node of the recording has the jar; without
    meaning where no hand holds it. None without categories."""

    def __post_init__(self) -> None:
        """Refuse categories that aren't those of the recording."""
        check_integer("haptic categories", self.categories, 0, 100)
        if (self.category is None) != (self.categories == 0):
            expected = "an array of them just where their number is not 0"
            raise InvalidValue("haptic categories", self.categories, expected)
        if self.category is not None:
            self._check(self.category)

    @classmethod
    def of(cls, recording: "Recording | Self") -> Self:
        """A world as it is, or that of a recording without categories."""
        return cls(recording) if isinstance(recording, Recording) else recording

    @property
    def lid_first(self) -> bool:
        """Whether the jar goes in with its lid down, held by its body.

        Told by its outcomes: which hand's grasp and insertion, right after the
        presentation, insert it more often.
        """
        return self._inserted(by_lids_hand=False) > self._inserted(by_lids_hand=True)

    def _inserted(self, by_lids_hand: bool) -> int:
        """Presentations in which a hand inserts the jar by two actions."""
        nodes, shown = self.recording.nodes, self.recording.presentations
        count = 0
        for hand, grasp in GRASPS.items():
            root = shown.root[(shown.lid == hand) == by_lids_hand]
            held = nodes.child[root, grasp]
            led_to = nodes.child[held, INSERTIONS[hand]]
            known = (held != UNKNOWN) & (led_to != UNKNOWN)
            count += int(nodes.inserted[led_to[known]].sum())
        return count

    def _check(self, category: NDArray[np.int64]) -> None:
        expected = f"({len(self.recording.nodes.child)},)"
        if str(category.shape) != expected:
            raise InvalidValue("shape of haptic categories", category.shape, expected)
        wrong = category[(category < 0) | (category >= self.categories)]
        if len(wrong):
            expected = f"0 to {self.categories - 1}"
            raise InvalidValue("haptic category", int(wrong[0]), expected)
