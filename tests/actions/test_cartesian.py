"""The ablation: the same actions, their large movements straight."""

import pytest
from rig import GRASP, INSERT, SIDES, SWAP_FROM, Rig

from prospect_mj.actions.runner import ActionRunner


@pytest.fixture(scope="module")
def straight():
    rig = Rig()
    rig.runner = ActionRunner(rig.simulation, "cartesian")
    rig.twin, rig.arms = rig.runner.twin, rig.runner.arms
    return rig


@pytest.mark.parametrize("side", SIDES)
def test_the_cartesian_ablation_does_the_same_work_without_planning(straight, side):
    other = SIDES[1 - SIDES.index(side)]
    straight.present(lid=side)
    outcomes = straight.act(GRASP[other], INSERT[other], SWAP_FROM[other], INSERT[side])
    assert [o.result for o in outcomes] == ["success", "jammed", "success", "success"]
    controllers = {run.name for outcome in outcomes for run in outcome.runs}
    assert {"StraightReach", "PostureMotion"} <= controllers
    assert not {"HarmonicReach", "HarmonicPosture"} & controllers
