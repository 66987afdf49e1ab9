"""The environment as the training sees it, and the one that is registered."""

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np
from numpy.typing import NDArray

from prospect_mj.envs.pick_place import PickPlaceEnv
from prospect_mj.envs.settings import PickPlaceSettings
from prospect_mj.experiment.run.config import TrainConfig

if TYPE_CHECKING:
    from prospect_mj.episodes.recorder import WatchedTask

Info = Mapping[str, Any]


class Environment(Protocol):
    """What the training needs of a Gymnasium environment (see `PickPlace-v0`)."""

    def reset(
        self, *, seed: int, options: dict[str, Any]
    ) -> tuple[NDArray[np.float64], Info]:
        """Present the jar: `orientation` is the side of the lid, `trial` its number."""
        ...

    def step(self, action: int) -> tuple[NDArray[np.float64], float, bool, bool, Info]:
        """Try one action: features, reward, terminated, truncated, info."""
        ...

    def watch(self) -> "WatchedTask":
        """Remember every trial from now on."""
        ...

    def close(self) -> None:
        """Release what the environment holds."""
        ...


MakeEnvironment = Callable[[TrainConfig], Environment]


def make_environment(config: TrainConfig) -> Environment:
    """Make the environment that `config` asks for.

    Raises:
        ProspectError: if a model file is missing, nothing can be rendered, or the
            recording can't be used.
    """
    settings = PickPlaceSettings(
        physics=config.physics,
        recording=None if config.recording is None else Path(config.recording),
        grow=config.grow,
        supervisor=config.supervisor,
        shaping=config.shaping,
        object_pose=config.object_pose,
        gross_motion=config.gross_motion,
        grid_cells=config.grid_cells,
        world=config.world,
        max_actions=config.max_actions,
        features=config.features,
        haptic_models=config.haptic_models,
    )
    return PickPlaceEnv(settings)
