"""sb3-contrib's MaskablePPO on recorded physics: it chooses from `action_masks()`.

The supervisor's mode `productive` masks what can change nothing, such as an insertion
with an empty hand.
"""

import sys
from dataclasses import dataclass
from itertools import accumulate

import torch
from comparison import check, report
from sb3_contrib import MaskablePPO
from stable_baselines3.common.env_util import make_vec_env

import prospect_mj  # noqa: F401  (registers the environment)
from prospect_mj.cli import command_line

ENVS = 8


@dataclass(frozen=True)
class Options:
    """Train MaskablePPO and print what it has reached."""

    steps: int = 10_000
    """Actions in all."""
    seed: int = 0
    """Of networks, exploration and presentations."""

    def __post_init__(self) -> None:
        """Refuse numbers that can't be."""
        check(self)


def train(options: Options) -> list[int]:
    """Let MaskablePPO learn; actions of each trial, in the order of their ends."""
    torch.set_num_threads(1)  # For so small a network more are slower.
    settings = {"physics": "recorded", "supervisor": "productive"}
    envs = make_vec_env(
        "prospect_mj/PickPlace-v0", ENVS, seed=options.seed, env_kwargs=settings
    )
    agent = MaskablePPO(
        "MlpPolicy",
        envs,
        learning_rate=1e-3,
        n_steps=64,
        batch_size=128,
        n_epochs=5,
        seed=options.seed,
        device="cpu",
        policy_kwargs={"net_arch": [64, 64]},
    )
    agent.learn(options.steps, progress_bar=False)
    # All step at once, so that a trial ends after all the actions of its environment.
    ended = [
        trial
        for lengths in envs.env_method("get_episode_lengths")
        for trial in zip(accumulate(lengths), lengths, strict=True)
    ]
    return [length for _, length in sorted(ended)]


def main(options: Options) -> None:
    """Train, and print what came of it."""
    print(report("MaskablePPO", train(options), options.seed))


if __name__ == "__main__":
    sys.exit(command_line.main(main, Options(), "train_maskable_ppo.py"))
