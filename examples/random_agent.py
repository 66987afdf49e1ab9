"""An agent that chooses at random, from all actions and from those that are of use."""

import sys
from dataclasses import dataclass

import gymnasium
import numpy as np
from comparison import check, report

import prospect_mj  # noqa: F401  (registers the environment)
from prospect_mj.cli import command_line


@dataclass(frozen=True)
class Options:
    """Choose at random on recorded physics, and say how many actions that takes."""

    trials: int = 1000
    """How many."""
    seed: int = 0
    """Of presentations and choices."""

    def __post_init__(self) -> None:
        """Refuse numbers that can't be."""
        check(self)


def play(options: Options, supervisor: str) -> list[int]:
    """Actions of each trial, chosen from what a mode of the supervisor offers."""
    env = gymnasium.make(
        "prospect_mj/PickPlace-v0", physics="recorded", supervisor=supervisor
    )
    env.action_space.seed(options.seed)
    lengths = []
    for trial in range(options.trials):
        _, info = env.reset(seed=options.seed if trial == 0 else None)
        ended, n_actions = False, 0
        while not ended:
            action = env.action_space.sample(mask=info["action_mask"])
            _, _, terminated, truncated, info = env.step(action)
            ended, n_actions = terminated or truncated, n_actions + 1
        lengths.append(n_actions)
    return lengths


def main(options: Options) -> None:
    """Play in two modes of the supervisor, and print what came of it."""
    useful = play(options, supervisor="productive")
    print(f"chosen from the actions that are of use: {np.mean(useful):.2f} actions")
    print(report("random agent", play(options, supervisor="none"), options.seed))


if __name__ == "__main__":
    sys.exit(command_line.main(main, Options(), "random_agent.py"))
