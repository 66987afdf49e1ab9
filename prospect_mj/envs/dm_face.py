"""The environment as those of dm_control are: a `dm_env.Environment`."""

from typing import Any

import dm_env
import numpy as np
from dm_env import specs
from gymnasium import spaces
from numpy.typing import NDArray

from prospect_mj.checks import check_integer
from prospect_mj.envs.observation import FEATURES
from prospect_mj.envs.pick_place import PickPlaceEnv
from prospect_mj.envs.settings import PickPlaceSettings
from prospect_mj.recording.config import LARGEST_SEED

ACTION_MASK = "action_mask"


class PickPlaceDmEnv(dm_env.Environment):
    """`PickPlaceEnv` in dm_env's terms: time steps, discounts and named specs.

    An observation is a dictionary of the `features`, the `action_mask` (6,) and,
    if they are asked for, `left_image` and `right_image`. The discount is 0 where the
    jar was inserted, and 1 everywhere else: also where a trial was cut off.

    Args:
        settings: all settings; None for the defaults.
        seed: of everything that is drawn; None is another one each time.
        changes: single settings by name, such as `physics="recorded"`.

    Attributes:
        env: the environment beneath; `env.model` and `env.data` are MuJoCo's.
        info: what it told with the last time step.
    """

    def __init__(
        self,
        settings: PickPlaceSettings | None = None,
        seed: int | None = None,
        **changes: Any,  # noqa: ANN401
    ) -> None:
        """Make the environment beneath; the first step or reset begins a trial.

        Raises:
            InvalidValue: if the seed is no number from 0.
        """
        if seed is not None:
            check_integer("seed", seed, 0, LARGEST_SEED)
        self.env = PickPlaceEnv(settings, **changes)
        self.info: dict[str, Any] = {}
        self._seed = seed
        self._ended = True

    def reset(self) -> dm_env.TimeStep:
        """Present the jar and look at it."""
        # Only once: from then on the generator goes on.
        seed, self._seed = self._seed, None
        seen, self.info = self.env.reset(seed=seed)
        self._ended = False
        return dm_env.restart(self._named(seen))

    def step(self, action: int | NDArray[np.integer]) -> dm_env.TimeStep:
        """Run one of the six actions; after the last time step, begin anew instead.

        Raises:
            InvalidChoice: if there is no such action.
        """
        if self._ended:
            return self.reset()
        seen, reward, terminated, truncated, self.info = self.env.step(action)
        self._ended = terminated or truncated
        if terminated:
            return dm_env.termination(reward, self._named(seen))
        ends = dm_env.truncation if truncated else dm_env.transition
        return ends(reward, self._named(seen), discount=1.0)

    def _named(self, seen: Any) -> dict[str, NDArray[np.generic]]:  # noqa: ANN401
        named = seen if isinstance(seen, dict) else {FEATURES: seen}
        return {**named, ACTION_MASK: self.info[ACTION_MASK]}

    def observation_spec(self) -> dict[str, specs.BoundedArray]:
        """Bounds of all that is observed, by name."""
        space = self.env.observation_space
        parts = space if isinstance(space, spaces.Dict) else {FEATURES: space}
        seen = {
            name: specs.BoundedArray(box.shape, box.dtype, box.low, box.high, name)
            for name, box in parts.items()
        }
        shape = (int(self.env.action_space.n),)
        mask = specs.BoundedArray(shape, np.int8, 0, 1, ACTION_MASK)
        return {**seen, ACTION_MASK: mask}

    def action_spec(self) -> specs.DiscreteArray:
        """One of the six actions."""
        return specs.DiscreteArray(int(self.env.action_space.n), name="action")

    def reward_spec(self) -> specs.Array:
        """-1 for every action."""
        return specs.Array((), np.float64, "reward")

    def close(self) -> None:
        """Close the environment beneath."""
        self.env.close()
