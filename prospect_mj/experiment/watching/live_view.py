"""Playing actions on the live scene while somebody looks on, in MuJoCo's viewer."""

import time
from collections.abc import Iterator
from pathlib import Path

import mujoco
import numpy as np

from prospect_mj.actions.action import ActionOutcome
from prospect_mj.episodes.recorder import WatchedTask
from prospect_mj.experiment.watching.shown import Shown
from prospect_mj.recording.config import RecordingConfig
from prospect_mj.recording.grower import task_settings
from prospect_mj.replay.video import film
from prospect_mj.sim import overview
from prospect_mj.task.pick_place import PickPlaceTask, TaskSettings
from prospect_mj.viewer import Viewer

FRAME_RATE = 60.0
"""Pictures that a window shows [1/s]."""
SIZE = (480, 854)
"""Rows and columns of the largest picture that can be taken in it [pixels]."""
_LATE = 0.25
"""Off by more than this, as after a long plan was made, the clock starts anew [s]."""


class WindowClosed(Exception):
    """The user closed the window: there is nobody to show anything to."""


def in_window(shown: Shown) -> Iterator[ActionOutcome | None]:
    """Play in MuJoCo's viewer; the window stays open until the user closes it.

    Args:
        shown: what.

    Yields:
        What each action did, when it has ended; then None, as all that is left is
        to look at what came of it. Both end early with the window.
    """
    with PickPlaceTask(_settings(shown)) as task:
        task.reset(shown.lid, np.random.default_rng(shown.seed))
        simulation = task.simulation
        # Only now: the eyes have looked by their own light.
        overview.light_for_people(simulation.model, SIZE)
        with Viewer(simulation.model, simulation.data) as viewer:
            pace = simulation.observer = Pace(viewer, shown.speed)
            try:
                for number, action in enumerate(shown.actions, start=1):
                    viewer.caption(f"{number}. {action.label}")
                    yield task.execute(action)
                viewer.caption("done")
                yield None
                pace.rest()
            except WindowClosed:
                return


def in_film(shown: Shown, path: Path) -> Iterator[ActionOutcome]:
    """Play, and film it: the same as for an episode of a run.

    Args:
        shown: what; its speed is of no concern.
        path: MP4 file to write, once all actions have ended.

    Yields:
        What each action did, when it has ended.
    """
    with WatchedTask(PickPlaceTask(_settings(shown))) as task:
        task.reset(shown.lid, np.random.default_rng(shown.seed))
        for action in shown.actions:
            yield task.execute(action)
        episode = task.episode()
    film(episode, path)


def _settings(shown: Shown) -> TaskSettings:
    """Those of its world."""
    return task_settings(RecordingConfig(world=shown.world))


class Pace:
    """Holds the physics to the clock of who looks on, and the window up to date."""

    def __init__(self, viewer: Viewer, speed: float) -> None:
        """Its clock starts with the first step."""
        self._viewer, self._speed = viewer, speed
        self._last = self._start = -np.inf

    def __call__(self, data: mujoco.MjData) -> None:
        """After a step of the physics: wait for the clock, and show it."""
        # In its window the user can also set the clock back to zero.
        if 0 <= data.time - self._last < self._speed / FRAME_RATE:
            return
        self._last = data.time
        shown, now = data.time / self._speed, time.monotonic()
        if abs(self._start + shown - now) > _LATE:
            self._start = now - shown
        self._show()
        time.sleep(max(0.0, self._start + shown - time.monotonic()))

    def rest(self) -> None:
        """Show what is there for as long as anybody looks."""
        while True:
            self._show()
            time.sleep(1.0 / FRAME_RATE)

    def _show(self) -> None:
        if not self._viewer.is_open:
            raise WindowClosed
        self._viewer.sync()
