"""MuJoCo's own viewer in a window, which closes without taking the process down."""

import atexit
import signal
import threading
from collections.abc import Iterator
from contextlib import AbstractContextManager, contextmanager

import mujoco
import mujoco.viewer

from prospect_mj.closing import Closing
from prospect_mj.sim import overview

_PATIENCE = 10.0
"""For the viewer's thread to end [s]."""


class Viewer(Closing):
    """A window on a model and its state, from where people like to look.

    Ask `display.require_display` first: where no window can be opened, MuJoCo waits for
    ever for one.
    """

    def __init__(self, model: mujoco.MjModel, data: mujoco.MjData) -> None:
        """Open the window.

        Args:
            model: the scene, by the light in which it is to be shown.
            data: what is shown, at each `sync`; who pulls at something with the mouse
                changes the forces in it.
        """
        before = set(threading.enumerate())
        try:
            with _uninterrupted():
                self._handle = mujoco.viewer.launch_passive(
                    model, data, show_left_ui=False, show_right_ui=False
                )
                self._threads = set(threading.enumerate()) - before
                self._look_from(overview.camera())
        except KeyboardInterrupt:
            self.close()
            raise
        atexit.register(self.close)

    def _look_from(self, view: mujoco.MjvCamera) -> None:
        with self._handle.lock():
            camera = self._handle.cam
            camera.lookat[:] = view.lookat
            camera.distance, camera.azimuth = view.distance, view.azimuth
            camera.elevation = view.elevation

    @property
    def is_open(self) -> bool:
        """Whether the user has not closed it."""
        return self._handle.is_running()

    def caption(self, words: str) -> None:
        """Write words into the upper left corner, in place of those before."""
        font = mujoco.mjtFontScale.mjFONTSCALE_150
        corner = mujoco.mjtGridPos.mjGRID_TOPLEFT
        self._handle.set_texts((font, corner, words, ""))

    def lock(self) -> AbstractContextManager[object]:
        """Hold it while the state is changed by others than the physics."""
        return self._handle.lock()

    def sync(self) -> None:
        """Show the state as it is now."""
        self._handle.sync()

    def close(self) -> None:
        """Close the window; closing again does nothing."""
        with _uninterrupted():
            self._handle.close()
            # At its end the process ends GLFW, on which the viewer's thread must not
            # be at work any more.
            for thread in self._threads:
                thread.join(_PATIENCE)
        atexit.unregister(self.close)


@contextmanager
def _uninterrupted() -> Iterator[None]:
    """Ctrl-C waits: a window that half stands would take the process down."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    pressed: list[int] = []
    usual = signal.signal(signal.SIGINT, lambda number, frame: pressed.append(number))
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, usual)
    if pressed:
        signal.raise_signal(signal.SIGINT)
