"""MuJoCo's viewer on the live scene, at real time while an action runs."""

import copy
import time

import mujoco

from prospect_mj.closing import Closing
from prospect_mj.envs.pictures import Clock
from prospect_mj.sim import overview
from prospect_mj.sim.simulation import Simulation
from prospect_mj.viewer import Viewer


class Window(Closing):
    """Shows what happens; closing the window ends the showing, not the trial.

    It shows a copy: who turns the camera or pulls at the jar changes nothing.

    Args:
        simulation: the live physics; its observer is this one's.
        size: rows and columns of the largest picture to take in it [pixels].
    """

    def __init__(self, simulation: Simulation, size: tuple[int, int]) -> None:
        """Open the window; whether there is a display was asked before."""
        self._simulation = simulation
        self._model = copy.copy(simulation.model)
        self._data = copy.copy(simulation.data)
        overview.light_for_people(self._model, size)
        self._viewer = Viewer(self._model, self._data)
        self._clock, self._start = Clock(), 0.0
        simulation.observer = self._watch

    def begin(self) -> None:
        """Show the jar as it is presented, and let real time begin with it."""
        now = self._simulation.data.time
        self._clock.restart(now)
        self._start = time.monotonic() - now
        self.render()

    def _watch(self, data: mujoco.MjData) -> None:
        if not self._viewer.is_open or not self._clock.is_due(data.time):
            return
        self.render()
        ahead = self._start + data.time - time.monotonic()
        if ahead < 0:
            # What the agent or a planner thought about is not caught up with.
            self._start -= ahead
        time.sleep(max(0.0, ahead))

    def render(self) -> None:
        """Show the scene now."""
        with self._viewer.lock():
            mujoco.mj_copyData(self._data, self._model, self._simulation.data)
        self._viewer.sync()

    def close(self) -> None:
        """Close the window; closing again does nothing."""
        self._simulation.observer = None
        self._viewer.close()
