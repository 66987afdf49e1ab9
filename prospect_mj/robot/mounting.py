"""Where the arms stand on the torso: ours, as the Torso's own places aren't published.

Each shoulder's base frame has its origin in the shoulder centre and z along J1.
"""

import numpy as np
from scipy.spatial.transform import Rotation

from prospect_mj.robot import names
from prospect_mj.robot.names import Side

SHOULDER_HEIGHT = 0.55
SHOULDER_HALF_WIDTH = 0.22
"""Place of the shoulder centres [m]. J1 points outward along y, which of all mounts
searched keeps pick, swap and insertion in one connected part of the arm's workspace."""


def shoulder_position(side: Side) -> np.ndarray:
    """Shoulder centre (3,) [m] in the world."""
    return np.array([0.0, names.sign(side) * SHOULDER_HALF_WIDTH, SHOULDER_HEIGHT])


def shoulder_rotation(side: Side) -> Rotation:
    """From the base frame to the world."""
    return Rotation.from_euler("x", -names.sign(side) * np.pi / 2)
