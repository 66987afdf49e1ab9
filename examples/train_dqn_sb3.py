"""Stable-Baselines3's DQN on recorded physics."""

import sys
from dataclasses import dataclass

import gymnasium
import torch
from comparison import check, report
from stable_baselines3 import DQN
from stable_baselines3.common.monitor import Monitor

import prospect_mj  # noqa: F401  (registers the environment)
from prospect_mj.cli import command_line


@dataclass(frozen=True)
class Options:
    """Train DQN and print what it has reached."""

    steps: int = 10_000
    """Actions in all."""
    seed: int = 0
    """Of network, exploration and presentations."""

    def __post_init__(self) -> None:
        """Refuse numbers that can't be."""
        check(self)


def train(options: Options) -> list[int]:
    """Let DQN learn; actions of each trial."""
    torch.set_num_threads(1)  # For so small a network more are slower.
    env = Monitor(gymnasium.make("prospect_mj/PickPlace-v0", physics="recorded"))
    agent = DQN(
        "MlpPolicy",
        env,
        learning_rate=1e-3,
        buffer_size=20_000,
        learning_starts=500,
        target_update_interval=250,
        exploration_fraction=0.3,
        seed=options.seed,
        device="cpu",
        policy_kwargs={"net_arch": [64, 64]},
    )
    agent.learn(options.steps, progress_bar=False)
    return env.get_episode_lengths()


def main(options: Options) -> None:
    """Train, and print what came of it."""
    print(report("DQN", train(options), options.seed))


if __name__ == "__main__":
    sys.exit(command_line.main(main, Options(), "train_dqn_sb3.py"))
