"""Motions of an arm, closed loop with physics: arrive, or say why not."""

import mink
import numpy as np
import pytest
from rig import OTHER, SIDES, angle_between, holding

from prospect_mj.control.controller import CONTROL_PERIOD
from prospect_mj.control.fine_motion import FINE, PASSING, FineMotion
from prospect_mj.control.hand_motion import HandMotion
from prospect_mj.control.harmonic_motion import HarmonicPosture, HarmonicReach
from prospect_mj.control.posture_motion import PostureMotion
from prospect_mj.control.result import Status
from prospect_mj.control.straight_reach import GROSS, StraightReach
from prospect_mj.planning.surroundings import JarShape, KnownJars
from prospect_mj.robot import names, posture, wam
from prospect_mj.sim.audit import Audit

MIRROR = {"left": 1, "right": -1}


def pose_of(rig, side):
    """The hand's true pose, from the simulator."""
    site = rig.data.site(names.grasp_site(side))
    rotation = mink.SO3.from_matrix(site.xmat.reshape(3, 3).copy())
    return mink.SE3.from_rotation_and_translation(rotation, site.xpos.copy())


def somewhere(rig, side, rng):
    """A seeded pose in front of the chest on the hand's own side."""
    place = rng.uniform([0.45, 0.12, 0.30], [0.60, 0.30, 0.50])
    rotation = mink.SO3.exp(rng.uniform(-0.3, 0.3, 3)) @ pose_of(rig, side).rotation()
    place[1] *= MIRROR[side]
    return mink.SE3.from_rotation_and_translation(rotation, place)


def shifted(rig, side, *offset):
    pose = pose_of(rig, side)
    return mink.SE3.from_rotation_and_translation(
        pose.rotation(), pose.translation() + offset
    )


@pytest.mark.parametrize("side", SIDES)
@pytest.mark.parametrize("seed", range(10))
def test_the_palm_reaches_its_target(rig, side, seed):
    """To 2 mm and 0.015 rad, by the simulator's truth, and it stays about there.

    In the period after its last reading it moves on by rest speed x period = 0.6 mm.
    """
    rng = np.random.default_rng(seed)
    rig.present()
    start = posture.home(side) + rng.uniform(-0.15, 0.15, 7)
    rig.torso.arms[side].command_joints(start)
    rig.wait(0.6)
    target = somewhere(rig, side, rng)
    still = rig.joints(OTHER[side])
    result = rig.drive(FineMotion(rig.arms[side], target, posture.home(side)))
    assert result.converged, result.reason
    assert result.seconds < 2.5
    for settle, tolerance in ((0.0, 0.0026), (0.3, 0.004)):
        rig.wait(settle)
        error = pose_of(rig, side).inverse() @ target
        assert np.linalg.norm(error.translation()) < tolerance
        assert np.linalg.norm(error.rotation().log()) < 0.015
    assert rig.joints(OTHER[side]) == pytest.approx(still, abs=1e-3)


@pytest.mark.parametrize("side", SIDES)
def test_speed_and_joint_velocities_stay_within_their_limits(rig, side):
    """Tool speed as set, plus what a servo's transient adds; joints below 2 rad/s."""
    rig.present()
    target = shifted(rig, side, 0.0, MIRROR[side] * 0.1, 0.25)
    places, fastest = [pose_of(rig, side).translation()], [0.0]

    def watch():
        places.append(rig.twin.grasp_pose(side).translation())
        fastest.append(np.abs(rig.torso.arms[side].read().velocities).max())

    motion = StraightReach(rig.arms[side], target, posture.home(side))
    assert rig.drive(motion, hook=watch).converged
    speed = np.linalg.norm(np.diff(places, axis=0), axis=1) / CONTROL_PERIOD
    assert 0.5 * GROSS.speed < speed.max() < 1.2 * GROSS.speed
    assert max(fastest) < wam.VELOCITY_LIMIT


@pytest.mark.parametrize("side", SIDES)
def test_an_unreachable_target_stalls_with_the_distance_as_reason(rig, side):
    rig.present()
    far = shifted(rig, side, 1.0, 0.0, 0.2)
    result = rig.drive(FineMotion(rig.arms[side], far, posture.home(side)))
    assert result.status is Status.STALLED
    assert not result.converged
    assert "mm" in result.reason
    assert "short of the target" in result.reason
    assert result.seconds <= FINE.time_budget + CONTROL_PERIOD


@pytest.mark.parametrize("side", SIDES)
def test_a_blocked_arm_stalls_and_pushes_no_harder_than_its_lead_allows(rig, side):
    """The commands never run away from the measured angles: bounded torque."""
    rig.present()
    target = shifted(rig, side, 0.15, MIRROR[side] * 0.05, 0.15)
    body = rig.model.body(names.palm(side)).id
    anchor = rig.data.xpos[body].copy()
    lead = []

    def hold_back():
        # A spring of the test's own at the palm: an obstacle without geometry.
        offset = anchor - rig.data.xpos[body]
        rig.data.xfrc_applied[body, :3] = 3000.0 * offset
        own = rig.torso.arms[side].read()
        lead.append(np.abs(own.joint_command - own.joints).max())

    try:
        motion = FineMotion(rig.arms[side], target, posture.home(side))
        result = rig.drive(motion, hook=hold_back)
    finally:
        rig.data.xfrc_applied[:] = 0
    assert result.status in (Status.STALLED, Status.OUT_OF_TIME)
    assert result.reason
    assert max(lead) < FINE.windup + 0.05
    assert np.linalg.norm(rig.data.xpos[body] - anchor) < 0.1


