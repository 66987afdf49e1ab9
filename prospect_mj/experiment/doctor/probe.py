"""`python -m prospect_mj.experiment.doctor.probe`: render, look, act, and take time.

A process of its own, which a broken driver may take down with it. Each line that it
prints is a JSON object.
"""

import json
import sys
from statistics import median
from time import perf_counter

import numpy as np

from prospect_mj.errors import ProspectError
from prospect_mj.sim import gl

_N_LOOKS = 5
_OPTIMAL = "GRASP_LEFT", "INSERT_LEFT"


def main() -> int:
    """Print what was found, and return 0; or say what is missing and return 1."""
    try:
        print(json.dumps({"renderer": gl.renderer_name()}), flush=True)
        print(json.dumps(speed()), flush=True)
    except (ProspectError, OSError) as error:
        print(" ".join(str(error).split()), file=sys.stderr)
        return 1
    return 0


def speed() -> dict[str, float]:
    """Wall time of a look and of an action [ms], simulated by wall seconds."""
    # MuJoCo is not loaded before it is known that it can render.
    from prospect_mj.actions.action import Action
    from prospect_mj.task.pick_place import PickPlaceTask

    rng = np.random.default_rng(0)
    wall, simulated, looks = 0.0, 0.0, []
    with PickPlaceTask() as task:
        # Compiled code is loaded, or made, when it is first called.
        task.reset("left", rng)
        task.execute(Action.GRASP_LEFT)
        task.reset("left", rng)
        for action in _OPTIMAL:
            start = perf_counter()
            simulated += task.execute(Action[action]).sim_seconds
            wall += perf_counter() - start
        for _ in range(_N_LOOKS):
            start = perf_counter()
            task.vision.look(task.camera.capture(task.simulation.data, rng))
            looks.append(perf_counter() - start)
    return {
        "look_ms": 1e3 * median(looks),
        "action_ms": 1e3 * wall / len(_OPTIMAL),
        "times_real_time": simulated / wall,
    }


if __name__ == "__main__":
    sys.exit(main())
