"""States of a simulation, as they are kept, and the pictures of them."""

from collections.abc import Iterable, Iterator

import mujoco
import numpy as np
from numpy.typing import NDArray

from prospect_mj.sim.camera import Image
from prospect_mj.sim.offscreen import OffscreenRenderer

STATE = mujoco.mjtState.mjSTATE_INTEGRATION
"""What is kept of a simulation: with it, the same follows to the last bit."""


def rendered(
    renderer: OffscreenRenderer,
    states: Iterable[NDArray[np.float64]],
    camera: mujoco.MjvCamera,
) -> Iterator[Image]:
    """Render some states, one after the other.

    Args:
        renderer: of their model.
        states: each a row of numbers, those of `STATE`.
        camera: from where they are seen.

    Yields:
        A picture (rows, columns, 3) RGB of each, in memory of its own.
    """
    data = mujoco.MjData(renderer.model)
    for state in states:
        mujoco.mj_setState(renderer.model, data, state, STATE)
        mujoco.mj_forward(renderer.model, data)
        renderer.update_scene(data, camera)
        yield renderer.render()
