"""Numbers on the pages of controllers and task are those of the code."""

# ruff: noqa: RUF001 - the pages' formulas have Greek letters

import inspect
from types import SimpleNamespace

import mujoco
import numpy as np
import pytest
from pages import DOCS

from prospect_mj.agent import FeatureSettings, LinearSettings
from prospect_mj.control.cartesian_motion import _LEVER, CartesianMotion
from prospect_mj.control.controller import CONTROL_PERIOD
from prospect_mj.control.differential_ik import IKSettings
from prospect_mj.control.fine_motion import FINE, PASSING
from prospect_mj.control.grasp_settings import GraspSettings
from prospect_mj.control.grip_watch import RELEASE_TIME
from prospect_mj.control.hand_motion import OPENING_SPEED, TOLERANCE, HandMotion
from prospect_mj.control.hand_servo import PoseError
from prospect_mj.control.harmonic_motion import TIME_BUDGET
from prospect_mj.control.insertion_settings import InsertionSettings
from prospect_mj.control.posture_motion import PostureSettings
from prospect_mj.control.straight_reach import GROSS
from prospect_mj.control.transit import TransitSettings
from prospect_mj.control.weighing import GRAVITY, Weighing
from prospect_mj.envs.settings import PickPlaceSettings
from prospect_mj.experiment.populations.optimum import optimum
from prospect_mj.experiment.run.learning_curve import NEAR_OPTIMAL
from prospect_mj.planning.settings import PlannerSettings
from prospect_mj.recording.recording import Recording
from prospect_mj.robot import barrett_hand, posture, wam
from prospect_mj.sim.props import Props
from prospect_mj.sim.scene import SceneSettings, compile_scene

IK, GRASP, INSERT = IKSettings(), GraspSettings(), InsertionSettings()
TRANSIT, POSTURE = TransitSettings(), PostureSettings()
PROPS, LEARNER, FEATURES = Props(), LinearSettings(), FeatureSettings()
FRICTION = PROPS.well.friction
LAG = (np.array(wam.SERVO.damping) + wam.SERVO.friction_damping) / wam.SERVO.stiffness
LOOP = [(CONTROL_PERIOD / (gain * LAG[0])) ** 0.5 / 2 for gain in (IK.gain, 0.5)]
BALANCED = GRASP.residual_threshold**0.5 / 1.5
ALPHA, GAMMA = LEARNER.step_size, LEARNER.discount
UNHELD, HELD = FEATURES.energy + 1, 2 * FEATURES.energy + 2
REACHED = max(
    np.linalg.norm((barrett_hand.fingertip(f, angle) - barrett_hand.grasp_centre())[:2])
    for f, angle in zip(barrett_hand.FINGERS, posture.OPEN, strict=True)
)
"""From a fingertip of the open hand to the hand's axis [m]."""


def default(function, name):
    return inspect.signature(function).parameters[name].default


def least_progress():
    """By what share of the error a motion must get nearer, to count as one that does.

    The error was 1 m, and becomes less bit by bit until that is noticed.
    """
    for share in np.arange(0.001, 1, 0.001):
        motion = SimpleNamespace(_best=1.0, _idle=1.0)
        CartesianMotion._watch(motion, PoseError(1 - share, 0.0))
        if motion._idle == 0:
            return share
    return np.inf


