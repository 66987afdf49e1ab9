"""Gross motion along streamlines, in physics with a post that can be moved."""

import hashlib
import os
import re
import subprocess
import sys
from pathlib import Path

import mink
import numpy as np
import pytest
from harmonic_reaches import NO_JAR, planning
from reach_clearance import planners_clearance
from reach_pairs import POST, ReachPair
from reach_runs import Bench
from rig import OTHER, SIDES, angle_between

from prospect_mj.control.arm_control import ArmControl, arm_control
from prospect_mj.control.controller import CONTROL_PERIOD
from prospect_mj.control.gross_motion import assume, reach
from prospect_mj.control.harmonic_motion import (
    TIME_BUDGET,
    HarmonicPosture,
    HarmonicReach,
)
from prospect_mj.control.posture_motion import PostureMotion
from prospect_mj.control.result import Status
from prospect_mj.control.straight_reach import GROSS, StraightReach
from prospect_mj.control.transit import TransitSettings
from prospect_mj.errors import InvalidChoice
from prospect_mj.planning.planner import GrossPlanner, World
from prospect_mj.robot import names, posture, wam
from prospect_mj.sim.audit import Audit

CORNER = np.array(POST.position)
GOALS = (posture.presenting, posture.over_well)
ARM = re.compile("left_|right_")
ARMS = [joint for side in SIDES for joint in names.arm_joints(side)]


@pytest.fixture(scope="module")
def bench():
    return Bench()


@pytest.fixture(params=SIDES)
def side(request):
    return request.param


class Trial:
    """An arm that begins at rest at home, watched at every physics step."""

    def __init__(self, bench, side, start=None, post=None):
        start = posture.home(side) if start is None else start
        nowhere = np.zeros(3), np.eye(3)
        pair = ReachPair(side, 0, start, *nowhere, start, post, None, 0.0)
        bench.simulation.observer = None
        bench.begin(pair)
        bench.wait(0.3)
        self.bench, self.side = bench, side
        self.arm = planning(bench.arms[side])
        self.planner = self.arm.planner
        self.audit = Audit(bench.model, ARMS)
        dofs = [bench.model.joint(n).dofadr[0] for n in names.arm_joints(side)]
        self._dofs, self.fastest = dofs, 0.0
        bench.simulation.observer = self._look

    def _look(self, data):
        self.audit(data)
        self.fastest = max(self.fastest, np.abs(data.qvel[self._dofs]).max())

    @property
    def touched(self):
        """Pairs of geoms, the jar left out that stands on the floor."""
        contacts = self.audit.findings.contacts
        return [pair for pair in contacts if any(ARM.match(name) for name in pair)]

    @property
    def joints(self):
        return self.bench.torso.arms[self.side].read().joints

    @property
    def world(self):
        return World(self.bench.twin.data, NO_JAR)

    def clearance(self, configurations):
        """Least of the planner's [m]."""
        model = self.bench.twin.model
        room = planners_clearance(model, self.side, configurations, self.world)
        return room.min()

    def pose_at(self, joints):
        """Of the grasp site, when the arm is there [m]."""
        twin = self.bench.twin
        angles = twin.configuration.q.copy()
        before = angles.copy()
        angles[twin.columns(self.side)] = joints
        twin.configuration.update(angles)
        pose = twin.grasp_pose(self.side)
        twin.configuration.update(before)
        return pose

    def reach(self, joints):
        return HarmonicReach(self.arm, self.pose_at(joints), joints, NO_JAR)

    def posture(self, joints):
        return HarmonicPosture(self.arm, joints, NO_JAR)

    def place_post(self, place):
        for owner in (self.bench.simulation, self.bench.twin):
            owner.place_obstacle(place)
        self.bench.twin.configuration.update()

    def tick(self, controller):
        reading = self.bench.torso.read()
        self.bench.twin.update(reading)
        targets = controller.update(reading)
        if targets.joints is not None:
            self.bench.torso.arms[self.side].command_joints(targets.joints)
        if controller.result is None:
            simulation = self.bench.simulation
            simulation.step(simulation.substeps(CONTROL_PERIOD))
        return reading[self.side]

    def drive(self, controller, hook=lambda own: None):
        while controller.result is None:
            hook(self.tick(controller))
        return controller.result

    def coast(self, seconds=0.5):
        self.bench.wait(seconds)


@pytest.mark.parametrize("goal", GOALS, ids=lambda goal: goal.__name__)
def test_a_reach_arrives_within_tolerance_limits_and_torques(bench, side, goal):
    trial = Trial(bench, side)
    there = goal(side)
    target = trial.pose_at(there)
    result = trial.drive(trial.reach(there))
    assert result.converged, result.reason
    hand = bench.hand(side)
    offset = np.linalg.norm(hand.position - target.translation())
    assert offset < GROSS.position_tolerance
    palm = target.rotation().as_matrix()[:, 2]
    assert angle_between(hand.rotation[:, 2], palm) < GROSS.angle_tolerance
    assert 1.0 < trial.fastest < wam.VELOCITY_LIMIT
    assert trial.audit.findings.load < 1.0
    assert not trial.touched


