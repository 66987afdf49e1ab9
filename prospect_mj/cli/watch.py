"""The command line for watching actions, in MuJoCo's viewer or as a video."""

import os
import sys
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import AbstractContextManager, contextmanager
from dataclasses import dataclass
from pathlib import Path

import cv2
import mujoco
import mujoco.viewer
import numpy as np

from prospect_mj.actions.action import Action
from prospect_mj.cli import command_line
from prospect_mj.errors import InvalidChoice, InvalidValue
from prospect_mj.sim import overview
from prospect_mj.task.pick_place import PickPlaceTask
from prospect_mj.task.presentation import Orientation

FRAME_RATE = 25.0
SIZE = (480, 854)
"""Rows and columns of a video [pixels]."""

Observer = Callable[[mujoco.MjData], None]


@dataclass(frozen=True)
class WatchOptions:
    """Watch a sequence of actions on one presentation of the jar."""

    lid: Orientation = "left"
    """The side on which the lid lies."""
    actions: tuple[str, ...] = ("grasp-right", "swap-right-to-left", "insert-left")
    """Any of grasp-left, grasp-right, swap-left-to-right, swap-right-to-left,
    insert-left, insert-right, as often as you like."""
    seed: int = 0
    """Of the presentation."""
    video: Path | None = None
    """MP4 file to write instead of opening a window; it must not exist."""

    def __post_init__(self) -> None:
        """Refuse actions that do not exist and files that do."""
        labels = [action.label for action in Action]
        for name in self.actions:
            if name not in labels:
                raise InvalidChoice("action", name, labels)
        if self.seed < 0:
            raise InvalidValue("seed", self.seed, "0 or more")
        if self.video is not None and self.video.exists():
            raise InvalidValue("video", str(self.video), "a file that does not exist")


def main(argv: Sequence[str] | None = None) -> int:
    """Show what the command line asks for.

    Returns:
        The exit code: 0, or 2 for input that can't be used.
    """
    arguments = sys.argv[1:] if argv is None else argv

    def watch() -> None:
        options = command_line.parse(
            WatchOptions, arguments, WatchOptions(), "watch.py"
        )
        _watch(options)

    return command_line.run(watch)


def _watch(options: WatchOptions) -> None:
    displays = (os.environ.get(name) for name in ("DISPLAY", "WAYLAND_DISPLAY"))
    if options.video is None and sys.platform == "linux" and not any(displays):
        raise InvalidValue("--video", None, "a file, as there is no display")
    chosen = {action.label: action for action in Action}
    with PickPlaceTask() as task:
        task.reset(options.lid, np.random.default_rng(options.seed))
        with _screen(options.video, task) as observer:
            task.simulation.observer = observer
            for name in options.actions:
                outcome = task.execute(chosen[name])
                print(f"{name}: {outcome.result}, {outcome.sim_seconds:.1f} s")


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

    with mujoco.Renderer(model, *SIZE) as renderer:
        yield shoot
    writer.release()
