"""Where the jar is put when a trial begins."""

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class JarPlacement:
    """Where the jar is put at reset; the pedestal goes with it."""

    position: np.ndarray
    """Centre of the jar (3,) [m]."""
    yaw: float
    """Turn about the vertical, 0 = along y [rad]."""
    lid_left: bool
    """Whether the lid points to the left (+y)."""
