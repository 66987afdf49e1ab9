"""Whole actions stay within what the arms can do: speed and torque of every joint."""

import numpy as np
import pytest
from rig import GRASP, INSERT, OTHER, SIDES, SWAP_FROM

from prospect_mj.robot import names
from prospect_mj.sim.audit import Audit

VELOCITY = 2.0
"""Of every joint of the WAM [rad/s] (barrett_model URDF)."""


@pytest.mark.parametrize("lid", SIDES)
def test_joint_speed_and_torque_over_a_late_correction(rig, lid):
    """The wrong hand grasps and tries, hands over, and the other one inserts."""
    wrong = OTHER[lid]
    joints = [joint for side in SIDES for joint in names.arm_joints(side)]
    dofs = [int(rig.model.joint(joint).dofadr[0]) for joint in joints]
    audit, fastest = Audit(rig.model, joints), np.zeros(len(dofs))

    def watch(data):
        audit(data)
        np.maximum(fastest, np.abs(data.qvel[dofs]), out=fastest)

    rig.present(lid, yaw=0.15)
    rig.simulation.observer = watch
    try:
        actions = (GRASP[wrong], INSERT[wrong], SWAP_FROM[wrong], INSERT[lid])
        results = [str(outcome.result) for outcome in rig.act(*actions)]
    finally:
        rig.simulation.observer = None
    assert results == ["success", "jammed", "success", "success"]
    assert fastest.max() < VELOCITY, dict(zip(joints, fastest.round(2), strict=True))
    assert fastest.max() > 0.5 * VELOCITY  # it did move
    assert audit.findings.load < 0.95
    assert not audit.findings.contacts
