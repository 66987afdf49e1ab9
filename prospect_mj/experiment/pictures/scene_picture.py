"""The README's picture: a trial with an early correction in four frames."""

from collections.abc import Callable

import cv2
import mujoco
import numpy as np

from prospect_mj.actions.action import Action
from prospect_mj.sim import overview
from prospect_mj.sim.camera import Image
from prospect_mj.sim.offscreen import OffscreenRenderer
from prospect_mj.task.pick_place import PickPlaceTask

SIZE = (720, 1280)
"""Rows and columns of a frame; the picture is as large [pixels]."""
ACTIONS = (Action.GRASP_RIGHT, Action.SWAP_RIGHT_TO_LEFT, Action.INSERT_LEFT)
STEPS = 1 + len(ACTIONS)
"""Frames."""


def scene_picture(tick: Callable[[], object]) -> bytes:
    """The presentation and what each of three actions leaves behind, as PNG.

    Args:
        tick: called after each of the `STEPS`.
    """
    with PickPlaceTask() as task:
        task.reset("left", np.random.default_rng(3))
        overview.light_for_people(task.simulation.model, SIZE)
        frames = [_labelled(_photograph(task), "1  presented")]
        tick()
        for i, action in enumerate(ACTIONS, start=2):
            task.execute(action)
            frames.append(_labelled(_photograph(task), f"{i}  {action.label}"))
            tick()
    rows = [np.hstack(frames[:2]), np.hstack(frames[2:])]
    half = cv2.resize(
        np.vstack(rows), None, fx=0.5, fy=0.5, interpolation=cv2.INTER_AREA
    )
    _, content = cv2.imencode(".png", cv2.cvtColor(half, cv2.COLOR_RGB2BGR))
    return content.tobytes()


def _photograph(task: PickPlaceTask) -> Image:
    """A picture (720, 1280, 3) RGB of the scene as it is."""
    with OffscreenRenderer(task.simulation.model, *SIZE) as renderer:
        renderer.update_scene(task.simulation.data, overview.camera())
        # They speckle the arms.
        renderer.scene.flags[mujoco.mjtRndFlag.mjRND_SHADOW] = False
        return renderer.render()


def _labelled(picture: Image, text: str) -> Image:
    """The picture with a caption in its upper left corner."""
    font, ink = cv2.FONT_HERSHEY_DUPLEX, (25, 30, 40)
    return cv2.putText(picture.copy(), text, (30, 60), font, 1.5, ink, 2, cv2.LINE_AA)
