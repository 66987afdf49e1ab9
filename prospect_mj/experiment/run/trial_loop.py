"""One trial: what is presented, what the learner chooses, what is remembered of it.

Training and evaluation share it: the one learns from each transition, the other does
not.
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from prospect_mj.agent import LinearQ
from prospect_mj.agent.linear_q import Choice
from prospect_mj.experiment.run.environment import Environment, Info
from prospect_mj.experiment.run.records import ACTION_NAMES, ActionRecord, TrialRecord
from prospect_mj.task.presentation import Orientation


class Presented(NamedTuple):
    """What a trial shows."""

    trial: int
    """Its number, from 0."""
    orientation: Orientation
    """Side on which the lid lies."""
    seed: int
    """Of the environment, which draws the rest."""
    counted_as: int
    """Number by which a shaping schedule knows the trial."""
    pretraining: bool = False
    """Whether it belongs to the pretraining."""


class Transition(NamedTuple):
    """One action, from the state in which it was chosen to the next one."""

    features: NDArray[np.float64]
    """phi, (303,)."""
    info: Info
    choice: Choice
    next_features: NDArray[np.float64]
    """phi', (303,)."""
    reward: float
    """[actions]."""
    terminated: bool
    truncated: bool
    next_info: Info

    @property
    def is_last(self) -> bool:
        """Whether the trial has ended."""
        return self.terminated or self.truncated


class FinishedTrial(NamedTuple):
    """One trial's records."""

    trial: TrialRecord
    """The trial as a whole."""
    actions: tuple[ActionRecord, ...]
    """Its actions in order, at least one."""


Learn = Callable[[Transition], None]


def run(
    env: Environment,
    presented: Presented,
    learner: LinearQ,
    rng: np.random.Generator,
    learn: Learn | None = None,
) -> FinishedTrial:
    """Present the jar once and act until the trial ends.

    Args:
        env: where the actions happen.
        presented: what it shows.
        learner: chooses.
        rng: for its choices.
        learn: told of each transition before the next choice; None: nobody is.
    """
    features, first_info = env.reset(
        seed=presented.seed,
        options={
            "orientation": presented.orientation,
            "trial": presented.counted_as,
        },
    )
    info, actions, ended = first_info, [], False
    while not ended:
        choice = learner.choose(features, rng, info["action_mask"])
        transition = Transition(features, info, choice, *env.step(choice.action))
        if learn is not None:
            learn(transition)
        actions.append(_action_record(presented.trial, len(actions), transition))
        features, info = transition.next_features, transition.next_info
        ended = transition.is_last
    return FinishedTrial(_trial_record(presented, first_info, actions), tuple(actions))


def _action_record(trial: int, step: int, transition: Transition) -> ActionRecord:
    choice, outcome = transition.choice, transition.next_info
    return ActionRecord(
        trial=trial,
        step=step,
        action=choice.action,
        action_name=ACTION_NAMES[choice.action],
        explored=choice.explored,
        holding=str(transition.info["holding"]),
        q_values=tuple(choice.q_values.tolist()),
        executed=bool(outcome["executed"]),
        result=str(outcome["result"]),
        next_holding=str(outcome["holding"]),
        reward=float(transition.reward),
        sim_seconds=float(outcome["sim_seconds"]),
        inserted=bool(outcome["inserted"]),
    )


def _trial_record(
    presented: Presented, first_info: Info, actions: list[ActionRecord]
) -> TrialRecord:
    return TrialRecord(
        trial=presented.trial,
        orientation=presented.orientation,
        pretraining=presented.pretraining,
        look=str(first_info["result"]),
        n_actions=len(actions),
        solved=actions[-1].inserted,
        sim_seconds=sum(action.sim_seconds for action in actions),
    )
