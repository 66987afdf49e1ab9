"""A harmonic function over an arm's joint space, whose streamlines lead to its goals.

Connolly & Grupen (1993), J. Robotic Systems 10(7):931-946: a harmonic function has no
extremum but on its boundary, so that what follows its gradient cannot get stuck.
"""

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from prospect_mj.errors import InvalidValue
from prospect_mj.planning.joint_grid import JointGrid
from prospect_mj.planning.laplace import SolverSettings, solve


class FieldArrays(NamedTuple):
    """What compiled code reads of a field: contiguous, with a border of wall."""

    log_u: np.ndarray
    """(n_padded,) [1], the last joint fastest."""
    strides: np.ndarray
    """(n_joints,) from a cell to the next one along each joint."""
    cells: np.ndarray
    """(n_joints,) without the border."""
    low: np.ndarray
    """(n_joints,) [rad]"""
    spacing: np.ndarray
    """(n_joints,) [rad]"""


@dataclass(frozen=True, eq=False)
class HarmonicField:
    """The probability u that a random walk meets a goal before an obstacle."""

    grid: JointGrid
    """Where the cells are."""
    log_u: np.ndarray
    """Of the grid's shape [1]: 0 at goals and what they enclose; -inf where no goal
    is connected."""
    sweeps: int
    """Number of sweeps that it took."""
    converged: bool
    """Whether the solver met its tolerance."""

    @cached_property
    def connected(self) -> np.ndarray:
        """Goals and the free cells that are connected to one, of the grid's shape."""
        return np.isfinite(self.log_u)

    @cached_property
    def arrays(self) -> FieldArrays:
        """The same for compiled code."""
        log_u = np.full([n + 2 for n in self.grid.shape], -np.inf)
        log_u[(slice(1, -1),) * log_u.ndim] = self.log_u
        return FieldArrays(
            log_u.ravel(),
            np.array(log_u.strides) // log_u.itemsize,
            np.array(self.grid.cells),
            np.array(self.grid.low, float),
            self.grid.spacing,
        )


def harmonic_field(
    grid: JointGrid,
    free: np.ndarray,
    goal: np.ndarray,
    settings: SolverSettings | None = None,
) -> HarmonicField:
    """Solve Laplace's equation on a grid, u = 1 at goals and 0 at obstacles and limits.

    Args:
        grid: the cells.
        free: those that are no obstacle, of the grid's shape, bool.
        goal: those where u = 1, of the same shape, bool; they need not be free.
        settings: of the solver.

    Raises:
        InvalidValue: for masks of another shape, no goal, or a grid that is too large.
    """
    grid.check_memory()
    for what, mask in (("free cells", free), ("goal cells", goal)):
        if mask.shape != grid.shape or mask.dtype != bool:
            expected = f"bool of shape {grid.shape}"
            raise InvalidValue(
                f"mask of {what}", (str(mask.dtype), mask.shape), expected
            )
    if not goal.any():
        raise InvalidValue("number of goal cells", 0, "at least 1")
    return HarmonicField(grid, *solve(free, goal, grid.spacing, settings))
