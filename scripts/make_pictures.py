"""Draw the README's pictures of the scene: a whole trial in four frames."""

import sys
from pathlib import Path

import cv2
import mujoco
import numpy as np

from prospect_mj.actions.action import Action
from prospect_mj.task.pick_place import PickPlaceTask

SIZE = (720, 1280)
LOOK_AT, DISTANCE, AZIMUTH, ELEVATION = (0.36, 0.10, 0.40), 1.95, 150.0, -22.0


def photograph(task: PickPlaceTask) -> np.ndarray:
    """A picture (720, 1280, 3) uint8 RGB by daylight, from in front of the robot."""
    model, camera = task.simulation.model, mujoco.MjvCamera()
    camera.lookat[:] = LOOK_AT
    camera.distance, camera.azimuth, camera.elevation = DISTANCE, AZIMUTH, ELEVATION
    with mujoco.Renderer(model, *SIZE) as renderer:
        renderer.update_scene(task.simulation.data, camera)
        return renderer.render()


def by_daylight(model: mujoco.MjModel) -> None:
    """Light the scene for people; the eyes took their picture before."""
    model.vis.quality.offsamples, model.vis.quality.shadowsize = 8, 8192
    model.vis.headlight.ambient[:], model.vis.headlight.diffuse[:] = 0.55, 0.40
    model.light_diffuse[:] *= 0.5
    model.vis.map.shadowscale = 0.4
    model.geom("table/top").rgba[:3] = 0.52, 0.40, 0.28
    model.geom("table/floor").rgba[:3] = 0.62, 0.64, 0.66


def main(folder: Path) -> None:
    """Follow a late correction and photograph what each action leaves behind."""
    task = PickPlaceTask()
    model = task.simulation.model
    model.vis.global_.offheight, model.vis.global_.offwidth = SIZE
    task.reset("left", np.random.default_rng(3))
    by_daylight(model)
    frames = [photograph(task)]
    for action in (Action.GRASP_RIGHT, Action.SWAP_RIGHT_TO_LEFT, Action.INSERT_LEFT):
        task.execute(action)
        frames.append(photograph(task))
    rows = [np.hstack(frames[:2]), np.hstack(frames[2:])]
    sheet = cv2.resize(np.vstack(rows), None, fx=0.5, fy=0.5, interpolation=3)
    folder.mkdir(parents=True, exist_ok=True)
    cv2.imwrite(str(folder / "scene.png"), cv2.cvtColor(sheet, cv2.COLOR_RGB2BGR))
    task.close()


if __name__ == "__main__":
    main(Path(sys.argv[1] if len(sys.argv) > 1 else "docs/images"))
