"""Weighing tells a jar in the hand from an empty hand."""

import numpy as np
import pytest
from rig import SIDES, holding

from prospect_mj.control.result import Status
from prospect_mj.control.weighing import Weighing

JAR = 0.40 * 9.81


@pytest.mark.parametrize("side", SIDES)
def test_at_rest_the_jar_weighs_what_it_weighs(rig, side):
    rig.restore(holding(side))
    result = rig.drive(Weighing(rig.arms[side], JAR))
    assert result.converged
    assert result.load == pytest.approx(JAR, abs=0.05)
    assert result.reason == "3.9 N hang in the hand"


@pytest.mark.parametrize("side", SIDES)
def test_an_empty_hand_weighs_nothing(rig, side):
    rig.present()
    result = rig.drive(Weighing(rig.arms[side], JAR))
    assert result.status is Status.LOST
    assert result.load == pytest.approx(0.0, abs=0.05)


def test_a_heavy_thing_that_only_two_fingers_hold_is_not_held(rig):
    """Weight alone is no grasp: one finger is lifted off the jar."""
    rig.restore(holding("left"))
    arm = rig.torso.arms["left"]
    command = arm.read().finger_command
    arm.command_fingers(command - [0.0, 0.3, 0.0])
    rig.wait(0.04)
    assert not rig.torso.arms["left"].read().touch.found.all()
    result = rig.drive(Weighing(rig.arms["left"], JAR, rest=0.0, duration=0.02))
    assert result.status is Status.LOST


@pytest.mark.parametrize(("pull", "held"), [(2.4, False), (0.8, True)])
def test_less_than_six_tenths_of_the_expected_load_is_not_the_jar(rig, pull, held):
    """A string of the test's own carries part of the jar."""
    rig.restore(holding("right"))
    jar = rig.model.body("jar/").id
    rig.data.xfrc_applied[jar, 2] = pull
    try:
        rig.wait(0.2)
        result = rig.drive(Weighing(rig.arms["right"], JAR))
    finally:
        rig.data.xfrc_applied[:] = np.zeros(6)
    assert result.load == pytest.approx(JAR - pull, abs=0.05)
    assert result.converged is held
