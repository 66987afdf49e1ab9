"""A slice of an arm's configuration space: two joints move, the others stay."""

from dataclasses import dataclass
from functools import cached_property

import mink
import numpy as np

from prospect_mj.control.kinematics import KinematicTwin
from prospect_mj.planning.arm_body import arm_body, geoms_of
from prospect_mj.planning.arm_kernels import clearances
from prospect_mj.planning.harmonic_field import HarmonicField, harmonic_field
from prospect_mj.planning.joint_grid import JointGrid
from prospect_mj.planning.laplace import SolverSettings
from prospect_mj.planning.streamline import Streamline, streamline
from prospect_mj.planning.surroundings import JarShape, KnownJars, Surroundings
from prospect_mj.robot import names, posture, wam
from prospect_mj.robot.names import SIDES, Side
from prospect_mj.sim.props import Obstacle, Props
from prospect_mj.sim.scene import JAR, OBSTACLE, TABLE, SceneSettings

SIDE: Side = "left"
"""The arm that moves; the other one is in front, as if it presented a jar."""
JOINTS = [0, 1]
"""The two that move, both in the shoulder."""
RESTING_JOINTS, RESTING = [2, 3], (-0.4, 0.8)
"""The other two gross joints, and their angles [rad]; the wrist is as at home."""
CELLS = (208, 160)
CLEARANCE = 0.01
"""Of a free cell [m]."""
SCENE = SceneSettings(props=Props(obstacle=Obstacle()))
POST = (0.45, 0.42)
"""Where the post stands on the table [m]."""
GOAL = (0.11, 1.66)
"""Joint angles [rad]: the hand in front of the chest."""
START = (0.60, 0.50)
"""Joint angles [rad]: the hand on the other side of the post."""
FREE = 0
"""In `obstacle`: no obstacle."""
KINDS = (
    "own upper arm",
    "table",
    "post",
    "other arm",
    "torso and head",
    "jar and fixtures",
)
"""What may be in the way; in `obstacle` numbered from 1."""
_STEP, _LONGEST = 0.01, 40.0
"""Arc length between points of a streamline, and of all of it [rad]."""


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

    def streamline(self, start: np.ndarray) -> Streamline:
        """The streamline from a start (2,) [rad]."""
        return streamline(self.field, start, _STEP, _LONGEST)


def configurations(moving: np.ndarray) -> np.ndarray:
    """Joint angles (n, 7) [rad] of the arm, the two that move being (n, 2) [rad]."""
    found = np.tile(posture.home(SIDE), (len(moving), 1))
    found[:, RESTING_JOINTS] = RESTING
    found[:, JOINTS] = moving
    return found


def joint_slice() -> Slice:
    """The slice among the real scene, a post in the way."""
    low, high = np.array(wam.JOINT_LIMITS)[JOINTS].T
    grid = JointGrid(tuple(low), tuple(high), CELLS)
    cells = configurations(grid.all_centres())
    robot = twin()
    arm = arm_body(robot.model, SIDE).arrays
    # The first kind has no solids, so that only the arm itself is looked at.
    room = [clearances(arm, cells, rows, 2 * CLEARANCE) for rows in _kinds(robot)]
    # Where several are in the way, the nearest one counts; the arm itself before all.
    nearest = np.argmin(room, axis=0) + 1
    obstacle = np.where(np.min(room, axis=0) < CLEARANCE, nearest, FREE)
    return Slice(grid, obstacle.reshape(grid.shape))


def twin() -> KinematicTwin:
    """The robot's own model of the scene."""
    found = KinematicTwin(SCENE)
    angles = np.empty(found.model.nq)
    for side in SIDES:
        pose = posture.home(side) if side == SIDE else posture.presenting(side)
        angles[found.columns(side)] = pose
    found.place_obstacle(np.array(POST))
    found.configuration.update(angles)
    return found


def known_jars() -> KnownJars:
    """The jar, lying in its cradle."""
    jar, place = SCENE.props.jar, SCENE.props.pedestal.nominal
    turn = mink.SO3.from_x_radians(-np.pi / 2)
    lying = mink.SE3.from_rotation_and_translation(turn, place)
    return KnownJars(JarShape(jar.lid_radius, jar.length), placed=lying)


def _kinds(robot: KinematicTwin) -> list[np.ndarray]:
    """Solids (n, 18) of each of the `KINDS`."""
    around = Surroundings(robot.model, SIDE)
    solids = np.concatenate([around.fixed, around.moving(robot.data, known_jars())])
    kinds = np.array([_kind(robot, row) for row in solids])
    return [solids[kinds == kind] for kind in KINDS]


def _kind(robot: KinematicTwin, row: np.ndarray) -> str:
    """What a solid (18,) is part of, told by the geom that is where it is."""
    model = robot.model
    here = np.abs(robot.data.geom_xpos - row[3:6]).max(axis=1) < 1e-9
    geoms = set(np.flatnonzero(here & (model.geom_type == int(row[0]))).tolist())
    if geoms & set(geoms_of(model, names.other(SIDE))):
        return "other arm"
    bodies = {model.body(model.geom_bodyid[g]).name for g in geoms}
    named = {f"{TABLE}/": "table", f"{OBSTACLE}/": "post"}
    # The jar is no geom of the twin.
    body = next(iter(bodies), f"{JAR}/")
    # Only the torso's own bodies have names without a prefix.
    return named.get(body, KINDS[-1] if "/" in body else "torso and head")
