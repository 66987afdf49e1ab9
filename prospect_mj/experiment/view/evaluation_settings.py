"""What an evaluation shows, and where its chance comes from.

No training, whatever its seed, has shown what an evaluation shows: a training draws its
presentations by seeds of 32 bits, an evaluation by seeds of 64 bits, the first of which
is set.
"""

from dataclasses import dataclass, replace
from enum import IntEnum
from typing import get_args

import numpy as np

from prospect_mj.checks import check_choice, check_integer
from prospect_mj.envs.settings import Physics
from prospect_mj.experiment.run.config import TrainConfig
from prospect_mj.recording.config import LARGEST_SEED
from prospect_mj.task.presentation import ORIENTATIONS, Orientation

MOST_TRIALS = 50_000

_FRESH = 1 << 63


class _Stream(IntEnum):
    """The independent sources of chance in an evaluation."""

    PRESENTATION = 0
    POLICY = 1


@dataclass(frozen=True)
class EvaluationSettings:
    """Everything that decides the numbers of an evaluation, its learner apart."""

    trials: int = 50
    """Presentations of each of the two orientations, two at least."""
    seed: int = 0
    """Equal seeds show the same presentations; no training has shown them."""
    physics: Physics = "live"
    """live: every action is simulated; recorded: it is looked up, in presentations that
    a run on the same recording has learned from."""

    def __post_init__(self) -> None:
        """Refuse what makes no evaluation."""
        check_integer("trials", self.trials, 2, MOST_TRIALS)
        check_integer("seed", self.seed, 0, LARGEST_SEED)
        check_choice("physics", self.physics, get_args(Physics))

    @property
    def n_trials(self) -> int:
        """Of both orientations together."""
        return self.trials * len(ORIENTATIONS)

    def config(self, learned: TrainConfig) -> TrainConfig:
        """Settings of the trials: those that were learned with, on this physics."""
        if self.physics == learned.physics:
            return replace(learned, grow=False)
        return replace(learned, physics=self.physics, recording=None, grow=False)

    def orientation(self, trial: int) -> Orientation:
        """Side on which the lid lies: one and the other in turn."""
        return ORIENTATIONS[trial % len(ORIENTATIONS)]

    def presentation_seed(self, trial: int) -> int:
        """What the environment draws a trial's presentation by; see the module."""
        sequence = self._seed(trial, _Stream.PRESENTATION)
        return _FRESH | int(sequence.generate_state(1, np.uint64)[0])

    def policy_rng(self, trial: int) -> np.random.Generator:
        """Breaks ties between actions of equal value."""
        return np.random.default_rng(self._seed(trial, _Stream.POLICY))

    def _seed(self, trial: int, stream: _Stream) -> np.random.SeedSequence:
        # Keys of training have one number less.
        return np.random.SeedSequence(self.seed, spawn_key=(trial, 0, int(stream)))
