"""Pictures of the live scene for people: one at a time, or a film of an action.

They are rendered from copies of model and state, by daylight, so that neither what the
robot sees nor what happens to it changes.
"""

import atexit
import copy
import weakref
from typing import Protocol

import mujoco
import numpy as np

from prospect_mj.closing import Closing
from prospect_mj.envs.screens import FILM_RATE
from prospect_mj.episodes.states import rendered
from prospect_mj.sim import overview
from prospect_mj.sim.camera import Image
from prospect_mj.sim.offscreen import OffscreenRenderer
from prospect_mj.sim.simulation import Simulation


class Screen(Protocol):
    """Shows the live scene to people."""

    def begin(self) -> None:
        """A trial has begun."""
        ...

    def render(self) -> Image | list[Image] | None:
        """What Gymnasium's `render` returns."""
        ...

    def close(self) -> None:
        """Give back what is held."""
        ...


class Clock:
    """Tells when the next picture is due, in simulated time."""

    def __init__(self) -> None:
        """The first is due at once."""
        self._last = -np.inf

    def restart(self, now: float) -> None:
        """A picture was made now [s], at the beginning of a trial."""
        self._last = now

    def is_due(self, now: float) -> bool:
        """Whether a picture is due now [s]; it counts as made."""
        # Not a whole step late for want of the last bit.
        due = now - self._last >= 1 / FILM_RATE - 1e-9
        self._last = now if due else self._last
        return due


class Still(Closing):
    """Renders the scene as it is when it is asked to.

    Args:
        simulation: the live physics.
        size: rows and columns [pixels].
    """

    def __init__(self, simulation: Simulation, size: tuple[int, int]) -> None:
        """Copy the model before a trial has changed its lamp, and light it."""
        self._simulation, self._size = simulation, size
        self._model = copy.copy(simulation.model)
        overview.light_for_people(self._model, size)
        self._camera = overview.camera()
        self._renderer: OffscreenRenderer | None = None

    def begin(self) -> None:
        """Nothing is kept from trial to trial."""

    def render(self) -> Image:
        """The scene now (rows, columns, 3) RGB."""
        return self._pictures([self._simulation.save()])[0]

    def _pictures(self, states: list[np.ndarray]) -> list[Image]:
        """A picture of every state."""
        # Not before one is asked for: it holds memory, and much of it.
        if self._renderer is None:
            self._renderer = OffscreenRenderer(self._model, *self._size)
            # An environment that nobody closes gives it back when it is no longer used.
            self._give_back = weakref.finalize(self, self._renderer.close)
            # Left to the interpreter's last collection, it fails noisily; so it does at
            # finalize's own end, where that comes after the end of OpenGL.
            self._give_back.atexit = False
            atexit.register(self._give_back)
        return [*rendered(self._renderer, states, self._camera)]

    def close(self) -> None:
        """Give the OpenGL context back; closing again does nothing."""
        if self._renderer is not None:
            self._give_back()
            atexit.unregister(self._give_back)
            self._renderer = None


class _Reel:
    """Keeps the states of a trial as they come.

    Args:
        simulation: the live physics; its observer is this one's.
    """

    def __init__(self, simulation: Simulation) -> None:
        """Begin to watch."""
        self._simulation, self._clock = simulation, Clock()
        self._states: list[np.ndarray] = []
        simulation.observer = self._watch

    def begin(self) -> None:
        """Forget the trial before."""
        self._clock.restart(self._simulation.data.time)
        self._states = [self._simulation.save()]

    def _watch(self, data: mujoco.MjData) -> None:
        if self._clock.is_due(data.time):
            self._states.append(self._simulation.save())

    def take(self) -> list[np.ndarray]:
        """The states since they were taken last, or since the trial began."""
        states, self._states = self._states, []
        return states

    def close(self) -> None:
        """Watch no more."""
        self._simulation.observer = None


class Film(Still):
    """Keeps the states of a trial as they come, and renders them when it is asked to.

    Args:
        simulation: the live physics; its observer is this one's.
        size: rows and columns [pixels].
    """

    def __init__(self, simulation: Simulation, size: tuple[int, int]) -> None:
        """Begin to watch."""
        super().__init__(simulation, size)
        # Not the film itself: who is watched by it would keep it open.
        self._reel = _Reel(simulation)

    def begin(self) -> None:
        """Forget the trial before."""
        self._reel.begin()

    def render(self) -> list[Image]:
        """The pictures since it was asked last, or since the trial began."""
        return self._pictures(self._reel.take())

    def close(self) -> None:
        """Watch no more."""
        self._reel.close()
        super().close()
