"""A corridor, where a harmonic function decays beyond what double precision holds."""

import numpy as np

from prospect_mj.planning.laplace import SolverSettings, solve

CELLS_ACROSS = 4
"""Free cells across; their walls are one more cell apart."""
LONGEST = 300
"""Length of the corridor in widths."""


def decay() -> tuple[np.ndarray, np.ndarray]:
    """log10 u along the middle of a corridor with its goal at one end.

    Returns:
        Distance from the goal in widths, and log10 u there, both (n,).
    """
    width = CELLS_ACROSS + 1
    free = np.ones((LONGEST * width, CELLS_ACROSS), bool)
    goal = np.zeros_like(free)
    goal[0] = True
    found = solve(free, goal, np.ones(2), SolverSettings(tolerance=1e-9))
    middle = found.log_u[:, CELLS_ACROSS // 2] / np.log(10)
    return np.arange(len(middle)) / width, middle
