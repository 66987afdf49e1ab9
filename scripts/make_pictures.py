"""Draw the README's picture: a trial with a late correction in four frames."""

import sys
from pathlib import Path

import cv2
import numpy as np

from prospect_mj.actions.action import Action
from prospect_mj.sim import overview
from prospect_mj.sim.offscreen import OffscreenRenderer
from prospect_mj.task.pick_place import PickPlaceTask

SIZE = (720, 1280)
ACTIONS = (Action.GRASP_RIGHT, Action.SWAP_RIGHT_TO_LEFT, Action.INSERT_LEFT)


def photograph(task: PickPlaceTask) -> np.ndarray:
    """A picture (720, 1280, 3) uint8 RGB of the scene as it is."""
    with OffscreenRenderer(task.simulation.model, *SIZE) as renderer:
        renderer.update_scene(task.simulation.data, overview.camera())
        return renderer.render()


def labelled(picture: np.ndarray, text: str) -> np.ndarray:
    """The picture with a caption in its upper left corner."""
    font, ink = cv2.FONT_HERSHEY_DUPLEX, (25, 30, 40)
    return cv2.putText(picture.copy(), text, (30, 60), font, 1.5, ink, 2, cv2.LINE_AA)


def main(folder: Path) -> None:
    """Photograph the presentation and what each of three actions leaves behind."""
    with PickPlaceTask() as task:
        task.reset("left", np.random.default_rng(3))
        overview.light_for_people(task.simulation.model, SIZE)
        frames = [labelled(photograph(task), "1  presented")]
        for i, action in enumerate(ACTIONS, start=2):
            task.execute(action)
            frames.append(labelled(photograph(task), f"{i}  {action.label}"))
    rows = [np.hstack(frames[:2]), np.hstack(frames[2:])]
    sheet = cv2.resize(np.vstack(rows), None, fx=0.5, fy=0.5, interpolation=3)
    folder.mkdir(parents=True, exist_ok=True)
    cv2.imwrite(str(folder / "scene.png"), cv2.cvtColor(sheet, cv2.COLOR_RGB2BGR))


if __name__ == "__main__":
    main(Path(sys.argv[1] if len(sys.argv) > 1 else "docs/images"))