def test_the_time_budget_is_respected(rig):
    """A target that recedes for ever is followed until the budget is used up."""
    rig.present()
    motion = PostureMotion(rig.arms["left"], posture.home("left") + 0.5)
    assert motion.time_budget == 4.0

    def undo():
        rig.torso.arms["left"].command_joints(posture.home("left"))

    result = rig.drive(motion, hook=undo)
    assert result.status is Status.OUT_OF_TIME
    assert result.reason == "after 4 s"
    assert result.seconds == pytest.approx(4.0, abs=1.01 * CONTROL_PERIOD)
    assert motion.seconds == pytest.approx(4.0)


@pytest.mark.parametrize("side", SIDES)
def test_the_other_hand_is_not_touched_even_on_purpose(rig, side):
    rig.present()
    audit = Audit(rig.model, list(names.arm_joints(side)))
    rig.simulation.observer = audit
    target = pose_of(rig, OTHER[side])
    try:
        result = rig.drive(StraightReach(rig.arms[side], target, posture.home(side)))
    finally:
        rig.simulation.observer = None
    assert result.status is Status.STALLED
    # The jar between the hands is not in the twin; it may be pushed aside.
    touched = [
        pair
        for pair in audit.findings.contacts
        if not any(name.startswith("jar/") for name in pair)
    ]
    assert not touched


@pytest.mark.parametrize("side", SIDES)
@pytest.mark.parametrize(
    "kind",
    [FineMotion, StraightReach, PostureMotion, HarmonicReach, HarmonicPosture],
    ids=lambda kind: kind.__name__,
)
def test_an_object_taken_out_of_the_hand_is_missed_at_once(rig, side, kind):
    """The fingers are forced open half-way: felt within 0.2 s of the loss."""
    rig.restore(holding(side))
    asked = [posture.over_well(side)]
    if not issubclass(kind, PostureMotion):
        target = shifted(rig, side, 0.0, MIRROR[side] * 0.15, 0.2)
        asked = [target, posture.presenting(side)]
    if kind in (HarmonicReach, HarmonicPosture):
        jar = rig.simulation.settings.props.jar
        shape = JarShape(jar.lid_radius, jar.length)
        asked.append(KnownJars(shape, dict(rig.belief.held)))
    motion = kind(rig.arms[side], *asked, carrying=True)
    ticks, felt = [0], []

    def open_up():
        ticks[0] += 1
        if ticks[0] > 5:
            rig.torso.arms[side].command_fingers(np.full(3, 0.6))
        felt.append(rig.torso.arms[side].read().touch.found.sum())

    result = rig.drive(motion, hook=open_up)
    assert result.status is Status.LOST
    assert "fingertips" in result.reason
    last_held = max(i for i, n in enumerate(felt) if n >= 2)
    assert (len(felt) - 1 - last_held) * CONTROL_PERIOD < 0.2


@pytest.mark.parametrize("side", SIDES)
def test_nothing_is_missed_in_an_empty_hand(rig, side):
    rig.present()
    target = shifted(rig, side, 0.0, 0.0, 0.1)
    motion = FineMotion(rig.arms[side], target, posture.home(side), settings=PASSING)
    assert rig.drive(motion).converged


@pytest.mark.parametrize("side", SIDES)
def test_a_held_jar_does_not_slip_on_the_way(rig, side):
    """A quarter turn and 20 cm of way: 2 mm and 0.5 degrees in the hand.

    MuJoCo's contacts themselves let go 1 mm of it (see `MotionSettings.turn_speed`).
    """
    rig.restore(holding(side))
    before = rig.jar_in_hand(side)
    motion = PostureMotion(rig.arms[side], posture.over_well(side), carrying=True)
    assert rig.drive(motion).converged
    after = rig.jar_in_hand(side)
    assert np.linalg.norm(after.position - before.position) < 2e-3
    assert np.degrees(angle_between(after.axis, before.axis)) < 0.5


@pytest.mark.parametrize("side", SIDES)
@pytest.mark.parametrize("name", ["home", "presenting", "over_well"])
def test_postures_are_reached_and_kept(rig, side, name):
    rig.present()
    goal = getattr(posture, name)(side)
    result = rig.drive(PostureMotion(rig.arms[side], goal))
    assert result.converged
    rig.wait(0.5)
    assert rig.joints(side) == pytest.approx(goal, abs=2e-3)


@pytest.mark.parametrize("side", SIDES)
def test_fingers_open_to_the_angles_asked_for(rig, side):
    rig.present()
    rig.torso.arms[side].command_fingers(np.full(3, 1.4))
    rig.wait(0.5)
    result = rig.drive(HandMotion(side))
    assert result.converged
    rig.wait(0.3)
    fingers = rig.torso.arms[side].read().fingers
    assert fingers == pytest.approx(posture.OPEN, abs=0.04)


def test_fingers_that_are_held_run_out_of_time(rig):
    """The hand is closed on the jar from outside its reach: it can't get there."""
    rig.restore(holding("left"))
    result = rig.drive(HandMotion("left", angles=(1.8, 1.8, 1.8), time_budget=0.6))
    assert result.status is Status.OUT_OF_TIME
    assert result.seconds == pytest.approx(0.6, abs=1.01 * CONTROL_PERIOD)
