"""The planner's own clearance of an arm, among everything that it plans round."""

import mujoco
import numpy as np

from prospect_mj.planning.arm_body import arm_body
from prospect_mj.planning.arm_kernels import clearances
from prospect_mj.planning.planner import World
from prospect_mj.planning.query import CEILING
from prospect_mj.planning.surroundings import Surroundings, body_with
from prospect_mj.robot.names import Side


def planners_clearance(
    model: mujoco.MjModel, side: Side, configurations: np.ndarray, world: World
) -> np.ndarray:
    """Least distances (n,) [m] of configurations (n, 7) [rad] to anything."""
    body = body_with(arm_body(model, side), world.jars)
    around = Surroundings(model, side)
    rows = np.concatenate([around.fixed, around.moving(world.data, world.jars)])
    return clearances(body.arrays, configurations, rows, CEILING)
