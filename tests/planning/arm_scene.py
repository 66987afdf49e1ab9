"""Arms among the scene's solids, and their true clearance by MuJoCo's own distances."""

import copy
import functools

import mink
import mujoco
import numpy as np
from reach_pairs import SCENE

from prospect_mj.planning.surroundings import JarShape, KnownJars
from prospect_mj.robot import names, posture, wam
from prospect_mj.sim.scene import compile_twin, obstacle_mocap

JAR = JarShape(SCENE.props.jar.lid_radius, SCENE.props.jar.length)
NO_JAR = KnownJars(JAR)
IN_HAND = mink.SE3.from_rotation_and_translation(
    mink.SO3.from_x_radians(0.1), np.array([0.003, -0.002, 0.058])
)
"""Of a jar gripped by its end: its centre beyond the grasp site, a little askew."""
FAR = 0.3
"""Larger distances are not told apart [m]."""


def in_hand(side):
    """The jar in one hand."""
    return KnownJars(JAR, {side: IN_HAND})


def limits(side):
    """Lower and upper joint limits, each (7,) [rad]."""
    ends = [posture.reflected(bound, side) for bound in np.array(wam.JOINT_LIMITS).T]
    return np.minimum(*ends), np.maximum(*ends)


def random_joints(side, rng, n, margin=0.05):
    """Joint angles (n, 7) [rad] within the limits."""
    low, high = limits(side)
    return rng.uniform(low + margin, high - margin, (n, wam.N_JOINTS))


@functools.cache
def _twin():
    return compile_twin(SCENE, posture.OPEN)


class ArmScene:
    """A robot model with both arms at home, the post where it is put.

    A jar is not part of the model: a spare geom stands for it where there is one.
    """

    def __init__(self, jars=NO_JAR):
        self.model = copy.copy(_twin())
        self.data = mujoco.MjData(self.model)
        self.jars = jars
        for side in names.SIDES:
            self.put(side, posture.home(side))
        self.place_post(SCENE.props.obstacle.position)

    def put(self, side, joints):
        self.data.qpos[columns(self.model, side)] = joints
        mujoco.mj_kinematics(self.model, self.data)

    def place_post(self, position):
        self.data.mocap_pos[obstacle_mocap(self.model), :2] = position
        mujoco.mj_kinematics(self.model, self.data)

    def hand(self, side, joints):
        """Pose of the grasp site at joint angles (7,) [rad]."""
        data = copy.copy(self.data)
        data.qpos[columns(self.model, side)] = joints
        mujoco.mj_kinematics(self.model, data)
        return site_pose(data, side)


def columns(model, side):
    """Indices (7,) of an arm's joints in `qpos`."""
    return [model.joint(name).qposadr[0] for name in names.arm_joints(side)]


def site_pose(data, side):
    site = data.site(names.grasp_site(side))
    turn = mink.SO3.from_matrix(site.xmat.reshape(3, 3).copy())
    return mink.SE3.from_rotation_and_translation(turn, site.xpos.copy())


class TrueClearance:
    """Least distance of an arm with its open hand and jar to everything [m].

    Counted are all pairs that can meet: what the arm moves against what it does not,
    and its hand against its upper arm.
    """

    def __init__(self, scene, side):
        self._side, self._jars = side, scene.jars
        self._columns = columns(scene.model, side)
        self.model, self._data = copy.copy(scene.model), copy.copy(scene.data)
        self._links = [self.model.body(name).id for name in names.arm_links(side)]
        rows = range(self.model.ngeom)
        plane = mujoco.mjtGeom.mjGEOM_PLANE
        of = [self._link_of(g) for g in rows]
        world = [g for g in rows if of[g] < 0 and self.model.geom_type[g] != plane]
        shoulder = [g for g in rows if of[g] in (0, 1)]
        upper = [g for g in rows if of[g] == 2]
        beyond = [g for g in rows if of[g] > 2]
        hand = [g for g in rows if of[g] == 6]
        self._groups = [(upper + beyond, world), (beyond, shoulder), (hand, upper)]
        self._world, self._trunk = world, shoulder + upper
        self._spare = self._made_jar()

    def _link_of(self, geom):
        """Number of the arm's link that a geom is part of; -1 if of none."""
        body = self.model.geom_bodyid[geom]
        while body:
            if body in self._links:
                return self._links.index(body)
            body = self.model.body_parentid[body]
        return -1

    def _made_jar(self):
        """The lamp's foot, out of reach in its corner, becomes a jar."""
        geom, shape = self.model.geom("lamp/foot").id, self._jars.shape
        self._world.remove(geom)
        self.model.geom_size[geom] = [shape.radius, shape.length / 2, 0.0]
        self.model.geom_rbound[geom] = np.hypot(shape.radius, shape.length / 2)
        return geom

    def _distance(self, first, second):
        return mujoco.mj_geomDistance(self.model, self._data, first, second, FAR, None)

    def _jar_poses(self):
        """Where there are jars, and the geoms that each must keep clear of."""
        own, rival = self._side, names.other(self._side)
        arm = self._groups[0][0]
        if own in self._jars.held:
            hand = site_pose(self._data, own)
            yield hand @ self._jars.held[own], self._world + self._trunk
        if rival in self._jars.held:
            yield site_pose(self._data, rival) @ self._jars.held[rival], arm
        if self._jars.placed is not None:
            yield self._jars.placed, arm

    def __call__(self, joints):
        """At joint angles (7,) [rad]; two jars at once are not compared."""
        self._data.qpos[self._columns] = joints
        mujoco.mj_kinematics(self.model, self._data)
        near = [
            self._distance(a, b) for one, two in self._groups for a in one for b in two
        ]
        for pose, others in self._jar_poses():
            self._data.geom_xpos[self._spare] = pose.translation()
            self._data.geom_xmat[self._spare] = pose.rotation().as_matrix().ravel()
            near += [self._distance(self._spare, b) for b in others]
        return min(near)
