"""Free cells and goals for tests of the Laplace solver and of streamlines."""

import numpy as np
from scipy.ndimage import gaussian_filter

Map = tuple[np.ndarray, np.ndarray]


def random_map(
    rng: np.random.Generator,
    shape: tuple[int, ...],
    blob: float = 1.0,
    share: float = 0.5,
    n_goals: int = 3,
) -> Map:
    """Blobs of obstacles, `share` of the cells free, and goals among these."""
    height = gaussian_filter(rng.standard_normal(shape), blob, mode="nearest")
    free = height > np.quantile(height, 1 - share)
    goal = np.zeros(shape, bool)
    goal.flat[rng.choice(np.flatnonzero(free), n_goals, replace=False)] = True
    return free, goal


def channel(width: int, length: int) -> Map:
    """A straight channel, walled but for its first column, which is the goal."""
    free = np.ones((width, length), bool)
    goal = np.zeros_like(free)
    goal[:, 0] = True
    return free, goal


def baffles(n: int) -> Map:
    """A square room with two walls across it, each with a gap at another side."""
    free = np.ones((n, n), bool)
    free[n // 3, :-1] = False
    free[2 * n // 3, 1:] = False
    goal = np.zeros_like(free)
    goal[0, 0] = True
    return free, goal


def serpentine(n: int) -> Map:
    """A single way, one cell wide, back and forth through a square."""
    free = np.zeros((n, n), bool)
    free[::2] = True
    free[1::4, -1] = True
    free[3::4, 0] = True
    goal = np.zeros_like(free)
    goal[0, 0] = True
    return free, goal


def unequal_ways(length: int) -> Map:
    """Two ways from one end to the other, one cell wide and nine cells wide."""
    free = np.zeros((12, length), bool)
    free[0] = True
    free[3:] = True
    free[:, [0, -1]] = True
    goal = np.zeros_like(free)
    goal[2, 0] = True
    return free, goal
