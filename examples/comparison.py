"""What the other examples are held against: the paper's learner on the same trials."""

import numpy as np

from prospect_mj.agent import LinearQ, Observation, Transition
from prospect_mj.checks import check_integer
from prospect_mj.envs.pick_place import PickPlaceEnv

OPTIMUM = 2
"""Actions of a trial: a grasp with the hand on the lid's side, and an insertion."""
LAST = 100
"""Trials that a mean is taken over."""

_MOST = 1_000_000_000
"""Of any option; torch and NumPy know no seed from 2^32 on."""


def check(options: object) -> None:
    """Refuse an example's options, whole numbers all, that can't be.

    Raises:
        InvalidValue: that names the option.
    """
    for name, number in vars(options).items():
        check_integer(f"--{name}", number, 0 if name == "seed" else 1, _MOST)


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
        seen, ended, n_actions = Observation.of(features), False, 0
        while not ended:
            action = learner.select(seen, rng).action
            features, reward, *ends, info = env.step(action)
            after = Observation.of(features)
            step = Transition(seen, action, reward, after, *ends, info["action_mask"])
            learner.update(step, rng)
            seen, ended, n_actions = after, step.is_last, n_actions + 1
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