@pytest.mark.parametrize("goal", GOALS, ids=lambda goal: goal.__name__)
def test_a_posture_is_reached_and_kept(bench, side, goal):
    trial = Trial(bench, side)
    result = trial.drive(trial.posture(goal(side)))
    assert result.converged, result.reason
    trial.coast()
    assert trial.joints == pytest.approx(goal(side), abs=5e-3)
    assert trial.fastest < wam.VELOCITY_LIMIT
    assert trial.audit.findings.load < 1.0
    assert not trial.touched


def test_the_arm_is_where_the_reference_is_and_the_reference_on_the_path(bench, side):
    """The servos lag by 0.12 s: at 1 rad/s that alone would be 0.12 rad."""
    trial = Trial(bench, side)
    motion = trial.posture(posture.over_well(side))
    lags, strays = [], []

    def compare(own):
        transit = motion.transit
        if not transit.arrived:
            reference = transit._reference
            lags.append(np.abs(reference - own.joints).max())
            path = transit.plan.path
            strays.append(np.linalg.norm(path - reference, axis=1).min())

    assert trial.drive(motion, compare).converged
    assert len(lags) > 30
    assert max(lags) < 0.04
    assert np.median(lags) < 0.02
    assert max(strays) < 0.1


def raised(side):
    """An arm that is lifted from behind, outstretched: the most that joints carry."""
    ends = (
        [2.29, -1.42, -1.47, 1.29, -0.49, 0.15, 0.27],
        [0.17, -0.13, -0.66, 2.03, -2.38, -0.92, 1.64],
    )
    return [posture.reflected(np.array(end), side) for end in ends]


def test_it_speeds_up_as_the_joints_have_torque_for(bench, side):
    """At full acceleration this one would take 96 % of a torque limit."""
    start, goal = raised(side)
    trial = Trial(bench, side, start)
    assert trial.drive(trial.posture(goal)).converged
    share = TransitSettings().torque_share
    assert share - 0.05 < trial.audit.findings.load < share + 0.05


def test_no_joint_is_sped_up_by_more_than_it_may(bench, side):
    """Clear of everything: near to something mink may brake harder."""
    ends = (
        [2.39, -0.54, -1.71, 0.71, -0.34, -0.17, 0.49],
        [0.30, 0.14, -1.43, 0.35, -0.04, 0.01, 0.20],
    )
    start, goal = (posture.reflected(np.array(end), side) for end in ends)
    trial = Trial(bench, side, start, post=np.array([-1.0, 0.0]))
    motion = trial.posture(goal)
    speeds = [np.zeros(wam.N_JOINTS)]

    def record(own):
        if not motion.transit.arrived:
            speeds.append(motion.transit._velocity.copy())

    assert trial.drive(motion, record).converged
    assert trial.clearance(motion.transit.plan.path) > 0.15
    most = np.abs(np.diff(speeds, axis=0)).max() / CONTROL_PERIOD
    assert most == pytest.approx(TransitSettings().acceleration, rel=1e-3)


def beyond_everything(trial):
    turn = trial.pose_at(posture.home(trial.side)).rotation()
    return mink.SE3.from_rotation_and_translation(turn, np.array([2.0, 0.0, 0.5]))


def inside_the_table(trial):
    turn = trial.pose_at(posture.home(trial.side)).rotation()
    return mink.SE3.from_rotation_and_translation(turn, np.array([0.5, 0.0, -0.02]))


def inside_the_other_hand(trial):
    return trial.bench.twin.grasp_pose(OTHER[trial.side])


@pytest.mark.parametrize(
    "where",
    [beyond_everything, inside_the_table, inside_the_other_hand],
    ids=lambda where: where.__name__,
)
def test_what_can_not_be_reached_is_said_at_once_and_nothing_moves(bench, side, where):
    trial = Trial(bench, side)
    commands, before = bench.data.ctrl.copy(), trial.joints
    target = where(trial)
    motion = HarmonicReach(trial.arm, target, posture.home(side), NO_JAR)
    trial.tick(motion)
    assert motion.result.status is Status.UNREACHABLE
    assert motion.result.reason == "no way to the goal"
    assert motion.result.seconds <= CONTROL_PERIOD
    assert np.array_equal(bench.data.ctrl, commands)
    trial.coast(1.0)
    assert trial.joints == pytest.approx(before, abs=1e-3)


def test_a_posture_that_touches_something_is_unreachable(bench, side):
    trial = Trial(bench, side)
    there = posture.over_well(side)
    trial.place_post(trial.pose_at(there).translation()[:2])
    motion = trial.posture(there)
    trial.tick(motion)
    assert motion.result.status is Status.UNREACHABLE


def run_into(trial, motion, place, after=0.4):
    """Drive, and put the post into the way when some time has passed."""

    def put(own):
        if motion.seconds == pytest.approx(after):
            trial.place_post(place(motion.transit.plan, own.joints))

    return trial.drive(motion, put)


