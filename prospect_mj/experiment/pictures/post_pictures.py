"""What the post in the receptacle does, seen from outside."""

import copy
from typing import NamedTuple

import cv2
import mujoco
import numpy as np
from numpy.typing import NDArray

from prospect_mj.actions.action import Action
from prospect_mj.recording.config import RecordingConfig
from prospect_mj.recording.grower import task_settings
from prospect_mj.sim import overview
from prospect_mj.sim.camera import Image
from prospect_mj.sim.offscreen import OffscreenRenderer
from prospect_mj.task.pick_place import PickPlaceTask

_SHARP = 2
"""Pixels that are rendered for one, each way."""
_SEED = 3
_CUT_OPEN = ("well/wall_far", "well/chamfer_far")
"""What would hide the post from in front of the torso."""
_CRADLE = ("pedestal/near", "pedestal/far", "pedestal/post")
_BRASS = (0.85, 0.66, 0.20)
"""Of the post, which is as green as the walls: nobody but people sees it."""


class _View(NamedTuple):
    """Where a picture is taken from."""

    look_at: tuple[float, float, float]
    """[m]"""
    distance: float
    """[m]"""
    azimuth: float
    """[degrees]"""
    elevation: float
    """[degrees]"""


_AT_LID = _View((0.62, 0.06, 0.195), 0.30, 262.0, -12.0)
_INTO_WELL = _View((0.45, 0.0, 0.085), 0.40, 200.0, -30.0)
_AT_WELL = _View((0.45, 0.0, 0.15), 0.50, 200.0, -20.0)


def post_pictures(size: int) -> dict[str, Image]:
    """The lid's recess, the post, and what comes of either end, by what they show.

    Args:
        size: rows and columns of each [pixels].
    """
    with PickPlaceTask(task_settings(RecordingConfig(world="post"))) as task:
        task.reset("left", np.random.default_rng(_SEED))
        presented = task.simulation.save()
        task.execute(Action.GRASP_LEFT)
        jammed = _lowest(task, Action.INSERT_LEFT)
        task.execute(Action.SWAP_LEFT_TO_RIGHT)
        task.execute(Action.INSERT_RIGHT)
        inserted = task.simulation.save()
        look = _Look(task.simulation.model, _SHARP * size)
    open_well = (*_CUT_OPEN, *_CRADLE)
    return {
        "a recess in the lid": look(presented, _AT_LID),
        "the post, cut open": look(presented, _INTO_WELL, (*open_well, "jar/visual")),
        "body first: it jams": look(jammed, _AT_WELL, open_well),
        "lid first: it is in": look(inserted, _AT_WELL, open_well),
    }


def _lowest(task: PickPlaceTask, action: Action) -> NDArray[np.float64]:
    """The state in which the jar is lowest while an action runs."""
    simulation, states = task.simulation, []

    def watch(data: mujoco.MjData) -> None:
        height = simulation.jar_position[2]
        if not states or height < states[0][0]:
            states[:] = [(height, simulation.save())]

    simulation.observer = watch
    task.execute(action)
    simulation.observer = None
    return states[0][1]


class _Look:
    """Takes square pictures of states, by daylight and half as large as rendered."""

    def __init__(self, model: mujoco.MjModel, side: int) -> None:
        """Light the scene for people.

        Args:
            model: changed in place.
            side: of a picture as it is rendered [pixels].
        """
        self._model, self._side = model, side
        overview.light_for_people(model, (side, side))
        model.geom("well/post").rgba[:3] = _BRASS

    def __call__(
        self, state: NDArray[np.float64], view: _View, hidden: tuple[str, ...] = ()
    ) -> Image:
        """A picture of a state, without some of its parts."""
        model = copy.copy(self._model)
        for name in hidden:
            model.geom(name).rgba[3] = 0
        # Colours of a texture don't come through these.
        model.geom_matid[[model.geom(name).id for name in hidden]] = -1
        data = mujoco.MjData(model)
        mujoco.mj_setState(model, data, state, mujoco.mjtState.mjSTATE_INTEGRATION)
        mujoco.mj_forward(model, data)
        camera = mujoco.MjvCamera()
        camera.lookat[:], camera.distance = view.look_at, view.distance
        camera.azimuth, camera.elevation = view.azimuth, view.elevation
        with OffscreenRenderer(model, self._side, self._side) as renderer:
            renderer.update_scene(data, camera)
            renderer.scene.flags[mujoco.mjtRndFlag.mjRND_SHADOW] = False
            sharp = renderer.render()
        size = (self._side // _SHARP,) * 2
        return cv2.resize(sharp, size, interpolation=cv2.INTER_AREA)
