"""Laplace's equation on the free cells of a grid, with u = 1 at goals and 0 at walls.

u is the probability that a random walk meets a goal before an obstacle (Connolly 1994).
What is solved for is log u, to a tolerance of log u: far down a corridor u is so small
that a test of the residual is met long before u has its first correct digit.
"""

import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from prospect_mj.errors import InvalidValue
from prospect_mj.planning import relaxation

# Sweeps after which progress is judged and the factors follow the solution.
_ROUND = 50
_MOST_CELLS = 2**31 - 1


@dataclass(frozen=True)
class SolverSettings:
    """Successive over-relaxation; measured on random maps of 16^4 cells, half free."""

    over_relaxation: float = 1.5
    """Relaxation factor [1] in [1, 2), lower where a solution decays fast."""
    tolerance: float = 1e-3
    """Largest relative change of u [1] in the last sweep, which is that of log u."""
    max_sweeps: int = 20_000
    """Number of sweeps after which the solver gives up."""

    def __post_init__(self) -> None:
        """Refuse numbers outside of their range."""
        if not 1 <= self.over_relaxation < 2:
            expected = "a number in [1, 2)"
            raise InvalidValue("over-relaxation", self.over_relaxation, expected)
        if not 0 < self.tolerance < 1:
            raise InvalidValue("tolerance", self.tolerance, "a number in (0, 1)")
        if not isinstance(self.max_sweeps, int) or self.max_sweeps < 1:
            expected = "an integer of at least 1"
            raise InvalidValue("max sweeps", self.max_sweeps, expected)


class Solution(NamedTuple):
    """The logarithm of a harmonic function."""

    log_u: np.ndarray
    """Of the grid's shape [1]: 0 at goals and what they enclose; -inf where no goal
    is connected."""
    sweeps: int
    """Number of sweeps."""
    converged: bool
    """Whether the tolerance was met with no maximum left but the goals."""


class _Unknowns(NamedTuple):
    """The connected cells in the order of a flood fill; see `relaxation`."""

    n_goals: int
    cells: np.ndarray
    neighbours: np.ndarray
    weights: np.ndarray


def solve(
    free: np.ndarray,
    goal: np.ndarray,
    spacing: np.ndarray,
    settings: SolverSettings | None = None,
) -> Solution:
    """Solve sum_i d²u/dq_i² = 0 on the free cells that are connected to a goal.

    u_i = sum_j w_j u_j over the 2 n neighbours, w_j ~ 1/h² of its axis, sum_j w_j = 1.
    What lies outside of the grid is wall.

    Args:
        free: cells that are no obstacle, of the grid's shape, bool.
        goal: cells where u = 1, of the same shape, bool; they need not be free.
        spacing: h (n,) [rad], or any other unit.
        settings: of the iteration.

    Returns:
        log u with the number of sweeps.
    """
    settings = SolverSettings() if settings is None else settings
    padded = tuple(n + 2 for n in free.shape)
    if math.prod(padded) > _MOST_CELLS:
        expected = f"at most {_MOST_CELLS}"
        raise InvalidValue("number of cells with border", math.prod(padded), expected)
    unknowns = _link(free, goal, np.asarray(spacing, float))
    mantissa = np.zeros(len(unknowns.cells))
    mantissa[1 : unknowns.n_goals + 1] = 1.0
    exponent = np.zeros(len(unknowns.cells), np.int32)
    sweeps, converged = _relax(unknowns, mantissa, exponent, settings)
    log_u = np.full(math.prod(padded), -np.inf)
    log_radix = math.log(relaxation.RADIX)
    log_u[unknowns.cells[1:]] = np.log(mantissa[1:]) + exponent[1:] * log_radix
    return Solution(log_u.reshape(padded)[_inner(free)].copy(), sweeps, converged)


def _inner(mask: np.ndarray) -> tuple[slice, ...]:
    """All but the border of a padded array."""
    return (slice(1, -1),) * mask.ndim


def _link(free: np.ndarray, goal: np.ndarray, spacing: np.ndarray) -> _Unknowns:
    """Number the cells that are connected to a goal."""
    ids = np.zeros([n + 2 for n in free.shape], np.int32)
    steps = np.array(ids.strides) // ids.itemsize
    ids[_inner(free)] = -(free | goal).astype(np.int32)
    n_open = np.count_nonzero(ids)
    n_goals = np.count_nonzero(goal)
    ids[_inner(free)][goal] = np.arange(1, n_goals + 1)
    ids = ids.ravel()
    cells = np.zeros(1 + n_open, np.int32)
    cells[1 : n_goals + 1] = np.flatnonzero(ids > 0)
    neighbours = np.zeros((cells.size, 2 * steps.size), np.int32)
    offsets = np.concatenate([-steps, steps])
    count = relaxation.link(ids, cells, neighbours, n_goals, offsets)
    weights = np.tile(spacing**-2.0, 2)
    weights /= weights.sum()
    return _Unknowns(n_goals, cells[:count], neighbours[:count], weights)


def _relax(
    unknowns: _Unknowns,
    mantissa: np.ndarray,
    exponent: np.ndarray,
    settings: SolverSettings,
) -> tuple[int, bool]:
    """Sweep until converged; returns the sweeps, and whether they were enough."""
    n_goals, _, neighbours, weights = unknowns
    values = (n_goals, neighbours, weights, mantissa, exponent)
    relaxation.start(*values)
    factors = np.empty_like(mantissa)
    over_relaxation = settings.over_relaxation
    change = judged = math.inf
    for n_sweeps in range(settings.max_sweeps):
        if n_sweeps % _ROUND == 0:
            if n_sweeps and change >= judged:
                # Gauss-Seidel always converges; over-relaxation may circle around a
                # solution that decays fast along one axis and slowly along another.
                over_relaxation = 0.5 * (1.0 + over_relaxation)
            judged = change
            relaxation.set_factors(*values, over_relaxation, factors)
        change = relaxation.sweep(*values, factors)
        if change < settings.tolerance and not relaxation.has_maximum(
            n_goals, neighbours, mantissa, exponent
        ):
            return n_sweeps + 1, True
    return settings.max_sweeps, False


def bytes_needed(shape: tuple[int, ...]) -> int:
    """Memory that `solve` takes at most, where all cells are free [bytes]."""
    size = math.prod(shape)
    padded = math.prod(n + 2 for n in shape)
    linked = 4 + 4 * 2 * len(shape)
    iterated = 8 + 4 + 8
    return size * (linked + iterated) + padded * (4 + 8) + size * (8 + 8)