def swept(side):
    """From the side to the front: a long way round the torso."""
    start = posture.reflected(np.array([1.6, 0.9, -0.5, 1.4, -2.3, -0.6, 0.9]), side)
    return start, posture.presenting(side)


def test_when_the_post_moves_into_the_way_it_plans_anew_and_arrives(bench, side):
    start, goal = swept(side)
    free = Trial(bench, side, start)
    assert free.clearance(start[None]) > 0.03
    assert free.drive(free.posture(goal)).converged
    assert len(free.planner.plans) == 1

    trial = Trial(bench, side, start)
    motion = trial.posture(goal)
    former = []

    def place(plan, joints):
        former.append(plan.path)
        return trial.pose_at(plan.ahead(joints, 1.0)).translation()[:2]

    result = run_into(trial, motion, place)
    assert trial.clearance(*former) < 0, "it was not in the way"
    assert len(trial.planner.plans) > 1
    assert result.converged, result.reason
    trial.coast()
    assert not trial.touched


def test_when_the_way_is_barred_for_good_it_stops_and_says_so(bench, side):
    """The post stands where the hand should go."""
    start, goal = swept(side)
    trial = Trial(bench, side, start)
    motion = trial.posture(goal)
    there = trial.pose_at(goal).translation()[:2]
    result = run_into(trial, motion, lambda plan, joints: there)
    assert result.status is Status.STALLED
    assert "rad short of the goal" in result.reason
    assert result.seconds < 0.5 * TIME_BUDGET
    stopped = trial.joints
    assert np.abs(bench.torso.arms[side].read().velocities).max() < 0.02
    trial.coast()
    assert trial.joints == pytest.approx(stopped, abs=5e-3)
    assert np.linalg.norm(stopped - goal) > 0.5
    assert not trial.touched


def test_it_goes_on_when_the_way_becomes_free_again(bench, side):
    start, goal = swept(side)
    trial = Trial(bench, side, start)
    motion = trial.posture(goal)
    there = trial.pose_at(goal).translation()[:2]
    slowest = [np.inf]

    def put_and_take_away(own):
        if motion.seconds == pytest.approx(0.4):
            trial.place_post(there)
        if 0.6 < motion.seconds < 1.2:
            slowest[0] = min(slowest[0], np.abs(own.velocities).max())
        if motion.seconds == pytest.approx(1.2):
            trial.place_post(CORNER)

    assert trial.drive(motion, put_and_take_away).converged
    assert slowest[0] < 0.05, "it did not wait"
    assert not trial.touched


def digest(bench, side="left"):
    """Of the simulator's state after two motions."""
    trial = Trial(bench, side, post=np.array([0.55, 0.40]))
    trial.drive(trial.reach(posture.over_well(side)))
    trial.drive(trial.posture(posture.home(side)))
    bench.simulation.observer = None
    return hashlib.sha256(bench.simulation.save().tobytes()).hexdigest()


def test_the_same_run_is_the_same_bit_by_bit_whatever_was_planned_before(bench):
    """Here twice with other plans between, and in a process of its own."""
    first = digest(bench)
    digest(bench, "right")
    assert digest(bench) == first
    folders = [str(Path(__file__).parent), str(Path(__file__).parents[1])]
    text = (
        f"import sys; sys.path[:0] = {folders!r}\n"
        "from test_harmonic_motion import Bench, digest\n"
        "print(digest(Bench()))"
    )
    done = subprocess.run(
        [sys.executable, "-c", text], capture_output=True, text=True, env=os.environ
    )
    assert done.stdout.strip() == first, done.stderr


def test_with_an_object_in_the_hand_no_joint_is_quicker_than_it_may(bench, side):
    trial = Trial(bench, side)
    motion = HarmonicPosture(trial.arm, posture.over_well(side), NO_JAR, carrying=True)
    commanded = []
    # An empty hand that is to carry: the loss is not what is tested here.
    motion._grip.lost = lambda touch: False
    trial.drive(motion, lambda own: commanded.append(motion.transit._velocity.copy()))
    assert motion.result.converged
    limit = TransitSettings().carrying_speed
    assert 0.8 * limit < np.abs(commanded).max() <= limit + 1e-6
    assert trial.fastest < 1.15 * limit


def test_an_arm_without_a_planner_goes_straight(bench, side):
    twin = bench.twin
    with_planner = arm_control(side, twin)
    without = arm_control(side, twin, "cartesian")
    assert isinstance(with_planner, ArmControl)
    assert isinstance(with_planner.planner, GrossPlanner)
    assert without.planner is None
    target, home = twin.grasp_pose(side), posture.home(side)
    kinds = [
        (type(reach(arm, target, home, NO_JAR)), type(assume(arm, home, NO_JAR)))
        for arm in (with_planner, without)
    ]
    assert kinds == [(HarmonicReach, HarmonicPosture), (StraightReach, PostureMotion)]


def test_another_gross_motion_is_refused_with_those_there_are(bench):
    with pytest.raises(InvalidChoice, match="'rrt'; valid: harmonic, cartesian"):
        arm_control("left", bench.twin, "rrt")
