"""Bring the rig to where a controller under test takes over.

The reach is the straight one: what is tested of grasping does not depend on planning.
"""

import mink
import numpy as np
from rig import Rig

from prospect_mj.actions import poses
from prospect_mj.actions.workspace import workspace
from prospect_mj.control.fine_motion import FineMotion
from prospect_mj.control.insertion import InsertionController
from prospect_mj.control.straight_reach import StraightReach
from prospect_mj.robot import names, posture

UP = np.array([0.0, 0.0, 1.0])


def round_the_jar(rig: Rig, side: str, offset=(0.0, 0.0), tilt=0.0) -> None:
    """Open hand round its end of the presented jar, displaced across the palm axis."""
    work = workspace(rig.simulation.settings.props)
    seen, arm, home = rig.belief.seen, rig.arms[side], posture.home(side)

    def round_its_end():
        point, palm = poses.end_of_jar(side, seen.position, seen.axis, work.reach)
        return poses.pose(poses.turned_to(arm.grasp_pose().rotation(), palm), point)

    before = poses.backed_off(round_its_end(), work.stand_off)
    assert rig.drive(StraightReach(arm, before, home)).converged
    exact = round_its_end()
    beside = mink.SE3.from_rotation_and_translation(
        mink.SO3.exp(np.array([tilt, 0.0, 0.0])), np.array([*offset, 0.0])
    )
    assert rig.drive(FineMotion(arm, exact @ beside, home)).converged


def over_the_well(rig: Rig, side: str, aside=(0.0, 0.0)) -> InsertionController:
    """Held jar upright above the receptacle, `aside` [m] of its centre."""
    work = workspace(rig.simulation.settings.props)
    arm, reference = rig.arms[side], posture.over_well(side)
    held = rig.belief.held[side]
    beside = work.over_well(work.via_height)
    beside = beside + [0.03, 0.08 * names.sign(side), 0.0]
    for motion, centre in (
        (StraightReach, beside),
        (FineMotion, work.over_well(work.rim_clearance) + [*aside, 0.0]),
    ):
        target = poses.jar_over(side, arm.grasp_pose(), held, centre, UP)
        assert rig.drive(motion(arm, target, reference, carrying=True)).converged
    free = (arm.grasp_pose() @ held).translation()[2] - work.jar_length / 2
    free -= work.well[2]
    depth = free + work.well_depth
    return InsertionController(arm, arm.grasp_pose(), free, depth, reference)
