"""The kinematic twin: where the robot believes its links to be, from its encoders."""

import mink
import mujoco
import numpy as np

from prospect_mj.robot import names, posture
from prospect_mj.robot.names import SIDES, Side
from prospect_mj.robot.torso import Reading
from prospect_mj.sim.scene import PEDESTAL, SceneSettings, compile_twin, obstacle_mocap


class KinematicTwin:
    """A robot-only model that follows the encoders; the jar is not in it.

    Args:
        settings: of the scene whose fixtures it contains.

    Attributes:
        model: 14 arm joints; fingers welded open; table, well, lamp, pedestal,
            obstacle.
        configuration: mink's view of it at the last update.
    """

    def __init__(self, settings: SceneSettings) -> None:
        """Compile the twin at its home posture."""
        self.model = compile_twin(settings, posture.OPEN)
        home = np.concatenate([posture.home(side) for side in SIDES])
        self.configuration = mink.Configuration(self.model, q=home)
        self._columns = {
            side: np.array([self.model.joint(n).dofadr[0] for n in joints])
            for side in SIDES
            if (joints := names.arm_joints(side))
        }
        pedestal = self.model.body(f"{PEDESTAL}/").id
        self._mocap = int(self.model.body_mocapid[pedestal])

    @property
    def data(self) -> mujoco.MjData:
        """Its kinematics at the last update."""
        return self.configuration.data

    def columns(self, side: Side) -> np.ndarray:
        """Indices (7,) of an arm's joints among the twin's 14."""
        return self._columns[side]

    def update(self, reading: Reading) -> None:
        """Take over the measured joint angles."""
        angles = np.empty(self.model.nq)
        for side, columns in self._columns.items():
            angles[columns] = reading[side].joints
        # mink rejects a configuration outside of the limits; encoders may show one
        # by a hair while a servo settles on its limit.
        low, high = self.model.jnt_range.T
        self.configuration.update(np.clip(angles, low, high))

    def dynamics(
        self, side: Side, velocities: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        """Inertia (7, 7) [kg m^2] of an arm where it is, and the torques of its motion.

        Args:
            side: the arm; the other one counts as resting.
            velocities: of its joints (7,) [rad/s].

        Returns:
            The inertia, and what gravity, centripetal terms and friction take of each
            joint's torque (7,) [N m]. What the hand holds is not in it.
        """
        data, own = self.data, self._columns[side]
        data.qvel[:] = 0.0
        data.qvel[own] = velocities
        mujoco.mj_comVel(self.model, data)
        mujoco.mj_rne(self.model, data, 0, data.qfrc_bias)
        mujoco.mj_crb(self.model, data)
        inertia = np.empty((self.model.nv, self.model.nv))
        mujoco.mj_fullM(self.model, data, inertia)
        friction = self.model.dof_damping[own] * velocities
        return inertia[np.ix_(own, own)], data.qfrc_bias[own] + friction

    def place_pedestal(self, position: np.ndarray, yaw: float) -> None:
        """Put the cradle under where the jar was seen: position (3,) [m], yaw [rad]."""
        data = self.configuration.data
        data.mocap_pos[self._mocap] = position
        data.mocap_quat[self._mocap] = mink.SO3.from_z_radians(yaw).wxyz

    def place_obstacle(self, position: np.ndarray) -> None:
        """Tell the robot where the obstacle stands: centre (2,) [m] on the table.

        Raises:
            InvalidValue: if the scene has none.
        """
        data = self.configuration.data
        data.mocap_pos[obstacle_mocap(self.model), :2] = position

    def grasp_pose(self, side: Side) -> mink.SE3:
        """Pose of a hand's grasp site in the world."""
        site = names.grasp_site(side)
        return self.configuration.get_transform_frame_to_world(site, "site")

    def wrist_rotation(self, side: Side) -> np.ndarray:
        """Rotation matrix (3, 3) from the wrist's frame to the world's."""
        site = names.wrist(side)
        pose = self.configuration.get_transform_frame_to_world(site, "site")
        return pose.rotation().as_matrix()
