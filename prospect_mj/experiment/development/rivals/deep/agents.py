"""Stable-Baselines3's DQN and sb3-contrib's MaskablePPO on recorded physics.

The networks are of two layers of 64 units, on the 303 features of the paper's learner;
all else that isn't set here is the libraries' default. Nothing was tuned.
"""

from dataclasses import dataclass
from importlib.util import find_spec
from itertools import accumulate
from math import ceil
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from prospect_mj.checks import check_choice, check_integer
from prospect_mj.envs.pick_place import PickPlaceEnv
from prospect_mj.envs.settings import PickPlaceSettings
from prospect_mj.errors import MissingPackage
from prospect_mj.experiment.development.rivals.settings import (
    DEEP,
    DQN_CONSTANT,
    MASKABLE_PPO,
    MASKED,
)

EXTRA = "rivals"
"""Of this package; it brings the libraries."""
PACKAGES = {
    "torch": "torch",
    "stable_baselines3": "stable-baselines3",
    "sb3_contrib": "sb3-contrib",
}
"""Module and package of each library that the deep learners need."""

ANNEALED = 3000
"""Actions in which epsilon falls from 1 to its last value."""
EPSILON = 0.05
"""Its last value, that of the paper's learner; the constant one throughout."""

_ENVS = 8
_NETWORK = {"net_arch": [64, 64]}
_LARGEST_SEED = 2**32 - 1


@dataclass(frozen=True)
class DeepRun:
    """One run of a deep learner."""

    agent: str
    """Of `settings.DEEP`."""
    trials: int
    seed: int
    """Of networks, exploration and presentations."""
    recording: Path | None = None
    """Folder of the recording; None is the one that comes with the package."""
    max_actions: int = 10
    """A trial is cut off after so many."""

    def __post_init__(self) -> None:
        """Refuse what is no run."""
        check_choice("deep learner", self.agent, DEEP)
        check_integer("trials", self.trials, 1, 1_000_000)
        check_integer("seed", self.seed, 0, _LARGEST_SEED)

    @property
    def steps(self) -> int:
        """The most actions that it can take."""
        return self.trials * self.max_actions


def check_installed() -> None:
    """Refuse to begin without the libraries.

    Raises:
        MissingPackage: that names the first one that is missing.
    """
    for module, package in PACKAGES.items():
        if find_spec(module) is None:
            raise MissingPackage(package, EXTRA)


def train(run: DeepRun) -> NDArray[np.int16]:
    """Let a deep learner learn.

    Args:
        run: which, and for how long.

    Returns:
        (n_trials,) [actions] of each trial, in the order of their ends.

    Raises:
        MissingPackage: if a library is not installed.
        RecordingError: if the recording can't be had.
    """
    check_installed()
    import torch

    torch.set_num_threads(1)  # For so small a network more are slower.
    lengths = _ppo(run) if run.agent == MASKABLE_PPO else _dqn(run)
    return np.array(lengths[: run.trials], np.int16)


def _environment(run: DeepRun) -> Any:  # noqa: ANN401
    """Trials that are counted."""
    from stable_baselines3.common.monitor import Monitor

    settings = PickPlaceSettings(
        physics="recorded",
        recording=run.recording,
        supervisor="productive" if run.agent in MASKED else "none",
        max_actions=run.max_actions,
    )
    return Monitor(PickPlaceEnv(settings))


def _dqn(run: DeepRun) -> list[int]:
    from stable_baselines3 import DQN

    constant = run.agent == DQN_CONSTANT
    env = _environment(run)
    agent = DQN(
        "MlpPolicy",
        env,
        learning_rate=1e-3,
        buffer_size=20_000,
        learning_starts=100,
        target_update_interval=250,
        exploration_initial_eps=EPSILON if constant else 1.0,
        exploration_final_eps=EPSILON,
        exploration_fraction=min(1.0, ANNEALED / run.steps),
        seed=run.seed,
        device="cpu",
        policy_kwargs=_NETWORK,
    )
    _learn(agent, run.steps, run.trials)
    return env.get_episode_lengths()


def _ppo(run: DeepRun) -> list[int]:
    from sb3_contrib import MaskablePPO
    from stable_baselines3.common.vec_env import DummyVecEnv

    envs = DummyVecEnv([lambda: _environment(run)] * _ENVS)
    agent = MaskablePPO(
        "MlpPolicy",
        envs,
        learning_rate=1e-3,
        n_steps=64,
        batch_size=128,
        n_epochs=5,
        seed=run.seed,
        device="cpu",
        policy_kwargs=_NETWORK,
    )
    _learn(agent, run.steps, ceil(run.trials / _ENVS))
    # All step at once, so that a trial ends after all the actions of its environment.
    ended = [
        trial
        for lengths in envs.env_method("get_episode_lengths")
        for trial in zip(accumulate(lengths), lengths, strict=True)
    ]
    return [length for _, length in sorted(ended)]


def _learn(agent: Any, steps: int, trials: int) -> None:  # noqa: ANN401
    """Learn till so many trials of each environment have ended, or of so many steps."""
    from stable_baselines3.common.callbacks import StopTrainingOnMaxEpisodes
    from stable_baselines3.common.logger import Logger

    # The usual logger makes a folder among the temporary files, and leaves it there.
    agent.set_logger(Logger(folder=None, output_formats=[]))
    agent.learn(steps, callback=StopTrainingOnMaxEpisodes(trials))
