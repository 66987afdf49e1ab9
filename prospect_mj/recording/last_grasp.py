"""What an action of live physics felt like, as recordings keep it."""

import numpy as np
from numpy.typing import NDArray

from prospect_mj.actions.action import ActionOutcome
from prospect_mj.control.grasp_settings import GraspResult


def last_grasp(outcome: ActionOutcome) -> NDArray[np.float32]:
    """The trajectory of an action's last grasp, in single precision.

    Args:
        outcome: of live physics.

    Returns:
        (m, 2): time since the hand closes [s] and residual [1] of each sample; m is 0
        without a grasp.
    """
    results = [run.result for run in outcome.runs]
    grasps = [result for result in results if isinstance(result, GraspResult)]
    samples = grasps[-1].trajectory if grasps else ()
    return np.array(samples, np.float32).reshape(-1, 2)
