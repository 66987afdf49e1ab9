"""What an arm must keep clear of: fixtures, and what moves between two plans."""

from dataclasses import dataclass, field

import mink
import mujoco
import numpy as np

from prospect_mj.planning.arm_body import (
    BEYOND_ELBOW,
    EVERY_LINK,
    ArmBody,
    geoms_of,
)
from prospect_mj.planning.solids import cylinder, solids
from prospect_mj.robot import names
from prospect_mj.robot.names import Side


@dataclass(frozen=True)
class JarShape:
    """A jar as the planner sees it: the cylinder round it."""

    radius: float
    """[m]"""
    length: float
    """[m]"""


@dataclass(frozen=True)
class KnownJars:
    """Where the robot believes the jar to be, hand by hand or lying somewhere."""

    shape: JarShape
    held: dict[Side, mink.SE3] = field(default_factory=dict)
    """Pose in the grasp frame of each hand that holds it."""
    placed: mink.SE3 | None = None
    """Pose in the world of a jar that no hand holds."""


class Surroundings:
    """Solids round one arm, taken from MuJoCo's collision geometry.

    Args:
        model: of the robot and what stands around it, without a jar.
        side: the arm.

    Attributes:
        fixed: solids that never move (n, 18).
    """

    def __init__(self, model: mujoco.MjModel, side: Side) -> None:
        """Sort the model's geoms."""
        self._model, self._rival = model, names.other(side)
        data = mujoco.MjData(model)
        mujoco.mj_kinematics(model, data)
        arms = {g for s in names.SIDES for g in geoms_of(model, s)}
        rest = [g for g in range(model.ngeom) if g not in arms and _is_solid(model, g)]
        still = [g for g in rest if not _is_mocap(model, g)]
        # The upper arm grows out of its own shoulder.
        shoulder = [model.body(n).id for n in names.arm_links(side)[:2]]
        own = [g for g in still if model.geom_bodyid[g] in shoulder]
        others = [g for g in still if g not in own]
        self.fixed = np.concatenate(
            [
                solids(model, data, others, EVERY_LINK),
                solids(model, data, own, BEYOND_ELBOW),
            ]
        )
        self._moving_geoms = [g for g in rest if _is_mocap(model, g)]
        self._moving_geoms += geoms_of(model, self._rival)

    def moving(self, data: mujoco.MjData, jars: KnownJars) -> np.ndarray:
        """Solids (n, 18) that stand where they are now, but may be elsewhere later.

        Args:
            data: kinematics of the model, up to date.
            jars: where a jar is believed to be.
        """
        rows = [solids(self._model, data, self._moving_geoms, EVERY_LINK)]
        poses = [jars.placed] if jars.placed is not None else []
        if self._rival in jars.held:
            site = data.site(names.grasp_site(self._rival))
            turn = mink.SO3.from_matrix(site.xmat.reshape(3, 3))
            hand = mink.SE3.from_rotation_and_translation(turn, site.xpos)
            poses.append(hand @ jars.held[self._rival])
        rows += [_as_solid(pose, jars.shape)[None] for pose in poses]
        return np.concatenate(rows)


def body_with(body: ArmBody, jars: KnownJars) -> ArmBody:
    """An arm with the jar that its hand is believed to hold, if any."""
    if body.side not in jars.held:
        return body
    return body.holding(jars.held[body.side], jars.shape.radius, jars.shape.length)


def _as_solid(pose: mink.SE3, shape: JarShape) -> np.ndarray:
    turn = pose.rotation().as_matrix()
    return cylinder(
        pose.translation(), turn, shape.radius, shape.length / 2, EVERY_LINK
    )


def _is_solid(model: mujoco.MjModel, geom: int) -> bool:
    """Whether it collides and is not the floor, which no arm reaches."""
    plane = model.geom_type[geom] == mujoco.mjtGeom.mjGEOM_PLANE
    return bool(model.geom_contype[geom] or model.geom_conaffinity[geom]) and not plane


def _is_mocap(model: mujoco.MjModel, geom: int) -> bool:
    """Whether it is on a mocap body: it can be put elsewhere between two plans."""
    return bool(model.body_mocapid[model.geom_bodyid[geom]] >= 0)
