"""Straight lines in joint space: how ends of a way are tied to the cells of a grid."""

from itertools import product

import numpy as np

from prospect_mj.planning.gross_plan import Cell
from prospect_mj.planning.joint_grid import JointGrid
from prospect_mj.planning.query import Query
from prospect_mj.planning.settings import GROSS_JOINTS

_MOST = 64
"""Cells that are looked at round one configuration."""


def line(first: np.ndarray, last: np.ndarray, step: float) -> np.ndarray:
    """Points (n, 7) [rad] of a straight line, at most a step apart."""
    n = int(np.ceil(np.linalg.norm(last - first) / step))
    return np.linspace(first, last, n + 1)


def subdivided(path: np.ndarray, step: float) -> np.ndarray:
    """A path (n, 7) [rad] with further points on it, all at most a step apart."""
    steps = np.diff(path, axis=0)
    n = np.maximum(np.ceil(np.linalg.norm(steps, axis=1) / step), 1).astype(int)
    segment = np.repeat(np.arange(len(n)), n)
    share = (np.arange(n.sum()) - (np.cumsum(n) - n)[segment]) / n[segment]
    points = path[segment] + share[:, None] * steps[segment]
    return np.concatenate([points, path[-1:]])


def cells_in_sight(
    query: Query, grid: JointGrid, free: np.ndarray, joints: np.ndarray, step: float
) -> list[Cell]:
    """Free cells near a configuration whose centres are a clear straight line away.

    Args:
        query: tells the wrist at the centres, and what is clear.
        grid: of the gross joints.
        free: cells (n_1, n_2, n_3, n_4) that are free.
        joints: the configuration (7,) [rad].
        step: between the points that are looked at [rad].

    Returns:
        Those among the cells round it, or else among cells further away.
    """
    place = grid.coordinates(joints[:GROSS_JOINTS])
    for away in (1, 2):
        cells = _free_cells_round(place, free, away)
        centres = query.configurations(grid.centre(cells))
        ways = [line(centre, joints, step) for centre in centres]
        if not ways:
            continue
        near = np.split(
            query.too_near(np.concatenate(ways)), np.cumsum([len(w) for w in ways])[:-1]
        )
        clear = [not each.any() for each in near]
        if any(clear):
            return [tuple(cell) for cell in cells[clear].tolist()]
    return []


def _free_cells_round(place: np.ndarray, free: np.ndarray, away: int) -> np.ndarray:
    """Free cells (n, 4) at most so many cells away from a place on the grid (4,)."""
    offsets = np.array(list(product(range(1 - away, away + 1), repeat=GROSS_JOINTS)))
    cells = np.floor(place).astype(int) + offsets
    cells = cells[((cells >= 0) & (cells < free.shape)).all(axis=1)]
    cells = cells[free[tuple(cells.T)]]
    order = np.argsort(np.linalg.norm(cells - place, axis=1), kind="stable")
    return cells[order[:_MOST]]
