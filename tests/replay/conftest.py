"""One trial of each strategy, watched once for all tests of what is made of it."""

import os

import numpy as np
import pytest
from strategies import STRATEGIES, story_of

from prospect_mj.episodes.recorder import WatchedTask
from prospect_mj.replay.rerun_export import export
from prospect_mj.replay.screenshot import photograph
from prospect_mj.task.pick_place import PickPlaceTask


@pytest.fixture(scope="session")
def strategies():
    with WatchedTask(PickPlaceTask()) as task:
        episodes = {}
        for name, actions in STRATEGIES.items():
            task.reset("left", np.random.default_rng(3))
            for action in actions:
                task.execute(action)
            episodes[name] = task.episode()
        return episodes


@pytest.fixture(scope="session")
def late(strategies):
    return strategies["late"]


@pytest.fixture(scope="session")
def exported(strategies, tmp_path_factory):
    folder = tmp_path_factory.mktemp("replay")
    files = {name: folder / f"{name}.rrd" for name in strategies}
    for name, path in files.items():
        export(strategies[name], story_of(name, strategies[name]), path)
    return files


@pytest.fixture(scope="session")
def picture(exported, tmp_path_factory):
    """The file of a screenshot; where the viewer can't draw tests are skipped loudly.

    Where CI=true they fail instead.
    """
    try:
        picture = tmp_path_factory.mktemp("look") / "late.png"
        photograph(exported["late"], picture, seconds=12.6)
    except ChildProcessError as error:
        if "graphics driver" not in str(error) or os.environ.get("CI") == "true":
            raise
        pytest.skip(f"needs Vulkan: {error}")
    return picture
