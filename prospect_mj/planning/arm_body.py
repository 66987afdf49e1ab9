"""One arm as the planner sees it: a chain of joints, its links covered by spheres."""

from dataclasses import dataclass, replace
from typing import NamedTuple

import mink
import mujoco
import numpy as np

from prospect_mj.planning.arm_kernels import FRAME_OF, HAND, JAR, UPPER_ARM
from prospect_mj.planning.solids import solids
from prospect_mj.planning.sphere_cover import bounding_sphere, cover
from prospect_mj.robot import names
from prospect_mj.robot.names import Side

EVERY_LINK = (1 << (JAR + 1)) - 1
BEYOND_ELBOW = EVERY_LINK & ~(1 << UPPER_ARM)
HAND_AND_JAR = (1 << HAND) | (1 << JAR)

_FIRST_MOVING = 2
"""Index of link 3. Links 1 and 2 turn on the spot: they belong to what stands still."""


class Arrays(NamedTuple):
    """What the compiled code needs of an arm."""

    base: np.ndarray
    """Frame that joint 1 turns in (12,): position [m], rotation matrix [1] row by
    row."""
    joints: np.ndarray
    """Of each joint (7, 6): its place in the frame before it [m], its axis [1]."""
    wrist: np.ndarray
    """The wrist's centre in the forearm's frame (1, 3) [m]."""
    upper_arm: np.ndarray
    """Spheres that cover it, after one round all of them, in its frame (m, 4) [m]."""
    forearm: np.ndarray
    """The same (m, 4) [m]."""
    hand: np.ndarray
    """The same, in the last link's frame (m, 4) [m]."""
    jar: np.ndarray
    """The same; without a row if the hand holds none (m, 4) [m]."""
    upper_solids: np.ndarray
    """The upper arm as solids in its own frame (n, 18), see `arm_kernels`: the hand can
    hit it."""


@dataclass(frozen=True)
class ArmBody:
    """Kinematic chain and geometry of one arm with its open hand."""

    side: Side
    arrays: Arrays
    grasp: mink.SE3
    """The grasp site in the last link's frame."""
    limits: np.ndarray
    """Range of each joint (7, 2) [rad]."""

    def holding(self, jar: mink.SE3, radius: float, length: float) -> "ArmBody":
        """The same arm with a jar in its hand.

        Args:
            jar: its pose in the frame of the grasp site.
            radius: of a cylinder along z round it [m].
            length: of the same [m].
        """
        along = cover(mujoco.mjtGeom.mjGEOM_CYLINDER, np.array([radius, length / 2, 0]))
        spheres = _in_one(_spheres_at(along, self.grasp @ jar))
        return replace(self, arrays=self.arrays._replace(jar=spheres))

    @property
    def reach(self) -> float:
        """Of hand and jar from the wrist's centre [m]."""
        spheres = np.concatenate([self.arrays.hand[1:], self.arrays.jar[1:]])
        return float((np.linalg.norm(spheres[:, :3], axis=1) + spheres[:, 3]).max())


def arm_body(model: mujoco.MjModel, side: Side) -> ArmBody:
    """Read an arm off a model whose arm joints are all at zero in qpos0."""
    data = mujoco.MjData(model)
    mujoco.mj_kinematics(model, data)
    bodies = [model.body(name).id for name in names.arm_links(side)]
    joints = [model.joint(name).id for name in names.arm_joints(side)]
    offsets = np.array([model.body_pos[b] for b in bodies])
    offsets[0] = 0.0
    origin = data.xpos[bodies[0]], data.xmat[bodies[0]]
    moving = geoms_of(model, side)
    first = bodies[_FIRST_MOVING]
    upper = [g for g in moving if model.geom_bodyid[g] == first]
    covers = [
        _in_one(_link_spheres(model, data, bodies[FRAME_OF[link] - 1], geoms))
        for link, geoms in enumerate(_by_link(model, bodies, moving))
    ]
    chain = Arrays(
        np.concatenate(origin),
        np.hstack([offsets, model.jnt_axis[joints]]),
        offsets[4:6].sum(axis=0, keepdims=True),
        *covers,
        np.empty((0, 4)),
        _in_frame(solids(model, data, upper, HAND_AND_JAR), data, first),
    )
    grasp = _grasp(model, data, side, bodies[-1])
    return ArmBody(side, chain, grasp, model.jnt_range[joints].copy())


def geoms_of(model: mujoco.MjModel, side: Side) -> list[int]:
    """Geoms of an arm that change place with it, in order of the model."""
    root = model.body(names.arm_links(side)[_FIRST_MOVING]).id
    return [
        g for g in range(model.ngeom) if _is_under(model, model.geom_bodyid[g], root)
    ]


def _is_under(model: mujoco.MjModel, body: int, root: int) -> bool:
    while body > root:
        body = model.body_parentid[body]
    return body == root


def _by_link(
    model: mujoco.MjModel, bodies: list[int], geoms: list[int]
) -> list[list[int]]:
    """Geoms of upper arm, forearm and hand; bodies are numbered from the root on."""
    elbow, flange = bodies[3], bodies[6]
    of = [model.geom_bodyid[g] for g in geoms]
    return [
        [g for g, body in zip(geoms, of, strict=True) if low <= body < high]
        for low, high in ((0, elbow), (elbow, flange), (flange, model.nbody))
    ]


def _link_spheres(
    model: mujoco.MjModel, data: mujoco.MjData, body: int, geoms: list[int]
) -> np.ndarray:
    frame = _frame(data.xpos[body], data.xmat[body]).inverse()
    parts = [
        _spheres_at(
            cover(int(model.geom_type[g]), model.geom_size[g]),
            frame @ _frame(data.geom_xpos[g], data.geom_xmat[g]),
        )
        for g in geoms
    ]
    return np.concatenate(parts)


def _spheres_at(along: np.ndarray, pose: mink.SE3) -> np.ndarray:
    """Spheres (n, 4) [m] of a cover (n, 2) [m] along the z axis of a pose."""
    axis = pose.rotation().as_matrix()[:, 2]
    centres = pose.translation() + np.outer(along[:, 0], axis)
    return np.column_stack([centres, along[:, 1]])


def _in_one(spheres: np.ndarray) -> np.ndarray:
    """Spheres (1 + n, 4) [m]: one round all of them, then they themselves."""
    return np.vstack([bounding_sphere(spheres), spheres])


def _in_frame(rows: np.ndarray, data: mujoco.MjData, body: int) -> np.ndarray:
    """Solids (n, 18) in a body's frame instead of the world's."""
    turn = data.xmat[body].reshape(3, 3)
    local = rows.copy()
    local[:, 3:6] = (rows[:, 3:6] - data.xpos[body]) @ turn
    local[:, 6:15] = (turn.T @ rows[:, 6:15].reshape(-1, 3, 3)).reshape(-1, 9)
    return local


def _grasp(
    model: mujoco.MjModel, data: mujoco.MjData, side: Side, body: int
) -> mink.SE3:
    site = data.site(names.grasp_site(side))
    flange = _frame(data.xpos[body], data.xmat[body])
    return flange.inverse() @ _frame(site.xpos, site.xmat)


def _frame(position: np.ndarray, rotation: np.ndarray) -> mink.SE3:
    turn = mink.SO3.from_matrix(rotation.reshape(3, 3))
    return mink.SE3.from_rotation_and_translation(turn, position)
