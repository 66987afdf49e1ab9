"""Sums of products in the order of `np.sum`, so that they are equal to the last bit.

NumPy halves a row of more than 128 numbers, at multiples of eight, until no part is
longer. Within a part it adds in eight lanes, and what is left over at the end. Where
features are always zero nothing has to be added up.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from prospect_mj.experiment.populations.kernels.cache import uncounted

Floats = NDArray[np.float64]

_LONGEST, _LANES = 128, 8


class Order(NamedTuple):
    """The order in which n numbers are added up, of which each part is p-th."""

    bounds: NDArray[np.int64]
    """(parts, 2): first number of a part, and the one after its last."""
    left: NDArray[np.int64]
    """(parts,): first number of a part that is left over by the lanes."""
    sums: NDArray[np.int64]
    """(parts,): how many sums of two are made, of the latest ones, after a part."""
    stack: Floats
    """(parts,): room for sums."""


def order_of(n: int) -> Order:
    """The order for n numbers, at least eight."""
    bounds: list[tuple[int, int]] = []
    sums: list[int] = []
    _split(0, n, bounds, sums)
    left = [end - (end - begin) % _LANES for begin, end in bounds]
    parts = map(np.array, (bounds, left, sums))
    return Order(*parts, np.zeros(len(bounds)))


def _split(
    begin: int, end: int, bounds: list[tuple[int, int]], sums: list[int]
) -> None:
    n = end - begin
    if n <= _LONGEST:
        bounds.append((begin, end))
        sums.append(0)
        return
    half = n // 2
    middle = begin + half - half % _LANES
    _split(begin, middle, bounds, sums)
    _split(middle, end, bounds, sums)
    sums[-1] += 1


def spans_of(features: NDArray, order: Order) -> NDArray[np.int64]:
    """Where there is anything but zeros in each part of some features.

    Args:
        features: (rows, n).
        order: of n numbers.

    Returns:
        (rows, parts, 2): first number, and the one after the last, of the lanes with
        all that is not zero there, and not left over; equal if there is nothing.
    """
    spans = np.zeros((len(features), len(order.bounds), 2), np.int64)
    for part, (begin, end) in enumerate(order.bounds):
        whole = end - (end - begin) % _LANES
        blocks = features[:, begin:whole].reshape(len(features), -1, _LANES)
        for row, busy in enumerate(blocks.any(axis=2)):
            found = np.flatnonzero(busy)
            if len(found):
                ends = found[[0, -1]] + [0, 1]
                spans[row, part] = begin + _LANES * ends
    return spans


@uncounted
def product(
    theta: Floats, phi: Floats, order: Order, spans: NDArray[np.int64]
) -> float:
    """Sum up theta . phi; phi is zero outside of spans (parts, 2) and what is left."""
    stack, top = order.stack, -1
    for part in range(len(spans)):
        top += 1
        stack[top] = _lanes(theta, phi, spans[part, 0], spans[part, 1])
        for index in range(order.left[part], order.bounds[part, 1]):
            stack[top] += theta[index] * phi[index]
        for _ in range(order.sums[part]):
            top -= 1
            stack[top] += stack[top + 1]
    return stack[0]


@uncounted
def add(
    theta: Floats,
    change: float,
    phi: Floats,
    order: Order,
    spans: NDArray[np.int64],
) -> None:
    """Add change x phi to theta; phi is zero outside of spans and what is left."""
    for part in range(len(spans)):
        for index in range(spans[part, 0], spans[part, 1]):
            theta[index] += change * phi[index]
        for index in range(order.left[part], order.bounds[part, 1]):
            theta[index] += change * phi[index]


@uncounted
def _lanes(theta: Floats, phi: Floats, begin: int, end: int) -> float:
    """Eight sums side by side, added up at the end."""
    s0 = s1 = s2 = s3 = s4 = s5 = s6 = s7 = 0.0
    for i in range(begin, end, 8):
        s0 += theta[i] * phi[i]
        s1 += theta[i + 1] * phi[i + 1]
        s2 += theta[i + 2] * phi[i + 2]
        s3 += theta[i + 3] * phi[i + 3]
        s4 += theta[i + 4] * phi[i + 4]
        s5 += theta[i + 5] * phi[i + 5]
        s6 += theta[i + 6] * phi[i + 6]
        s7 += theta[i + 7] * phi[i + 7]
    return ((s0 + s1) + (s2 + s3)) + ((s4 + s5) + (s6 + s7))
