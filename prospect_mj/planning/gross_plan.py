"""A way that the planner has found, and how far along it an arm is."""

import dataclasses
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from prospect_mj.planning.harmonic_field import HarmonicField
from prospect_mj.planning.query import Query

Cell = tuple[int, ...]


@dataclass(frozen=True, eq=False)
class GrossPlan:
    """A way for one arm, which keeps its clearance all along."""

    query: Query
    """The question that it answers."""
    path: np.ndarray
    """Joint angles (n, 7) [rad], from where it starts to one of the goals."""
    goal: int
    """Number of this goal."""
    last_stretch: float
    """Arc length of the straight way from the goal cell to the goal [rad]."""
    field: HarmonicField | None = None
    """The harmonic function whose streamline it follows; None: it is straight."""
    goal_of: dict[Cell, int] = dataclasses.field(default_factory=dict)
    """Goal cells of the field, each with the goal that lies straight ahead of it."""

    @cached_property
    def _lengths(self) -> np.ndarray:
        """Arc length at each point of the path (n,) [rad]."""
        steps = np.linalg.norm(np.diff(self.path, axis=0), axis=1)
        return np.concatenate([[0.0], np.cumsum(steps)])

    def _nearest(self, joints: np.ndarray) -> int:
        return int(np.argmin(np.linalg.norm(self.path - joints, axis=1)))

    def length_left(self, joints: np.ndarray) -> float:
        """Arc length to the goal from the point nearest to joint angles (7,) [rad]."""
        return float(self._lengths[-1] - self._lengths[self._nearest(joints)])

    def ahead(self, joints: np.ndarray, length: float) -> np.ndarray:
        """The point (7,) [rad] an arc length [rad] beyond the one that is nearest."""
        at = self._lengths[self._nearest(joints)] + length
        return self.path[min(np.searchsorted(self._lengths, at), len(self.path) - 1)]
