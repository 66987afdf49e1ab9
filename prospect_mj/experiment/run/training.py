"""The trial loop: where the environment and the learner meet.

All chance in trial t comes from seeds made of the run's seed, t and the name of the
stream. No generator outlives its trial, so a resumed run needs no generator's state to
go on bit for bit like one that was never stopped.
"""

from collections.abc import Iterator
from enum import IntEnum

import numpy as np

from prospect_mj.agent import LinearQ
from prospect_mj.errors import InvalidValue
from prospect_mj.experiment.run import trial_loop
from prospect_mj.experiment.run.config import TrainConfig
from prospect_mj.experiment.run.environment import Environment
from prospect_mj.experiment.run.trial_loop import FinishedTrial, Presented, Transition
from prospect_mj.task.presentation import ORIENTATIONS, Orientation


class Stream(IntEnum):
    """The independent sources of chance in a trial."""

    ORIENTATION = 0
    PRESENTATION = 1
    AGENT = 2


def trial_seed(seed: int, trial: int, stream: Stream) -> np.random.SeedSequence:
    """Seed of one stream of one trial."""
    return np.random.SeedSequence(seed, spawn_key=(trial, int(stream)))


def presentation_seed(seed: int, trial: int) -> int:
    """What the environment draws a trial's presentation by, 32 bits."""
    return int(trial_seed(seed, trial, Stream.PRESENTATION).generate_state(1)[0])


def new_learner(config: TrainConfig, origin: str = "") -> LinearQ:
    """The learner of a run before its first trial."""
    # A key of its own, which no stream of a trial has.
    seed = np.random.SeedSequence(config.seed, spawn_key=(0,))
    return LinearQ(config.learner, origin, np.random.default_rng(seed))


def presented_orientation(config: TrainConfig, trial: int) -> Orientation:
    """Side on which the lid lies: the dominant one in pretraining, then a fair coin."""
    if trial < config.pretrain:
        return config.dominant
    rng = np.random.default_rng(trial_seed(config.seed, trial, Stream.ORIENTATION))
    return ORIENTATIONS[rng.integers(len(ORIENTATIONS))]


def train(
    config: TrainConfig, env: Environment, learner: LinearQ, first_trial: int = 0
) -> Iterator[FinishedTrial]:
    """Run the trials that are left, each as it is asked for.

    Args:
        config: the run.
        env: where the actions happen.
        learner: learns in place; after each trial it is the state to save.
        first_trial: number of trials that `learner` has already learned from.

    Yields:
        Each trial when it has ended.
    """
    for trial in range(first_trial, config.trials):
        yield run_trial(config, env, learner, trial)


def run_trial(
    config: TrainConfig, env: Environment, learner: LinearQ, trial: int
) -> FinishedTrial:
    """Present the jar once and learn from every action until the trial ends."""
    rng = np.random.default_rng(trial_seed(config.seed, trial, Stream.AGENT))
    presented = Presented(
        trial,
        presented_orientation(config, trial),
        presentation_seed(config.seed, trial),
        counted_as=trial,
        pretraining=trial < config.pretrain,
    )

    def learn(transition: Transition) -> None:
        _learn(config, learner, transition)

    return trial_loop.run(env, presented, learner, rng, learn)


def _learn(config: TrainConfig, learner: LinearQ, transition: Transition) -> None:
    cut_off = transition.truncated and not config.bootstrap_at_truncation
    learner.update(
        transition.features,
        transition.choice.action,
        transition.reward,
        transition.next_features,
        transition.terminated or cut_off,
        transition.next_info["action_mask"],
    )
    # The error was a number; what it is multiplied by can make it none.
    weights = learner.weights[transition.choice.action]
    if not np.isfinite(weights).all():
        size = float(np.abs(weights).max())
        expected = "finite numbers (step size x |features|^2 must stay below 2)"
        raise InvalidValue("largest of the learned weights", size, expected)
