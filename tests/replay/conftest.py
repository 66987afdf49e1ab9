"""Trials of each strategy, watched once for all tests of what is made of them.

What takes seconds to make is made once for all processes of pytest-xdist, when the
first test asks for it, and read by the others from the folder that they share.
"""

import os

import numpy as np
import pytest
from filelock import FileLock
from strategies import STRATEGIES, story_of

from prospect_mj.episodes import episode_file
from prospect_mj.episodes.recorder import WatchedTask
from prospect_mj.replay.rerun_export import export
from prospect_mj.replay.screenshot import photograph
from prospect_mj.task.pick_place import PickPlaceTask


class Lazily(dict):
    """By strategy what `make` makes of its name, when it is asked for."""

    def __init__(self, make):
        super().__init__()
        self._make = make

    def __missing__(self, name):
        return self.setdefault(name, self._make(name))


@pytest.fixture(scope="session")
def shared(tmp_path_factory, worker_id):
    """A file by its name; whoever comes first makes it, and who comes next waits."""
    folder = tmp_path_factory.getbasetemp()
    if worker_id != "master":
        folder = folder.parent

    def made(name, make):
        path, unfinished = folder / name, folder / f"unfinished-{name}"
        with FileLock(folder / f"{name}.lock"):
            if not path.exists():
                make(unfinished)
                unfinished.replace(path)
        return path

    return made


@pytest.fixture(scope="session")
def task():
    with WatchedTask(PickPlaceTask()) as task:
        yield task


@pytest.fixture(scope="session")
def strategies(shared, request):
    def episode(name):
        def live(path):
            task = request.getfixturevalue("task")
            task.reset("left", np.random.default_rng(3))
            for action in STRATEGIES[name]:
                task.execute(action)
            episode_file.write(path, task.episode(), "no run")

        return episode_file.read(shared(f"{name}.npz", live))

    return Lazily(episode)


@pytest.fixture(scope="session")
def late(strategies):
    return strategies["late"]


@pytest.fixture(scope="session")
def exported(strategies, shared):
    def file(name):
        def exports(path):
            export(strategies[name], story_of(name, strategies[name]), path)

        return shared(f"{name}.rrd", exports)

    return Lazily(file)


@pytest.fixture(scope="session")
def picture(exported, shared):
    """The file of a screenshot; where the viewer can't draw tests are skipped loudly.

    Where CI=true they fail instead.
    """
    try:
        return shared(
            "late.png", lambda path: photograph(exported["late"], path, seconds=12.6)
        )
    except ChildProcessError as error:
        if "graphics driver" not in str(error) or os.environ.get("CI") == "true":
            raise
        pytest.skip(f"needs Vulkan: {error}")