SAID = {
    "controllers/inverse_kinematics.md": [
        f"T = {CONTROL_PERIOD} s",
        f"share α = {IK.gain} of",
        f"radians by {IK.orientation_cost}",
        f"w₁ = {IK.posture_cost} and β = {IK.posture_gain}",
        f"w₂ = {IK.damping_cost} ",
        f"(within {100 * IK.detection:.0f} cm)",
        f"γ = {IK.approach_gain} of",
        f"clearance of {100 * IK.clearance:.0f} cm",
        f"T / γ = {CONTROL_PERIOD / IK.approach_gain:.1f} s",
        f"ζ = {LOOP[0]:.2f} for α = {IK.gain} and {LOOP[1]:.2f} for α = 0.5",
    ],
    "controllers/fine_motion.md": [
        rf"\frac{{t}}{{{FINE.ramp_time}\ \text{{s}}}}",
        f"the share α = {IK.gain} of the pose error per period T = {CONTROL_PERIOD} s",
        f"At v = {FINE.speed} m/s",
        f"more than {1e3 * FINE.speed * CONTROL_PERIOD / IK.gain:.0f} mm ahead",
        f"w = {FINE.windup} rad",
        f"it is {INSERT.rim_windup} rad at the rim, which with "
        f"{wam.SERVO.stiffness[0]} N m/rad and a lever of 0.7 m is "
        f"{wam.SERVO.stiffness[0] * INSERT.rim_windup / 0.7:.0f} N",
        f"within {1e3 * FINE.position_tolerance:.0f} mm, angle within "
        f"{FINE.angle_tolerance} rad, hand slower than {FINE.rest_speed} m/s",
        f"for {FINE.stall_time:.0f} s the error \\|e_x\\| + {_LEVER} m · \\|e_a\\| has "
        f"not fallen by another {100 * least_progress():.0f} %",
        f"felt the jar for {RELEASE_TIME} s",
        f"after {FINE.time_budget} s",
        f"goes at {PASSING.speed:.2f} m/s",
        f"{1e3 * PASSING.position_tolerance:.0f} mm and {PASSING.angle_tolerance} rad",
    ],
    "controllers/transit.md": [
        f"in steps of {PlannerSettings.step} rad",
        f"the point {TRANSIT.ahead} rad ahead",
        rf"\frac{{{TRANSIT.speed_share}\, \dot q_i^{{\max}}}}",
        rf"{TRANSIT.braking:.0f}\,\text{{s}}^{{-1}}\, s",
        f"{IK.velocity[1]} rad/s for the first two joints, {IK.velocity[3]} for the "
        f"next two and {IK.velocity[6]} for the wrist, below the WAM's "
        f"{wam.VELOCITY_LIMIT}",
        f"{LAG[0]:.3f} s at the shoulder, {LAG[2]:.4f} s at the next two joints, "
        f"{LAG[4]:.3f} s and {LAG[6]:.3f} s at the wrist",
        f"faster than {TRANSIT.carrying_speed} rad/s",
        f"at most {TRANSIT.acceleration:.0f} rad/s²",
        f"within {TRANSIT.torque_share} of its torque limit",
        f"Every {TRANSIT.look_period} s",
        f"Without progress for {TRANSIT.stall_time:.0f} s",
        f"Within {TRANSIT.handover} rad of its goal",
        f"{1e3 * GROSS.position_tolerance:.0f} mm and {GROSS.angle_tolerance:.2f} rad "
        f"for a reach, {POSTURE.tolerance} rad in every joint at less than "
        f"{POSTURE.rest_speed} rad/s for a posture",
        f"Its time budget is {TIME_BUDGET:.0f} s in all",
        f"with {GROSS.speed} m/s, {1e3 * GROSS.position_tolerance:.0f} mm and "
        f"{GROSS.angle_tolerance:.2f} rad, the turn about the palm's axis free, and "
        f"{GROSS.time_budget} s",
        f"the share {IK.gain} of the joint error",
    ],
    "controllers/grasp.md": [
        f"ε < {GRASP.residual_threshold},",
        f"offset of {1e3 * BALANCED * GRASP.contact_radius:.1f} mm",
        f"a tilt of {np.rad2deg(BALANCED):.1f}°",
        f"|dε/dt| < {GRASP.rate_threshold} 1/s",
        f"damped to {GRASP.gain} of itself",
        f"go {GRASP.squeeze_lead} rad beyond",
        f"with {barrett_hand.SERVO.stiffness:.0f} N m/rad",
        f"with {GRASP.least_force:.0f} N at least",
        f"tugs {1e3 * GRASP.tug:.0f} mm back",
        f"feel {GRASP.gripping_shear} N of",
        f"slips for {GRASP.tug_time} s",
        f"after {GRASP.time_budget:.0f} s",
    ],
    "controllers/insertion.md": [
        f"mean over {INSERT.tare_time} s",
        f"more than {INSERT.contact_force:.0f} N",
        f"up with more than {INSERT.waiting_force:.0f} N",
        f"v is {INSERT.free_speed} m/s above the rim, {INSERT.rim_speed} m/s",
        f"{INSERT.inner_speed:.2f} m/s inside",
        f"from {-1e3 * INSERT.rim_zone[0]:.0f} mm before the rim to "
        f"{1e3 * INSERT.rim_zone[1]:.0f} mm after it",
        rf"\max({1e3 * INSERT.lead:.0f}\,\text{{mm}},\, "
        rf"v \cdot {INSERT.lead_time}\,\text{{s}}),\; "
        rf"\text{{depth}} + {1e3 * INSERT.lead:.0f}\,\text{{mm}}",
        rf"c = 10^{{{np.log10(INSERT.compliance):.0f}}}\ \text{{m/N}}",
        rf"= {(1 - FRICTION) / (1 + FRICTION):.1f} \text{{ for }} \mu = {FRICTION}",
        f"{1e3 * INSERT.compliance / CONTROL_PERIOD:.0f} mm/s for each newton, up to "
        f"{1e3 * INSERT.yield_limit:.0f} mm",
        f"plates are {1e3 * PROPS.well.chamfer:.0f} mm wide, which at 45° is "
        f"{1e3 * PROPS.well.chamfer * 0.5**0.5:.1f} mm sideways",
        f"body is {1e3 * (PROPS.well.half_width - PROPS.jar.body_radius):.0f} mm",
        f"lid is {1e3 * (PROPS.jar.lid_radius - PROPS.well.half_width):.0f} mm wider",
        f"no progress of {1e3 * INSERT.progress:.0f} mm for {INSERT.jam_time} s",
        f"within {1e3 * INSERT.floor_tolerance:.0f} mm of its full depth",
        f"More than {INSERT.entered} of",
        f"hand goes {100 * INSERT.back_out:.0f} cm up",
        f"felt the jar for {RELEASE_TIME} s",
        f"after {INSERT.time_budget:.0f} s",
    ],
    "controllers/hand_motion.md": [
        f"{posture.OPEN[0]:.2f} rad for fingers 1 and 2, {posture.OPEN[2]:.2f} rad for "
        f"the thumb, which leaves the fingertips {100 * REACHED:.0f} cm from the hand",
        rf"{OPENING_SPEED}\ \text{{rad/s}} \cdot {CONTROL_PERIOD}\ \text{{s}} = "
        rf"{OPENING_SPEED * CONTROL_PERIOD:.2f}\ \text{{rad}}",
        f"farther than {TOLERANCE} rad from its angle, and has "
        f"{default(HandMotion, 'time_budget'):.0f} s",
        f"rests for {default(Weighing, 'rest')} s",
        f"averaged over {default(Weighing, 'duration')} s",
        rf"{barrett_hand.MASS}\ \text{{kg}} \cdot {GRAVITY}\ \text{{m/s}}^2 = "
        rf"{barrett_hand.MASS * GRAVITY:.1f}\ \text{{N}}",
        f"L is more than {default(Weighing, 'share')} of the jar's "
        f"{PROPS.jar.mass * GRAVITY:.1f} N",
        f"for more than {RELEASE_TIME} s",
    ],
    "mdp.md": [
        f"|v|² = {FEATURES.energy}",
        f"α = {ALPHA} and",
        f"ε = {LEARNER.epsilon},",
        f"discount γ = {GAMMA}",
        f"deviation of {LEARNER.initial_sd}",
        f"|φ|² = {FEATURES.energy} + 1 = {UNHELD} and α |φ|² = {ALPHA * UNHELD:.4f}",
        f"in about {1 / (ALPHA * UNHELD):.0f} updates",
        f"= {HELD:.1f}, and it takes {1 / (ALPHA * HELD):.0f}.",
        f"-{1 + GAMMA:.2f}",
        f"-{1 + GAMMA + GAMMA**2:.4f}",
        f"-{sum(GAMMA**k for k in range(4)):.4f}",
        f"-1 / (1 - γ) = -{1 / (1 - GAMMA):.0f}",
        f"a mean of at most {NEAR_OPTIMAL} over ten trials",
    ],
}
"""Page: what it must say, as the code has it."""


def said(page):
    return " ".join((DOCS / page).read_text("utf-8").split())


@pytest.mark.parametrize(
    ("page", "words"), [(page, words) for page, said in SAID.items() for words in said]
)
def test_number(page, words):
    assert words in said(page)


def test_numbers_of_the_state():
    model = compile_scene(SceneSettings())
    size = mujoco.mj_stateSize(model, mujoco.mjtState.mjSTATE_INTEGRATION)
    assert f"that of the simulation, {size} numbers" in said("mdp.md")


def test_numbers_of_the_optimum():
    best = optimum(Recording.load())
    assert f"comes to {best.actions.mean:.2f} actions" in said("mdp.md")
    assert f"and is {best.exploring.mean:.2f} actions" in said("mdp.md")
    assert PickPlaceSettings.max_actions == 10
    assert "*truncated* after ten actions" in said("mdp.md")
