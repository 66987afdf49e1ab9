"""The referee sees what must not happen: shown by making it happen."""

import numpy as np
import pytest
from rig import GRASP, SIDES, holding

from prospect_mj.robot import names
from prospect_mj.sim.audit import Audit

ARM_JOINTS = [joint for side in SIDES for joint in names.arm_joints(side)]


@pytest.fixture
def audited(rig):
    """The rig with an audit of every step; taken off afterwards."""
    rig.present()
    audit = Audit(rig.model, ARM_JOINTS)
    rig.simulation.observer = audit
    yield rig, audit.findings
    rig.simulation.observer = None


@pytest.mark.parametrize("side", SIDES)
def test_a_grasp_has_no_unintended_contact_and_saturates_nothing(audited, side):
    rig, findings = audited
    (outcome,) = rig.act(GRASP[side])
    assert outcome.result == "success"
    assert findings.steps == round(outcome.sim_seconds / rig.simulation.timestep)
    assert not findings.contacts
    assert not findings.saturated
    assert 0.05 < findings.load < 1.0


def test_an_arm_that_hits_the_table_is_seen(audited):
    rig, findings = audited
    low = rig.joints("left")
    low[0] += 0.6
    rig.torso.arms["left"].command_joints(low)
    rig.simulation.step(400)
    assert findings.contacts
    assert any("table/top" in pair for pair in findings.contacts)
    assert all(pair == tuple(sorted(pair)) for pair in findings.contacts)


def test_a_motor_at_its_limit_is_seen(audited):
    rig, findings = audited
    far = rig.joints("right")
    far[6] += 1.5
    rig.torso.arms["right"].command_joints(far)
    rig.simulation.step(4)
    assert findings.saturated["right_joint7"] > 0
    assert findings.load == pytest.approx(1.0)
    assert set(findings.saturated) == {"right_joint7"}


def test_a_jar_that_falls_on_the_table_is_seen(audited):
    rig, findings = audited
    rig.restore(holding("left"))
    rig.torso.arms["left"].command_fingers(np.full(3, 0.3))
    rig.simulation.step(400)
    assert any(
        {name.partition("/")[0] for name in pair} & {"table", "left_palm"}
        for pair in findings.contacts
    )
