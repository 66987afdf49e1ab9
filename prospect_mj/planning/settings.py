"""Settings of harmonic gross motion planning."""

from dataclasses import dataclass, field, replace
from typing import Literal, Self, get_args

import numpy as np

from prospect_mj.checks import check_choice
from prospect_mj.errors import InvalidValue
from prospect_mj.planning.arm_kernels import FOLDED_CLEARANCE
from prospect_mj.planning.joint_grid import JointGrid
from prospect_mj.planning.laplace import SolverSettings
from prospect_mj.robot import wam

GROSS_JOINTS = 4
"""Shoulder and elbow: the joints of gross motion; the other three are the wrist's."""


Wrist = Literal["between", "goal", "start", "straight"]


@dataclass(frozen=True)
class Attempt:
    """With which grid, clearances and wrist a way is looked for."""

    refinement: int
    """Cells for each cell of the coarsest grid, along every joint."""
    cell_margin: float
    """Clearance of an arm at the centre of a free cell [m]."""
    path_margin: float
    """Clearance all along a way [m]; less only as far as its ends have less."""
    repairs: int = 20
    """How often cells where a way touches are closed before it is given up."""
    wrist: Wrist = "between"
    """How it is held on the way: between those of the start and of the goals; as at the
    goals or as at the start, which turns it on the spot before or after; straight."""

    def __post_init__(self) -> None:
        """Refuse margins and wrists that the occupancy map does not know.

        Raises:
            InvalidValue: on a margin that a hand beyond a bent elbow may not have, a
                path margin that allows contact, or on no refinement or repair at all.
            InvalidChoice: on a wrist that does not exist.
        """
        if not 0 <= self.cell_margin <= FOLDED_CLEARANCE:
            expected = f"0 to {FOLDED_CLEARANCE}"
            raise InvalidValue("cell margin [m]", self.cell_margin, expected)
        if not 0 <= self.path_margin < np.inf:
            raise InvalidValue("path margin [m]", self.path_margin, "at least 0")
        for name in ("refinement", "repairs"):
            value = getattr(self, name)
            if not isinstance(value, int) or value < 1:
                raise InvalidValue(name, value, "an integer of at least 1")
        check_choice("wrist", self.wrist, get_args(Wrist))


_TIGHT = Attempt(refinement=1, cell_margin=0.012, path_margin=0.008)
_FINE = Attempt(refinement=2, cell_margin=0.010, path_margin=0.006, repairs=6)
_WRISTS: tuple[Wrist, ...] = get_args(Wrist)


@dataclass(frozen=True)
class PlannerSettings:
    """Grid, clearances and effort of the planner."""

    cells: tuple[int, ...] = (16, 16, 16, 16)
    """Of the coarsest grid, for each gross joint."""
    attempts: tuple[Attempt, ...] = (
        Attempt(refinement=1, cell_margin=0.030, path_margin=0.015),
        *(replace(_TIGHT, wrist=wrist) for wrist in _WRISTS),
        *(replace(_FINE, wrist=wrist) for wrist in _WRISTS),
    )
    """One after the other until one shows a way: roomy and coarse ones come first."""
    end_zone: float = 0.4
    """Distance from an end up to which the way may be as near as that end [rad]."""
    step: float = 0.05
    """Arc length between the points of a path [rad]."""
    straight: float = 0.5
    """Goals nearer than this are gone to straight, if nothing is between [rad]."""
    solver: SolverSettings = field(
        default_factory=lambda: SolverSettings(over_relaxation=1.7, tolerance=1e-2)
    )
    """Of Laplace's equation; that no maximum is left matters more than many digits."""

    def __post_init__(self) -> None:
        """Refuse a grid of other joints, too coarse or too large, before it is made.

        Raises:
            InvalidValue: with the bytes that a grid would need if that is too much; on
                a step that is not positive or a distance that is negative.
        """
        if not 0 < self.step < np.inf:
            expected = "a positive number"
            raise InvalidValue("step of the planner [rad]", self.step, expected)
        for what, value in (("end zone", self.end_zone), ("straight", self.straight)):
            if not value >= 0:
                raise InvalidValue(f"{what} of the planner [rad]", value, "at least 0")
        if len(self.cells) != GROSS_JOINTS:
            expected = f"one number for each of {GROSS_JOINTS} joints"
            raise InvalidValue("cells of the planner's grid", self.cells, expected)
        if not self.attempts:
            raise InvalidValue("number of attempts of the planner", 0, "at least 1")
        for attempt in self.attempts:
            self.grid(attempt, np.array(wam.JOINT_LIMITS)).check_memory()

    @classmethod
    def with_cells(cls, n: int) -> Self:
        """The usual settings with another number of cells for each gross joint."""
        return cls(cells=(n,) * GROSS_JOINTS)

    def grid(self, attempt: Attempt, limits: np.ndarray) -> JointGrid:
        """The grid of an attempt.

        Args:
            attempt: one of `attempts`.
            limits: range of each joint of the arm (7, 2) [rad].
        """
        low, high = limits[:GROSS_JOINTS].T
        cells = tuple(attempt.refinement * n for n in self.cells)
        return JointGrid(tuple(low), tuple(high), cells)
