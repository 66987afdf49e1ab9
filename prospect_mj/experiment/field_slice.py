"""A slice of an arm's configuration space: two joints move, the others stay at home."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from prospect_mj.control.kinematics import KinematicTwin
from prospect_mj.planning.arm_body import ArmBody, arm_body
from prospect_mj.planning.arm_kernels import clearances
from prospect_mj.planning.harmonic_field import HarmonicField, harmonic_field
from prospect_mj.planning.joint_grid import JointGrid
from prospect_mj.planning.laplace import SolverSettings
from prospect_mj.planning.streamline import Streamline, streamline
from prospect_mj.planning.surroundings import JarShape, KnownJars, Surroundings
from prospect_mj.robot import posture, wam
from prospect_mj.sim.props import Obstacle, Props
from prospect_mj.sim.scene import SceneSettings

JOINTS = (0, 3)
"""Shoulder (J1) and elbow (J4) of the left arm."""
CELLS = (208, 160)
CLEARANCE = 0.01
"""Of a free cell [m]."""
POST = (0.45, 0.42)
"""Where the post stands on the table [m]."""
GOAL = (1.85, 0.55)
"""Joint angles [rad]."""
STEP = 0.01
"""Arc length between points of a streamline [rad]."""
FREE = 0
"""In `obstacle`: no obstacle."""
KINDS = ("own upper arm", "table", "post", "trunk and head", "lamp, well, cradle")
"""What may be in the way; in `obstacle` numbered from 1."""


@dataclass(frozen=True)
class Slice:
    """Two joints' space, with what is in the way."""

    grid: JointGrid
    obstacle: np.ndarray
    """Number of what is in the way in `KINDS`, from 1, or FREE, of the grid's shape."""

    @cached_property
    def field(self) -> HarmonicField:
        """The harmonic function whose goal is at `GOAL`."""
        free = self.obstacle == FREE
        goal = np.zeros(free.shape, bool)
        goal[tuple(self.grid.cell_of(np.array(GOAL)))] = True
        return harmonic_field(self.grid, free, goal, SolverSettings(tolerance=1e-6))

    def streamlines(self, starts: np.ndarray) -> list[Streamline]:
        """Streamlines from starts (n, 2) [rad]."""
        return [streamline(self.field, start, STEP, 40.0) for start in starts]


def joint_slice() -> Slice:
    """The slice of the left arm among the real scene, a post before it."""
    twin = KinematicTwin(SceneSettings(props=Props(obstacle=Obstacle())))
    twin.place_obstacle(np.array(POST))
    twin.configuration.update()
    body = arm_body(twin.model, "left")
    low, high = np.array(wam.JOINT_LIMITS)[list(JOINTS)].T
    grid = JointGrid(tuple(low), tuple(high), CELLS)
    # The first kind, the arm itself, has no solids of its own: it is always looked at.
    near = [_near(body, grid, rows) for rows in _kinds(twin)]
    # Where several are in the way, the first one counts.
    obstacle = np.select(near, range(1, len(KINDS) + 1), FREE)
    return Slice(grid, obstacle.reshape(grid.shape))


def _near(body: ArmBody, grid: JointGrid, rows: np.ndarray) -> np.ndarray:
    """Whether the arm is too near to solids (n, 18), for each of the grid's cells."""
    configurations = np.tile(posture.home(body.side), (grid.size, 1))
    configurations[:, list(JOINTS)] = grid.all_centres()
    return clearances(body.arrays, configurations, rows, CLEARANCE) < CLEARANCE


def _kinds(twin: KinematicTwin) -> list[np.ndarray]:
    """Solids (n, 18) of each of the `KINDS`."""
    around = Surroundings(twin.model, "left")
    rows = [around.fixed, around.moving(twin.data, KnownJars(JarShape(0.05, 0.17)))]
    solids = np.concatenate(rows)
    names = [_owner(twin, row) for row in solids]
    belong = {"table": 1, "obstacle": 2, "trunk": 3, "head": 3, "left": 3}
    kinds = np.array([belong.get(name, 4) for name in names])
    return [solids[kinds == kind] for kind in range(len(KINDS))]


def _owner(twin: KinematicTwin, row: np.ndarray) -> str:
    """First part of the name of the body that a solid belongs to."""
    away = np.linalg.norm(twin.data.geom_xpos - row[3:6], axis=1)
    away[twin.model.geom_type != int(row[0])] = np.inf
    body = twin.model.body(twin.model.geom_bodyid[int(np.argmin(away))]).name
    return body.split("/")[0].split("_")[0]
