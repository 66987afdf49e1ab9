"""Where a jar sits in the hand that has just closed on it: from touch, not from truth."""

import mink
import numpy as np

from prospect_mj.actions.belief import Belief
from prospect_mj.control.arm_control import ArmControl
from prospect_mj.robot.names import Side


def jar_in_hand(
    arm: ArmControl, jar: mink.SE3, belief: Belief, side: Side
) -> mink.SE3:
    """Pose of the jar in the grasp frame, as the robot believes it in the world."""
    return arm.grasp_pose().inverse() @ jar
