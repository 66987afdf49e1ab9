"""What the tests of every kind of environment ask."""

import warnings
from contextlib import closing

import gymnasium
import pytest
from gymnasium.utils.env_checker import check_env

import prospect_mj  # noqa: F401  (registers the environment)


@pytest.fixture
def gymnasiums_check():
    """Gymnasium's own check of an environment with given settings; a warning fails."""

    def check(skip_render_check=False, **settings):
        with (
            closing(gymnasium.make("prospect_mj/PickPlace-v0", **settings)) as made,
            warnings.catch_warnings(),
        ):
            warnings.simplefilter("error")
            check_env(made.unwrapped, skip_render_check=skip_render_check)

    return check
