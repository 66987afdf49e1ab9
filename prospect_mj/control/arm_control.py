"""What every motion controller of one arm needs: twin, inverse kinematics, planner."""

from dataclasses import dataclass
from typing import Literal, get_args

import mink
import numpy as np

from prospect_mj.checks import check_choice
from prospect_mj.control.differential_ik import DifferentialIK
from prospect_mj.control.kinematics import KinematicTwin
from prospect_mj.planning.planner import GrossPlanner
from prospect_mj.planning.settings import PlannerSettings
from prospect_mj.robot.names import Side

GrossMotion = Literal["harmonic", "cartesian"]
GROSS_MOTIONS: tuple[GrossMotion, ...] = get_args(GrossMotion)


@dataclass(frozen=True)
class ArmControl:
    """One arm's kinematics, shared by the controllers that move it in turn."""

    side: Side
    twin: KinematicTwin
    ik: DifferentialIK
    planner: GrossPlanner | None = None
    """Of large movements; None: they go straight."""

    def joints(self) -> np.ndarray:
        """Joint angles (7,) [rad], from the encoders."""
        return self.twin.configuration.q[self.twin.columns(self.side)]

    def grasp_pose(self) -> mink.SE3:
        """Pose of the hand's grasp site in the world, from the encoders."""
        return self.twin.grasp_pose(self.side)


def arm_control(
    side: Side,
    twin: KinematicTwin,
    gross_motion: GrossMotion = "harmonic",
    planning: PlannerSettings | None = None,
) -> ArmControl:
    """An arm that makes large movements in one of two ways.

    Args:
        side: the arm.
        twin: shared by all controllers.
        gross_motion: `harmonic` along streamlines, `cartesian` straight.
        planning: settings of the harmonic one.

    Raises:
        InvalidChoice: if it is neither.
    """
    check_choice("gross motion", gross_motion, GROSS_MOTIONS)
    planned = gross_motion == "harmonic"
    planner = GrossPlanner(twin.model, side, planning) if planned else None
    return ArmControl(side, twin, DifferentialIK(twin, side), planner)
