"""Gymnasium environments; importing `prospect_mj` registers them."""

from typing import Any

import gymnasium
from gymnasium.envs.registration import register, registry

from prospect_mj.sim import gl

ENV_ID = "prospect_mj/PickPlace-v0"


def register_envs() -> None:
    """Register the environments, once."""
    if ENV_ID not in registry:
        register(id=ENV_ID, entry_point="prospect_mj.envs:make_pick_place")


def make_pick_place(**kwargs: Any) -> gymnasium.Env:  # noqa: ANN401
    """Make a `PickPlaceEnv`.

    Raises:
        RenderingUnavailable: if there is no OpenGL; MuJoCo's and dm_control's imports
            would fail, each in its own words.
    """
    gl.require_gl()
    from prospect_mj.envs.pick_place import PickPlaceEnv

    return PickPlaceEnv(**kwargs)
