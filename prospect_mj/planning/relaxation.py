"""Compiled sweeps of over-relaxation on numbers of extended range.

A harmonic function decays by a constant factor per cell of a corridor, so that it
leaves the range of double precision after a few hundred cells. Each value is therefore
kept as mantissa times 2^(960 exponent), as in Fukushima (2012), J. Geodesy 86:271-285:
where neighbours share the exponent, which is nearly everywhere, a sweep is plain
arithmetic.

Arrays (n_values, ...) are ordered as a flood fill from the goals meets the cells: value
0 is the wall (u = 0), values 1 to n_goals the goals (u = 1), all others the unknowns.
Neighbours are then one level of the fill above or below, so that each sweep carries
the solution outwards from the goals, and Young's theory of over-relaxation holds.
"""

import numpy as np
from numba import njit

RADIX = 2.0**960
_INVERSE = 2.0**-960
_HIGH = 2.0**480
_LOW = 2.0**-480
_NONE = -(2**31)
# Share of a cell's value that the fill's next level is first taken to have; 0.3 to 0.7
# cost the same number of sweeps on random maps of 16^4 cells.
_ONWARD = 0.5
# An over-relaxed value below this share of its neighbours' mean is set to the mean:
# the solution is positive, and so must every iterate be that has a logarithm.
_LEAST = 0.25


@njit(cache=True, error_model="numpy")
def link(
    ids: np.ndarray,
    cells: np.ndarray,
    neighbours: np.ndarray,
    n_goals: int,
    offsets: np.ndarray,
) -> int:
    """Flood the free cells from the goals, number them and note who neighbours whom.

    Args:
        ids: (n_padded,) value of a cell of the padded grid: 0 wall, −1 free, > 0 goal;
            the free cells that the fill meets get theirs.
        cells: (n_values,) where in the padded grid a value lies; goals are given.
        neighbours: (n_values, n_offsets) filled with the neighbours' values.
        n_goals: number of goals.
        offsets: (n_offsets,) steps to the neighbours in the padded grid.

    Returns:
        Number of values: wall, goals and the cells that are connected to one.
    """
    count = n_goals + 1
    value = 1
    while value < count:
        for k in range(offsets.size):
            cell = cells[value] + offsets[k]
            if ids[cell] < 0:
                ids[cell] = count
                cells[count] = cell
                count += 1
            neighbours[value, k] = ids[cell]
        value += 1
    return count


@njit(cache=True, error_model="numpy")
def _mean(
    value: int,
    neighbours: np.ndarray,
    weights: np.ndarray,
    mantissa: np.ndarray,
    exponent: np.ndarray,
) -> tuple[float, float, int]:
    """The neighbours' weighted mean, the part from lower values, and their exponent."""
    top = _NONE
    for k in range(weights.size):
        other = neighbours[value, k]
        if mantissa[other] > 0.0:
            top = max(top, exponent[other])
    mean = 0.0
    upstream = 0.0
    for k in range(weights.size):
        other = neighbours[value, k]
        term = weights[k] * _shifted(mantissa[other], exponent[other] - top)
        mean += term
        if other < value:
            upstream += term
    return mean, upstream, top


@njit(cache=True, error_model="numpy")
def _shifted(mantissa: float, steps: int) -> float:
    """A mantissa whose exponent was `steps` above; 0 beyond one, as none is so far."""
    if steps == 0:
        return mantissa
    if steps == -1:
        return mantissa * _INVERSE
    return mantissa * RADIX if steps == 1 else 0.0


@njit(cache=True, error_model="numpy")
def _in_range(mantissa: float, exponent: int) -> tuple[float, int]:
    """The same number with a mantissa between 2^-480 and 2^480."""
    if mantissa < _LOW:
        return mantissa * RADIX, exponent - 1
    if mantissa > _HIGH:
        return mantissa * _INVERSE, exponent + 1
    return mantissa, exponent


@njit(cache=True, error_model="numpy")
def start(
    n_goals: int,
    neighbours: np.ndarray,
    weights: np.ndarray,
    mantissa: np.ndarray,
    exponent: np.ndarray,
) -> None:
    """First estimate, level by level: all beyond a cell has half of its value.

    u_i = sum_upstream w_j u_j + (u_i / 2) sum_downstream w_j
    """
    for value in range(n_goals + 1, mantissa.size):
        mean, _, top = _mean(value, neighbours, weights, mantissa, exponent)
        onward = 0.0
        for k in range(weights.size):
            if neighbours[value, k] > value:
                onward += weights[k]
        estimate = mean / (1.0 - _ONWARD * onward)
        mantissa[value], exponent[value] = _in_range(estimate, top)


@njit(cache=True, error_model="numpy")
def set_factors(
    n_goals: int,
    neighbours: np.ndarray,
    weights: np.ndarray,
    mantissa: np.ndarray,
    exponent: np.ndarray,
    over_relaxation: float,
    factors: np.ndarray,
) -> None:
    """Relaxation factor of each cell: the wanted one, where it cannot amplify errors.

    With share p of a cell's mean from upstream, a factor above 1/p multiplies an error
    cell by cell on its way outwards, without bound along a corridor. 1/p is also the
    best factor there: 2 / (1 + sqrt(1 − 4 p (1 − p))).
    """
    for value in range(n_goals + 1, mantissa.size):
        mean, upstream, _ = _mean(value, neighbours, weights, mantissa, exponent)
        limited = upstream * over_relaxation > mean
        factors[value] = mean / upstream if limited else over_relaxation


@njit(cache=True, error_model="numpy")
def sweep(
    n_goals: int,
    neighbours: np.ndarray,
    weights: np.ndarray,
    mantissa: np.ndarray,
    exponent: np.ndarray,
    factors: np.ndarray,
) -> float:
    """Over-relax every unknown once, in place: u_i += f_i (sum_j w_j u_j − u_i).

    Returns:
        Largest change of a value as a share of the value.
    """
    largest = 0.0
    for value in range(n_goals + 1, mantissa.size):
        old = mantissa[value]
        own = exponent[value]
        mean = 0.0
        alike = True
        for k in range(weights.size):
            other = neighbours[value, k]
            mean += weights[k] * mantissa[other]
            alike &= exponent[other] == own
        if not alike:
            mean, _, top = _mean(value, neighbours, weights, mantissa, exponent)
            old = _shifted(old, own - top)
            own = top
        new = old + factors[value] * (mean - old)
        if new < _LEAST * mean:
            new = mean
        if own == 0 and new > 1.0:
            new = 1.0
        largest = max(largest, abs(new - old) / new)
        mantissa[value], exponent[value] = _in_range(new, own)
    return largest


@njit(cache=True, error_model="numpy")
def has_maximum(
    n_goals: int, neighbours: np.ndarray, mantissa: np.ndarray, exponent: np.ndarray
) -> bool:
    """Whether an unknown has no higher neighbour; u = 1 among goals alone is none."""
    for value in range(n_goals + 1, mantissa.size):
        higher = False
        lower = exponent[value] < 0 or mantissa[value] < 1.0
        for k in range(neighbours.shape[1]):
            other = neighbours[value, k]
            step = exponent[other] - exponent[value]
            if mantissa[other] == 0.0 or step < 0:
                lower = True
            elif step > 0:
                higher = True
            else:
                higher |= mantissa[other] > mantissa[value]
                lower |= mantissa[other] < mantissa[value]
        if lower and not higher:
            return True
    return False
