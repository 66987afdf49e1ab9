"""The trial loop: where the environment and the learner meet.

All chance in trial t comes from seeds made of the run's seed, t and the name of the
stream. No generator outlives its trial, so a resumed run needs no generator's state to
go on bit for bit like one that was never stopped.
"""

from collections.abc import Iterator
from enum import IntEnum

import numpy as np

from prospect_mj.agent import Learner, Transition, learners
from prospect_mj.agent.failed_actions import FailedActionRule
from prospect_mj.experiment.run import trial_loop
from prospect_mj.experiment.run.config import TrainConfig
from prospect_mj.experiment.run.environment import Environment
from prospect_mj.experiment.run.trial_loop import FinishedTrial, Presented
from prospect_mj.task.presentation import ORIENTATIONS, Orientation


class Stream(IntEnum):
    """The independent sources of chance in a trial."""

    ORIENTATION = 0
    PRESENTATION = 1
    AGENT = 2
    """The learner's choices."""
    LEARNING = 3
    """What the learner draws to learn."""


def trial_seed(seed: int, trial: int, stream: Stream) -> np.random.SeedSequence:
    """Seed of one stream of one trial."""
    return np.random.SeedSequence(seed, spawn_key=(trial, int(stream)))


def presentation_seed(seed: int, trial: int) -> int:
    """What the environment draws a trial's presentation by, 32 bits."""
    return int(trial_seed(seed, trial, Stream.PRESENTATION).generate_state(1)[0])


def new_learner(config: TrainConfig) -> Learner:
    """The learner of a run before its first trial."""
    # A key of its own, which no stream of a trial has.
    seed = np.random.SeedSequence(config.seed, spawn_key=(0,))
    return learners.new_learner(config.learner, np.random.default_rng(seed))


def presented_orientation(config: TrainConfig, trial: int) -> Orientation:
    """Side on which the lid lies: the dominant one in pretraining, then a fair coin."""
    if trial < config.pretrain:
        return config.dominant
    rng = np.random.default_rng(trial_seed(config.seed, trial, Stream.ORIENTATION))
    return ORIENTATIONS[rng.integers(len(ORIENTATIONS))]


def train(
    config: TrainConfig, env: Environment, learner: Learner, first_trial: int = 0
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
    config: TrainConfig, env: Environment, learner: Learner, trial: int
) -> FinishedTrial:
    """Present the jar once and learn from every action until the trial ends."""
    choosing, learning = (
        np.random.default_rng(trial_seed(config.seed, trial, stream))
        for stream in (Stream.AGENT, Stream.LEARNING)
    )
    presented = Presented(
        trial,
        presented_orientation(config, trial),
        presentation_seed(config.seed, trial),
        counted_as=trial,
        pretraining=trial < config.pretrain,
    )

    def learn(transition: Transition) -> None:
        if transition.truncated and not config.bootstrap_at_truncation:
            # Nothing follows, so that nothing is counted.
            transition = transition._replace(terminated=True)
        learner.update(transition, learning)

    rule = FailedActionRule(config.failed_actions)
    return trial_loop.run(env, presented, learner, choosing, rule, learn)
