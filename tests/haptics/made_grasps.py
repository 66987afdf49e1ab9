"""Made-up grasps: residuals about a mean of their kind, nearly at rest."""

import numpy as np
from numpy.typing import NDArray

PERIOD = 0.02


def felt(
    mean: float, deviation: float, n: int, rng: np.random.Generator, length: int = 3
) -> list[NDArray[np.float64]]:
    """n trajectories (length, 2) of time and residual, about levels of their own."""
    seconds = 0.3 + PERIOD * np.arange(length)
    levels = rng.normal(mean, deviation, n)
    return [
        np.column_stack([seconds, level + rng.normal(0, 2e-5, length)])
        for level in levels
    ]
