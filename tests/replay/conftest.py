"""A late correction, watched once for all tests of what is made of it."""

import numpy as np
import pytest

from prospect_mj.actions.action import Action
from prospect_mj.episodes.recorder import WatchedTask
from prospect_mj.task.pick_place import PickPlaceTask

LATE = (
    Action.GRASP_RIGHT,
    Action.INSERT_RIGHT,
    Action.SWAP_RIGHT_TO_LEFT,
    Action.INSERT_LEFT,
)


@pytest.fixture(scope="session")
def late():
    with WatchedTask(PickPlaceTask()) as task:
        task.reset("left", np.random.default_rng(3))
        for action in LATE:
            task.execute(action)
        return task.episode()
