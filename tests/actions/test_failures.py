"""What goes wrong ends as a value, with the torso in a known posture."""

import numpy as np
import pytest
from rig import GRASP, INSERT, OTHER, SIDES, SWAP_FROM, Rig, holding, holding_wrong

from prospect_mj.actions.action import Action, ActionResult
from prospect_mj.actions.belief import Belief, SeenJar
from prospect_mj.sim.props import Jar, Props
from prospect_mj.sim.scene import SceneSettings


@pytest.fixture(scope="module")
def icy():
    """A scene whose jar is as smooth as wet ice."""
    jar = Jar(friction=(0.01, 1e-4, 1e-6))
    return Rig(SceneSettings(props=Props(jar=jar)))


@pytest.mark.parametrize("side", SIDES)
@pytest.mark.parametrize("lid", SIDES)
def test_a_jar_without_friction_is_reported_as_not_graspable(icy, side, lid):
    icy.present(lid)
    lying, heights = icy.simulation.jar_position, []
    jar = icy.model.body("jar/").id
    icy.simulation.observer = lambda data: heights.append(data.xpos[jar, 2])
    try:
        (outcome,) = icy.act(GRASP[side])
    finally:
        icy.simulation.observer = None
    assert outcome.executed
    assert outcome.result is ActionResult.NOT_GRASPED
    assert icy.belief.holding is None
    assert icy.is_home("left")
    assert icy.is_home("right")
    (failed,) = [run.result for run in outcome.runs if run.name == "GraspController"]
    assert "not graspable" in failed.reason
    # Felt before lifting. That it stays in its cradle is more than can be asked of ice.
    assert max(heights) < lying[2] + 0.003
    assert "Weighing" not in [run.name for run in outcome.runs]


@pytest.mark.parametrize("side", SIDES)
@pytest.mark.parametrize("bias", [(0.08, 0, 0), (0, 0.08, 0), (0, 0, 0.08)])
def test_a_jar_that_is_not_where_it_was_believed_is_not_grasped(rig, side, bias):
    bias = np.array(bias) * [1, 1 if side == "left" else -1, 1]
    rig.present(lid=side, bias=bias)
    (outcome,) = rig.act(GRASP[side])
    assert outcome.executed
    assert outcome.result is ActionResult.NOT_GRASPED
    assert rig.belief.holding is None
    assert rig.is_home("left")
    assert rig.is_home("right")
    (failed,) = [run.result for run in outcome.runs if run.name == "GraspController"]
    assert failed.reason == "the fingers closed without touching"


@pytest.mark.parametrize("side", SIDES)
def test_after_a_failed_grasp_any_action_can_follow(rig, side):
    """The hand missed the jar and left it where it is; a better look finds it."""
    rig.present(lid=side, bias=(0.08, 0, 0))
    rig.act(GRASP[side])
    axis = rig.simulation.jar_axis
    seen = SeenJar(rig.simulation.jar_position, np.sign(axis[1]) * axis)
    rig.runner.begin(Belief(seen))
    (outcome,) = rig.act(GRASP[side])
    assert outcome.result is ActionResult.SUCCESS


@pytest.mark.parametrize("side", SIDES)
def test_a_jar_in_the_way_of_the_hand_is_not_reached(rig, side):
    """Believed 8 cm nearer than it is: the open fingers run into it on the way."""
    rig.present(lid=side, bias=(-0.08, 0, 0))
    (outcome,) = rig.act(GRASP[side])
    assert outcome.result in (ActionResult.NOT_REACHED, ActionResult.NOT_GRASPED)
    assert "GraspController" not in [run.name for run in outcome.runs]
    assert rig.belief.holding is None
    assert rig.is_home("left")
    assert rig.is_home("right")


@pytest.mark.parametrize("action", [Action.GRASP_LEFT, Action.GRASP_RIGHT])
def test_a_jar_that_was_not_seen_moves_nothing(rig, action):
    rig.present()
    rig.runner.begin(Belief(seen=None))
    before = rig.simulation.save()
    (outcome,) = rig.act(action)
    assert not outcome.executed
    assert outcome.result is ActionResult.NOT_SEEN
    assert outcome.sim_seconds == 0
    assert outcome.runs == ()
    assert np.array_equal(rig.simulation.save(), before)


@pytest.mark.parametrize("giver", SIDES)
def test_a_failed_swap_leaves_the_jar_with_the_giver(rig, giver):
    """The giver believes that its jar is 8 cm higher: the taker grasps thin air."""
    rig.restore(holding(giver))
    held = rig.belief.held[giver]
    true = (rig.arms[giver].grasp_pose() @ held).translation()
    wrong = rig.arms[giver].grasp_pose() @ held
    wrong.wxyz_xyz[4:] = true + [0, 0, 0.10]
    rig.belief.held[giver] = rig.arms[giver].grasp_pose().inverse() @ wrong
    # While it holds, the giver goes on feeling its jar; kept from that, it stays wrong.
    feel, rig.runner._feel = rig.runner._feel, lambda: rig.sense()
    try:
        (outcome,) = rig.act(SWAP_FROM[giver])
    finally:
        rig.runner._feel = feel
    assert outcome.executed
    assert outcome.result is ActionResult.NOT_GRASPED
    assert rig.belief.holding == giver
    assert rig.torso.arms[giver].read().touch.found.all()
    assert rig.is_presenting(giver)
    assert rig.is_home(OTHER[giver])


@pytest.mark.parametrize("side", SIDES)
def test_a_jar_knocked_out_of_the_hand_is_lost_and_the_torso_goes_home(rig, side):
    """A test's own hand tears it out with 80 N while it is carried to the well."""
    rig.restore(holding(side))
    jar = rig.model.body("jar/").id
    start = rig.data.time

    def tear(data):
        data.xfrc_applied[jar, 2] = -80.0 if data.time > start + 0.5 else 0.0

    rig.simulation.observer = tear
    try:
        (outcome,) = rig.act(INSERT[side])
    finally:
        rig.simulation.observer = None
        rig.data.xfrc_applied[:] = 0
    assert outcome.result is ActionResult.LOST
    assert rig.belief.holding is None
    assert rig.belief.seen is None
    assert rig.is_home(side)
    assert "fingertips" in next(
        run.result.reason for run in outcome.runs if not run.result.converged
    )
    (again,) = rig.act(GRASP[side])
    assert again.result is ActionResult.NOT_SEEN


@pytest.mark.parametrize("side", SIDES)
def test_a_jar_believed_too_high_still_ends_safely(rig, side):
    """15 mm along the axis is more than any creep: jammed or in, never lost."""
    rig.restore(holding_wrong(side))
    jar = rig.arms[side].grasp_pose() @ rig.belief.held[side]
    axis = jar.rotation().as_matrix()[:, 2]
    jar.wxyz_xyz[4:] = jar.translation() + 0.015 * axis
    rig.belief.held[side] = rig.arms[side].grasp_pose().inverse() @ jar
    (outcome,) = rig.act(INSERT[side])
    assert outcome.result is ActionResult.JAMMED
    assert rig.belief.holding == side
    assert rig.torso.arms[side].read().touch.found.all()
    assert rig.is_presenting(side)
