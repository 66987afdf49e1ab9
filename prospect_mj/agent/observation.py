"""What a learner is told: states as they are observed, and steps between them."""

from typing import NamedTuple, Self

import numpy as np
from numpy.typing import NDArray

from prospect_mj.agent import haptics
from prospect_mj.agent.features import N_BINS

NOT_TOLD = -1
"""In place of the orientation, where the learner needs none."""


class Observation(NamedTuple):
    """A state, in every form in which one of the learners knows it."""

    features: NDArray[np.float64]
    """phi, (n_features,) [1]."""
    visual: NDArray[np.float64]
    """v, (100,) [1], the scaled histogram."""
    haptic: int
    """Number of the haptic state (`agent.haptics`)."""
    orientation: int
    """Side of the lid: 0 left, 1 right. It can't be observed: only learners that are
    told read it, `TableQ` and a `DiscoveryQ` with forced splits."""

    @classmethod
    def of(cls, features: NDArray[np.float64], orientation: int = NOT_TOLD) -> Self:
        """Read picture and haptic state off the linear features, in either reading.

        The block of the hand that holds the jar, or the first where none does, is v
        in both readings of the Cartesian product (`agent.features`).

        Args:
            features: phi, (303,), or longer with haptic categories (`agent.haptics`).
            orientation: side of the lid, 0 left, 1 right, for who is told of it.

        Raises:
            InvalidValue: if no number of categories makes features of this length.
        """
        categories = haptics.categories_of_features(len(features))
        bits = features[-3 - categories : -1]
        holding = int(bits[0]) + 2 * int(bits[1])
        visual = features[holding * N_BINS : (holding + 1) * N_BINS]
        category = int(np.argmax(bits[2:])) if categories else 0
        haptic = haptics.haptic_state(holding, category, categories)
        return cls(features, visual, haptic, orientation)


class Transition(NamedTuple):
    """One action, from the state in which it was chosen to the next one."""

    observation: Observation
    """Of the state that was left."""
    action: int
    """The action taken there."""
    reward: float
    """r [actions]."""
    next_observation: Observation
    """Of the state that was reached."""
    terminated: bool
    """Whether that state ends the task: its value is then zero."""
    truncated: bool
    """Whether the trial was cut off there."""
    allowed: NDArray[np.bool_]
    """(n_actions,): what may be chosen in the state that was reached, by supervisor
    and rule for failed actions; the maximum of the target is over these."""

    @property
    def is_last(self) -> bool:
        """Whether the trial has ended."""
        return self.terminated or self.truncated
