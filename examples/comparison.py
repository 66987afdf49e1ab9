"""What the other examples are held against: the paper's learner on the same trials."""

import sys
from typing import TypeVar

import numpy as np
import tyro

from prospect_mj.agent import LinearQ
from prospect_mj.envs.pick_place import PickPlaceEnv

OPTIMUM = 2
"""Actions of a trial: a grasp with the hand on the lid's side, and an insertion."""
LAST = 100
"""Trials that a mean is taken over."""

_Options = TypeVar("_Options")


def read(options: type[_Options]) -> _Options:
    """The options of the command line, whole numbers all; one line if one can't be."""
    given = tyro.cli(options)
    for name, number in vars(given).items():
        least = 0 if name == "seed" else 1
        if number < least:
            words = f"error: --{name} is {number}; expected a number from {least}"
            print(words, file=sys.stderr)
            sys.exit(2)
    return given


def paper_learner(trials: int, seed: int) -> list[int]:
    """Let the paper's linear Q-learner learn.

    Args:
        trials: how many.
        seed: of weights, exploration and presentations.

    Returns:
        Actions of each trial.
    """
    env, rng = PickPlaceEnv(physics="recorded"), np.random.default_rng(seed)
    learner, lengths = LinearQ(rng=rng), []
    for trial in range(trials):
        features, _ = env.reset(seed=seed if trial == 0 else None)
        ended, n_actions = False, 0
        while not ended:
            action = learner.select(features, rng)
            after, reward, terminated, truncated, _ = env.step(action)
            learner.update(features, action, reward, after, terminated)
            features, ended, n_actions = after, terminated or truncated, n_actions + 1
        lengths.append(n_actions)
    return lengths


def report(name: str, lengths: list[int], seed: int) -> str:
    """How an agent did, beside the optimum and the paper's learner.

    Args:
        name: of the agent.
        lengths: actions of each of its trials.
        seed: of the paper's learner, which gets as many trials.
    """
    others = paper_learner(len(lengths), seed)
    return (
        f"mean actions of the last {min(LAST, len(lengths))} of {len(lengths)} trials: "
        f"{name} {np.mean(lengths[-LAST:]):.2f}, the paper's learner "
        f"{np.mean(others[-LAST:]):.2f}, optimum {OPTIMUM}"
    )
