"""One arm as the planner sees it: a chain of joints, its links covered by spheres."""

from dataclasses import dataclass, replace
from typing import NamedTuple

import mink
import mujoco
import numpy as np

from prospect_mj.planning.arm_kernels import FRAME_OF, HAND, JAR, N_LINKS, UPPER_ARM
from prospect_mj.planning.solids import solids
from prospect_mj.planning.sphere_cover import bounding_sphere, cover
from prospect_mj.robot import names
from prospect_mj.robot.names import Side

EVERY_LINK = (1 << N_LINKS) - 1
BEYOND_ELBOW = EVERY_LINK & ~(1 << UPPER_ARM)
HAND_AND_JAR = (1 << HAND) | (1 << JAR)

_SHOULDER = 2
"""Links 1 and 2 turn on the spot: they belong to what stands still."""


class Arrays(NamedTuple):
    """What the compiled code needs of an arm; see `ArmBody`."""

    base: np.ndarray
    joints: np.ndarray
    spheres: np.ndarray
    first: np.ndarray
    hulls: np.ndarray
    upper: np.ndarray


@dataclass(frozen=True)
class ArmBody:
    """Kinematic chain and geometry of one arm with its open hand."""

    side: Side
    base: np.ndarray
    """Frame that joint 1 turns in: position, rotation matrix row by row (12,)."""
    joints: np.ndarray
    """Place of each joint in the link before it and its axis (7, 6)."""
    spheres: np.ndarray
    """Centre and radius in the link's frame, link by link (m, 4) [m]."""
    first: np.ndarray
    """Of each link, the first of its spheres; one more for the end (5,)."""
    hulls: np.ndarray
    """A sphere round all spheres of each link (4, 4) [m]."""
    upper: np.ndarray
    """The upper arm as solids in its own frame (n, 18): the hand can hit it."""
    grasp: mink.SE3
    """The grasp site in the last link's frame."""
    limits: np.ndarray
    """Range of each joint (7, 2) [rad]."""

    @property
    def arrays(self) -> Arrays:
        """The same for compiled code."""
        return Arrays(*(getattr(self, name) for name in Arrays._fields))

    def holding(self, jar: mink.SE3, radius: float, length: float) -> "ArmBody":
        """The same arm with a jar in its hand.

        Args:
            jar: its pose in the frame of the grasp site.
            radius: of a cylinder along z round it [m].
            length: of the same [m].
        """
        along = cover(mujoco.mjtGeom.mjGEOM_CYLINDER, np.array([radius, length / 2, 0]))
        spheres = _placed(along, self.grasp @ jar)
        groups = np.split(self.spheres[: self.first[JAR]], self.first[1:JAR])
        return replace(self, **_grouped([*groups, spheres]))


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
    upper = [g for g in moving if model.geom_bodyid[g] == bodies[_SHOULDER]]
    groups = [
        _link_spheres(model, data, bodies[FRAME_OF[link] - 1], geoms)
        for link, geoms in enumerate(_by_link(model, bodies, moving))
    ]
    return ArmBody(
        side=side,
        base=np.concatenate(origin),
        joints=np.hstack([offsets, model.jnt_axis[joints]]),
        upper=_in_frame(solids(model, data, upper, HAND_AND_JAR), data, bodies[2]),
        grasp=_grasp(model, data, side, bodies[-1]),
        limits=model.jnt_range[joints].copy(),
        **_grouped([*groups, np.empty((0, 4))]),
    )


def geoms_of(model: mujoco.MjModel, side: Side) -> list[int]:
    """Geoms of an arm that change place with it, in order of the model."""
    root = model.body(names.arm_links(side)[_SHOULDER]).id
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
        _placed(
            cover(int(model.geom_type[g]), model.geom_size[g]),
            frame @ _frame(data.geom_xpos[g], data.geom_xmat[g]),
        )
        for g in geoms
    ]
    return np.concatenate(parts)


def _placed(along: np.ndarray, pose: mink.SE3) -> np.ndarray:
    """Spheres (n, 4) of a cover (n, 2) along the z axis of a pose."""
    axis = pose.rotation().as_matrix()[:, 2]
    centres = pose.translation() + np.outer(along[:, 0], axis)
    return np.column_stack([centres, along[:, 1]])


def _grouped(groups: list[np.ndarray]) -> dict[str, np.ndarray]:
    hulls = [bounding_sphere(g) if len(g) else np.zeros(4) for g in groups]
    return {
        "spheres": np.concatenate(groups),
        "first": np.cumsum([0, *(len(g) for g in groups)]),
        "hulls": np.array(hulls),
    }


def _in_frame(rows: np.ndarray, data: mujoco.MjData, body: int) -> np.ndarray:
    """Solids in a body's frame instead of the world's."""
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
