"""Settings of harmonic gross motion planning."""

from dataclasses import dataclass, field

from prospect_mj.planning.laplace import SolverSettings


@dataclass(frozen=True)
class PlannerSettings:
    """Grid, clearances and effort of the planner."""

    cells: tuple[int, int, int, int] = (16, 16, 16, 16)
    """Of the grid, for each gross joint."""
    refinements: int = 1
    """How often a grid that shows no way is made twice as fine."""
    cell_margin: float = 0.03
    """Clearance of an arm at the centre of a free cell [m]."""
    path_margin: float = 0.015
    """Clearance all along a path [m]; less only as far as its ends have less."""
    end_zone: float = 0.4
    """Distance from an end up to which the path may be as near as that end [rad]."""
    step: float = 0.05
    """Arc length between the points of a path [rad]."""
    straight: float = 0.5
    """Goals nearer than this are gone to straight, if nothing is between [rad]."""
    repairs: int = 30
    """How often cells where a path touches are closed before the grid is given up."""
    solver: SolverSettings = field(
        default_factory=lambda: SolverSettings(over_relaxation=1.7, tolerance=1e-2)
    )
    """Of Laplace's equation; that no maximum is left matters more than many digits."""
