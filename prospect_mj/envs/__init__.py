"""Gymnasium environments; importing this package registers them."""

from gymnasium.envs.registration import register

ENV_ID = "prospect_mj/PickPlace-v0"

register(id=ENV_ID, entry_point="prospect_mj.envs.pick_place:PickPlaceEnv")
