"""A grid over an arm's joint space: where its cells are, and the memory it needs."""

import os
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from prospect_mj.errors import InvalidValue
from prospect_mj.planning.laplace import bytes_needed

# A grid leaves the larger half of the machine to the physics and to other processes.
_MEMORY_SHARE = 0.25
_FLOAT_BYTES = 8


@dataclass(frozen=True)
class JointGrid:
    """Equal cells over a box of joint angles; an axis is a joint.

    A cell's value stands for its centre; the outermost centres lie half a cell inside
    of the box.
    """

    low: tuple[float, ...]
    """Lower bound of the box [rad], one per joint."""
    high: tuple[float, ...]
    """Upper bound of the box [rad], one per joint."""
    cells: tuple[int, ...]
    """Number of cells [1], one per joint."""

    def __post_init__(self) -> None:
        """Refuse a box without volume and axes without two cells."""
        for what, value, expected in self._faults():
            raise InvalidValue(what, value, expected)

    def _faults(self) -> Iterator[tuple[str, object, str]]:
        """What is wrong with the grid, what it is, and what was expected."""
        lengths = (len(self.low), len(self.high), len(self.cells))
        if len(set(lengths)) > 1 or 0 in lengths:
            what = "number of joints of a grid's low, high, cells"
            yield what, lengths, "three equal numbers of at least 1"
        if not all(isinstance(n, int | np.integer) and n >= 2 for n in self.cells):
            yield "cells of a joint grid", self.cells, "integers of at least 2"
        bounds = np.array([self.low, self.high], float)
        if not (np.isfinite(bounds).all() and (bounds[0] < bounds[1]).all()):
            box = (self.low, self.high)
            yield "box of a joint grid [rad]", box, "finite bounds with low < high"

    @property
    def n_joints(self) -> int:
        """Number of joints, which is the number of axes."""
        return len(self.cells)

    @property
    def shape(self) -> tuple[int, ...]:
        """Shape of an array with one value per cell."""
        return self.cells

    @property
    def size(self) -> int:
        """Number of cells of the whole grid."""
        return int(np.prod(self.cells, dtype=object))

    @cached_property
    def spacing(self) -> np.ndarray:
        """Distance of neighbouring centres (n_joints,) [rad]."""
        return (np.array(self.high) - np.array(self.low)) / np.array(self.cells)

    @property
    def bytes_needed(self) -> int:
        """Memory that the centres and a solution of Laplace's equation take [bytes]."""
        centres = _FLOAT_BYTES * self.n_joints * self.size
        return centres + bytes_needed(self.shape)

    def check_memory(self, limit_bytes: float | None = None) -> None:
        """Refuse a grid that is too large, before anything is allocated.

        Args:
            limit_bytes: what the grid may take [bytes]; by default a quarter of the
                machine's memory.

        Raises:
            InvalidValue: with the bytes that it would need.
        """
        if limit_bytes is None:
            limit_bytes = _MEMORY_SHARE * machine_memory()
        if self.bytes_needed > limit_bytes:
            cells = " x ".join(map(str, self.cells))
            what = f"memory that a grid of {cells} cells needs [bytes]"
            raise InvalidValue(what, self.bytes_needed, f"at most {limit_bytes:.0f}")

    def centres(self, axis: int) -> np.ndarray:
        """Angles of one joint at the centres of its cells (cells[axis],) [rad]."""
        index = np.arange(self.cells[axis])
        return self.low[axis] + (index + 0.5) * self.spacing[axis]

    def all_centres(self) -> np.ndarray:
        """Joint angles (size, n_joints) [rad] at every centre, last joint fastest."""
        axes = [self.centres(axis) for axis in range(self.n_joints)]
        return np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(
            -1, self.n_joints
        )

    def centre(self, index: np.ndarray) -> np.ndarray:
        """Joint angles (..., n_joints) [rad] at the centres of cells (same shape)."""
        return self.low + (np.asarray(index) + 0.5) * self.spacing

    def coordinates(self, joints: np.ndarray) -> np.ndarray:
        """Continuous cell index (..., n_joints) of joint angles (..., n_joints) [rad].

        An integer is a cell's centre: x = (q − low) / h − 1/2.
        """
        return (np.asarray(joints) - self.low) / self.spacing - 0.5

    def cell_of(self, joints: np.ndarray) -> np.ndarray:
        """Index (..., n_joints) of the cell around joint angles, or the nearest one."""
        nearest = np.floor(self.coordinates(joints) + 0.5).astype(np.intp)
        return np.clip(nearest, 0, np.array(self.cells) - 1)


def machine_memory() -> int:
    """Physical memory of this machine [bytes]."""
    return os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
