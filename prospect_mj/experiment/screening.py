"""Showing actions while they run: in MuJoCo's viewer, or into a video file."""

import time
from collections.abc import Callable, Iterable, Iterator
from contextlib import AbstractContextManager, ExitStack, contextmanager
from pathlib import Path

import cv2
import mujoco
import mujoco.viewer
import numpy as np

from prospect_mj.actions.action import Action, ActionOutcome
from prospect_mj.errors import InvalidValue
from prospect_mj.sim import overview
from prospect_mj.sim.offscreen import OffscreenRenderer
from prospect_mj.task.pick_place import PickPlaceTask
from prospect_mj.task.presentation import Orientation

FRAME_RATE = 25.0
"""[1/s]"""
SIZE = (480, 854)
"""Rows and columns of a video [pixels]."""

Observer = Callable[[mujoco.MjData], None]


def screen(
    lid: Orientation, actions: Iterable[Action], seed: int, video: Path | None
) -> Iterator[ActionOutcome]:
    """Run actions on one presentation and show them.

    Args:
        lid: the side on which the lid lies.
        actions: to run one after the other.
        seed: of the presentation.
        video: MP4 file to write; None opens MuJoCo's viewer.

    Yields:
        What each action did, when it has ended.
    """
    with PickPlaceTask() as task:
        task.reset(lid, np.random.default_rng(seed))
        with _screen(video, task) as observer:
            task.simulation.observer = observer
            for action in actions:
                yield task.execute(action)


def _screen(
    video: Path | None, task: PickPlaceTask
) -> AbstractContextManager[Observer]:
    simulation = task.simulation
    if video is None:
        return _window(simulation.model, simulation.data)
    return _film(video, simulation.model)


@contextmanager
def _window(model: mujoco.MjModel, data: mujoco.MjData) -> Iterator[Observer]:
    """MuJoCo's viewer, kept at real time."""
    with mujoco.viewer.launch_passive(model, data) as viewer:
        start = time.monotonic() - data.time
        last = data.time

        def show(state: mujoco.MjData) -> None:
            nonlocal last
            if state.time - last >= 1 / FRAME_RATE:
                last = state.time
                viewer.sync()
                time.sleep(max(0.0, start + state.time - time.monotonic()))

        yield show


@contextmanager
def _film(path: Path, model: mujoco.MjModel) -> Iterator[Observer]:
    """A video file that plays at real time."""
    overview.light_for_people(model, SIZE)
    camera = overview.camera()
    codec = cv2.VideoWriter.fourcc(*"mp4v")
    writer = cv2.VideoWriter(str(path), codec, FRAME_RATE, SIZE[::-1])
    last = 0.0

    def shoot(state: mujoco.MjData) -> None:
        nonlocal last
        if state.time - last >= 1 / FRAME_RATE:
            last = state.time
            renderer.update_scene(state, camera)
            writer.write(cv2.cvtColor(renderer.render(), cv2.COLOR_RGB2BGR))

    if not writer.isOpened():
        raise InvalidValue("--video", str(path), "a file that can be written")
    with ExitStack() as stack:
        stack.callback(writer.release)
        renderer = stack.enter_context(OffscreenRenderer(model, *SIZE))
        yield shoot
