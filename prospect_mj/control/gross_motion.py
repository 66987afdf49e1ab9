"""Gross motion: large, quick and coarse movements of an arm.

An arm with a planner moves along the streamlines of a harmonic function; one without
goes straight.
"""

import mink
import numpy as np

from prospect_mj.control.arm_control import ArmControl
from prospect_mj.control.controller import Controller
from prospect_mj.control.harmonic_motion import HarmonicPosture, HarmonicReach
from prospect_mj.control.posture_motion import PostureMotion
from prospect_mj.control.straight_reach import StraightReach
from prospect_mj.planning.surroundings import KnownJars


def reach(
    arm: ArmControl,
    target: mink.SE3,
    posture: np.ndarray,
    jars: KnownJars,
    carrying: bool = False,
) -> Controller:
    """A controller that brings a hand to a pose, roll left free.

    Args:
        arm: which arm.
        target: pose of the grasp site in the world.
        posture: joint angles (7,) [rad] that resolve the redundancy.
        jars: where the jar is believed to be.
        carrying: whether an object must stay in the hand.
    """
    if arm.planner is None:
        return StraightReach(arm, target, posture, carrying)
    return HarmonicReach(arm, target, posture, jars, carrying)


def assume(
    arm: ArmControl, posture: np.ndarray, jars: KnownJars, carrying: bool = False
) -> Controller:
    """A controller that brings an arm's joints to a posture (7,) [rad]."""
    if arm.planner is None:
        return PostureMotion(arm, posture, carrying)
    return HarmonicPosture(arm, posture, jars, carrying)
