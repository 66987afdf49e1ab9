"""Which grey levels decide with which hand the learner begins.

Before the first grasp no hand holds the jar, and Q is linear in the histogram v:

    Q(v, a) = sum_i w_ai v_i + b_a ,

so that the learner's preference for its left hand is

    D(v) = Q(v, grasp-left) - Q(v, grasp-right)
         = sum_i (w_Li - w_Ri) v_i + b_L - b_R .

A learner that has made up its mind has D > 0 where the lid lies on the left and D < 0
where it lies on the right. What is on average added to D by turning the jar round is

    mean D (lid left) - mean D (lid right) = sum_i c_i ,
    c_i = (w_Li - w_Ri) (mean v_i (lid left) - mean v_i (lid right)) .

The constants have cancelled, and so c_i is what grey level i alone contributes to the
decision: it counts for nothing where both jars look alike (v does not differ) or where
both hands are worth the same (w does not differ); c_i < 0 speaks for the wrong hand.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Self

import numpy as np
from numpy.typing import NDArray

from prospect_mj.actions.action import Action
from prospect_mj.agent import LinearQ, Observation, StateFeatureGenerator
from prospect_mj.agent.features import N_BINS, HapticState
from prospect_mj.agent.haptics import NONE
from prospect_mj.experiment.paper.measures.bootstrap import Floats
from prospect_mj.task.presentation import Orientation


@dataclass(frozen=True, eq=False)
class MadeUpMind:
    """What a learner thinks of the mean picture of both orientations."""

    weights: Floats
    """(6, 3, 100) [actions]: of v, v h_L and v h_R."""
    v: Mapping[Orientation, Floats]
    """(100,) [1], mean histogram by side of the lid."""
    q_values: Mapping[Orientation, Floats]
    """(6, h) [actions], mean Q of every action in every haptic state."""
    states: tuple[HapticState, ...]
    """(h,): the haptic states."""

    @classmethod
    def of(
        cls,
        learner: LinearQ,
        generator: StateFeatureGenerator,
        counts: Mapping[Orientation, NDArray[np.int64]],
    ) -> Self:
        """Show pictures to a learner.

        Args:
            learner: with its weights.
            generator: of its features.
            counts: (n, 100) [pixels] per side of the lid.
        """
        v = {
            side: np.mean([generator.scaled_histogram(one) for one in rows], axis=0)
            for side, rows in counts.items()
        }
        q_values = {
            side: _mean_values(learner, generator, rows)
            for side, rows in counts.items()
        }
        blocks = learner.weights[:, : 3 * N_BINS].reshape(-1, 3, N_BINS)
        return cls(blocks, v, q_values, generator.states)

    @property
    def contributions(self) -> Floats:
        """What each bin adds to the decision, c (100,) [actions]; see the module."""
        of_v = self.weights[:, 0]
        differing = of_v[Action.GRASP_LEFT] - of_v[Action.GRASP_RIGHT]
        return differing * (self.v["left"] - self.v["right"])

    @property
    def preferences(self) -> dict[Orientation, float]:
        """Mean D [actions] by side of the lid; see the module."""
        return {
            side: float(
                table[Action.GRASP_LEFT, NONE] - table[Action.GRASP_RIGHT, NONE]
            )
            for side, table in self.q_values.items()
        }


def _mean_values(
    learner: LinearQ, generator: StateFeatureGenerator, rows: NDArray[np.int64]
) -> Floats:
    """Mean Q (6, h) in h haptic states, over pictures (n, 100)."""
    # Q is linear: its mean is that of the mean features.
    means = [
        np.mean([generator.generate(one, *state) for one in rows], axis=0)
        for state in generator.states
    ]
    seen = map(Observation.of, means)
    return np.column_stack([learner.q_values(one) for one in seen])
