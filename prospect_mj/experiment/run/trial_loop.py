"""One trial: what is presented, what the learner chooses, what is remembered of it.

Training and evaluation share it: the one learns from each transition, the other does
not.
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from prospect_mj.agent import Learner, Observation, Transition
from prospect_mj.agent.choice import Choice
from prospect_mj.agent.failed_actions import FailedActionRule
from prospect_mj.agent.features import HOLDINGS
from prospect_mj.experiment.run.environment import Environment, Info
from prospect_mj.experiment.run.records import ACTION_NAMES, ActionRecord, TrialRecord
from prospect_mj.task.presentation import ORIENTATIONS, Orientation


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


class _Taken(NamedTuple):
    """One action as the environment told of it."""

    info: Info
    """Before it."""
    choice: Choice
    features: NDArray[np.float64]
    """phi', (303,), after it."""
    reward: float
    """[actions]."""
    terminated: bool
    truncated: bool
    next_info: Info


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
    learner: Learner,
    rng: np.random.Generator,
    rule: FailedActionRule,
    learn: Learn | None = None,
) -> FinishedTrial:
    """Present the jar once and act until the trial ends.

    Args:
        env: where the actions happen.
        presented: what it shows.
        learner: chooses.
        rng: for its choices.
        rule: of a trial in which nothing has failed yet.
        learn: told of each transition before the next choice; None: nobody is.
    """
    side = ORIENTATIONS.index(presented.orientation)
    told = {"orientation": presented.orientation, "trial": presented.counted_as}
    features, first_info = env.reset(seed=presented.seed, options=told)
    seen, info, actions, ended = Observation.of(features, side), first_info, [], False
    allowed = rule.remaining(_holding(info), info["action_mask"])
    while not ended:
        choice = learner.select(seen, rng, allowed)
        taken = _Taken(info, choice, *env.step(choice.action))
        allowed = _allowed_after(taken, rule)
        transition = _transition(seen, taken, allowed)
        if learn is not None:
            learn(transition)
        actions.append(_action_record(presented.trial, len(actions), taken))
        seen, info = transition.next_observation, taken.next_info
        ended = transition.is_last
    return FinishedTrial(_trial_record(presented, first_info, actions), tuple(actions))


def _holding(info: Info) -> int:
    """0 none, 1 left, 2 right."""
    return HOLDINGS.index(info["holding"])


def _allowed_after(taken: _Taken, rule: FailedActionRule) -> NDArray[np.bool_]:
    """(6,): what may be chosen next, by supervisor and rule."""
    before, after = _holding(taken.info), _holding(taken.next_info)
    rule.note(before, taken.choice.action, after, bool(taken.next_info["inserted"]))
    return rule.remaining(after, taken.next_info["action_mask"])


def _transition(
    seen: Observation, taken: _Taken, allowed: NDArray[np.bool_]
) -> Transition:
    """What the learner is told of an action.

    Args:
        seen: what was observed before it.
        taken: the action.
        allowed: (6,), what may be chosen next.
    """
    return Transition(
        seen,
        taken.choice.action,
        taken.reward,
        Observation.of(taken.features, seen.orientation),
        taken.terminated,
        taken.truncated,
        allowed,
    )


def _action_record(trial: int, step: int, taken: _Taken) -> ActionRecord:
    choice, outcome = taken.choice, taken.next_info
    return ActionRecord(
        trial=trial,
        step=step,
        action=choice.action,
        action_name=ACTION_NAMES[choice.action],
        explored=choice.explored,
        holding=str(taken.info["holding"]),
        q_values=tuple(choice.q_values.tolist()),
        executed=bool(outcome["executed"]),
        result=str(outcome["result"]),
        next_holding=str(outcome["holding"]),
        reward=float(taken.reward),
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
