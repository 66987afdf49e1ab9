"""The trial loop: where the environment and the learner meet.

All chance in trial t comes from seeds made of the run's seed, t and the name of the
stream. No generator outlives its trial, so a resumed run needs no generator's state to
go on bit for bit like one that was never stopped.
"""

from collections.abc import Iterator
from enum import IntEnum
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from prospect_mj.agent import LinearQ
from prospect_mj.agent.linear_q import Choice
from prospect_mj.experiment.config import TrainConfig
from prospect_mj.experiment.environment import Environment, Info
from prospect_mj.experiment.records import ACTION_NAMES, ActionRecord, TrialRecord
from prospect_mj.task.presentation import ORIENTATIONS, Orientation


class Stream(IntEnum):
    """The independent sources of chance in a trial."""

    ORIENTATION = 0
    PRESENTATION = 1
    AGENT = 2


class FinishedTrial(NamedTuple):
    """One trial's records."""

    trial: TrialRecord
    """The trial as a whole."""
    actions: tuple[ActionRecord, ...]
    """Its actions in order, at least one."""


def trial_seed(seed: int, trial: int, stream: Stream) -> np.random.SeedSequence:
    """Seed of one stream of one trial."""
    return np.random.SeedSequence(seed, spawn_key=(trial, int(stream)))


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
    presentation = trial_seed(config.seed, trial, Stream.PRESENTATION)
    orientation = presented_orientation(config, trial)
    features, first_info = env.reset(
        seed=int(presentation.generate_state(1)[0]),
        options={"orientation": orientation, "trial": trial},
    )
    info, actions, ended = first_info, [], False
    while not ended:
        transition = _act(env, learner, rng, features, info)
        _learn(config, learner, features, transition)
        actions.append(_action_record(trial, len(actions), info, transition))
        features, info = transition.next_features, transition.next_info
        ended = transition.terminated or transition.truncated
    return FinishedTrial(
        _trial_record(config, orientation, first_info, actions), tuple(actions)
    )


class _Transition(NamedTuple):
    choice: Choice
    next_features: NDArray[np.float64]
    reward: float
    terminated: bool
    truncated: bool
    next_info: Info


def _act(
    env: Environment,
    learner: LinearQ,
    rng: np.random.Generator,
    features: NDArray[np.float64],
    info: Info,
) -> _Transition:
    choice = learner.choose(features, rng, info["action_mask"])
    return _Transition(choice, *env.step(choice.action))


def _learn(
    config: TrainConfig,
    learner: LinearQ,
    features: NDArray[np.float64],
    transition: _Transition,
) -> None:
    cut_off = transition.truncated and not config.bootstrap_at_truncation
    learner.update(
        features,
        transition.choice.action,
        transition.reward,
        transition.next_features,
        transition.terminated or cut_off,
        transition.next_info["action_mask"],
    )


def _action_record(
    trial: int, step: int, info: Info, transition: _Transition
) -> ActionRecord:
    choice, outcome = transition.choice, transition.next_info
    return ActionRecord(
        trial=trial,
        step=step,
        action=choice.action,
        action_name=ACTION_NAMES[choice.action],
        explored=choice.explored,
        holding=str(info["holding"]),
        q_values=tuple(choice.q_values.tolist()),
        executed=bool(outcome["executed"]),
        result=str(outcome["result"]),
        next_holding=str(outcome["holding"]),
        reward=float(transition.reward),
        sim_seconds=float(outcome["sim_seconds"]),
        inserted=bool(outcome["inserted"]),
    )


def _trial_record(
    config: TrainConfig,
    orientation: Orientation,
    first_info: Info,
    actions: list[ActionRecord],
) -> TrialRecord:
    trial = actions[0].trial
    return TrialRecord(
        trial=trial,
        orientation=orientation,
        pretraining=trial < config.pretrain,
        look=str(first_info["result"]),
        n_actions=len(actions),
        solved=actions[-1].inserted,
        sim_seconds=sum(action.sim_seconds for action in actions),
    )
