"""Numbers on the pages of controllers and task are those of the code."""

# ruff: noqa: RUF001 - the pages' formulas have Greek letters

import numpy as np
import pytest
from pages import DOCS

from prospect_mj.agent import FeatureSettings, LearnerSettings
from prospect_mj.control.controller import CONTROL_PERIOD
from prospect_mj.control.differential_ik import IKSettings
from prospect_mj.control.fine_motion import FINE, PASSING
from prospect_mj.control.grasp_settings import GraspSettings
from prospect_mj.control.grip_watch import RELEASE_TIME
from prospect_mj.control.insertion_settings import InsertionSettings
from prospect_mj.control.straight_reach import GROSS
from prospect_mj.control.transit import TransitSettings
from prospect_mj.control.weighing import GRAVITY
from prospect_mj.robot import barrett_hand, wam
from prospect_mj.sim.props import Props

IK, GRASP, INSERT = IKSettings(), GraspSettings(), InsertionSettings()
TRANSIT = TransitSettings()
PROPS, LEARNER, FEATURES = Props(), LearnerSettings(), FeatureSettings()
LAG = (np.array(wam.SERVO.damping) + wam.SERVO.friction_damping) / wam.SERVO.stiffness
LOOP = [(CONTROL_PERIOD / (gain * LAG[0])) ** 0.5 / 2 for gain in (IK.gain, 0.5)]
BALANCED = GRASP.residual_threshold**0.5 / 1.5
ALPHA, GAMMA = LEARNER.step_size, LEARNER.discount
UNHELD, HELD = FEATURES.energy + 1, 2 * FEATURES.energy + 2

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
        f"At v = {FINE.speed} m/s",
        f"more than {1e3 * FINE.speed * CONTROL_PERIOD / IK.gain:.0f} mm ahead",
        f"w = {FINE.windup} rad",
        f"it is {INSERT.rim_windup} rad",
        f"within {1e3 * FINE.position_tolerance:.0f} mm, angle within "
        f"{FINE.angle_tolerance} rad, hand slower than {FINE.rest_speed} m/s",
        f"felt the jar for {RELEASE_TIME} s",
        f"after {FINE.time_budget} s",
        f"goes at {PASSING.speed:.2f} m/s",
        f"{1e3 * PASSING.position_tolerance:.0f} mm and {PASSING.angle_tolerance} rad",
    ],
    "controllers/transit.md": [
        f"the point {TRANSIT.ahead} rad ahead",
        f"{LAG[0]:.3f} s at the shoulder, {LAG[2]:.4f} s at the next two joints, "
        f"{LAG[4]:.3f} s and {LAG[6]:.3f} s at the wrist",
        f"faster than {TRANSIT.carrying_speed} rad/s",
        f"at most {TRANSIT.acceleration:.0f} rad/s²",
        f"within {TRANSIT.torque_share} of its torque limit",
        f"Every {TRANSIT.look_period} s",
        f"Within {TRANSIT.handover} rad of its goal",
        f"with {GROSS.speed} m/s, {1e3 * GROSS.position_tolerance:.0f} mm and "
        f"{GROSS.angle_tolerance:.2f} rad",
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
        f"{1e3 * INSERT.compliance / CONTROL_PERIOD:.0f} mm/s for each newton, up to "
        f"{1e3 * INSERT.yield_limit:.0f} mm",
        f"plates are {1e3 * PROPS.well.chamfer:.0f} mm wide, which at 45° is "
        f"{1e3 * PROPS.well.chamfer * 0.5**0.5:.1f} mm sideways",
        f"body is {1e3 * (PROPS.well.half_width - PROPS.jar.body_radius):.0f} mm",
        f"lid is {1e3 * (PROPS.jar.lid_radius - PROPS.well.half_width):.0f} mm wider",
        f"More than {INSERT.entered} of",
        f"hand goes {100 * INSERT.back_out:.0f} cm up",
    ],
    "controllers/hand_motion.md": [
        f"L is more than 0.4 of the jar's {PROPS.jar.mass * GRAVITY:.1f} N",
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
    ],
}
"""Page: what it must say, as the code has it."""


@pytest.mark.parametrize(
    ("page", "words"), [(page, words) for page, said in SAID.items() for words in said]
)
def test_number(page, words):
    assert words in " ".join((DOCS / page).read_text("utf-8").split())
