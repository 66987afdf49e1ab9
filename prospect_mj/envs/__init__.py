"""Gymnasium environments; importing `prospect_mj` registers them."""

from gymnasium.envs.registration import register, registry

ENV_ID = "prospect_mj/PickPlace-v0"


def register_envs() -> None:
    """Register the environments, once."""
    if ENV_ID not in registry:
        register(
            id=ENV_ID,
            entry_point="prospect_mj.envs.pick_place:PickPlaceEnv",
            vector_entry_point="prospect_mj.envs.vector:make_vector",
        )
