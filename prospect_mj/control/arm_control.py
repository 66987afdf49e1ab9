"""What every motion controller of one arm needs: twin and inverse kinematics."""

from dataclasses import dataclass

import mink

from prospect_mj.control.differential_ik import DifferentialIK
from prospect_mj.control.kinematics import KinematicTwin
from prospect_mj.robot.names import Side


@dataclass(frozen=True)
class ArmControl:
    """One arm's kinematics, shared by the controllers that move it in turn."""

    side: Side
    twin: KinematicTwin
    ik: DifferentialIK

    def grasp_pose(self) -> mink.SE3:
        """Pose of the hand's grasp site in the world, from the encoders."""
        return self.twin.grasp_pose(self.side)
