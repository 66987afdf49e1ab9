"""Straight reach: gross motion without planning, the ablation of the harmonic one."""

from prospect_mj.control.cartesian_motion import CartesianMotion
from prospect_mj.control.hand_servo import MotionSettings

GROSS = MotionSettings(
    speed=0.5,
    turn_speed=1.7,
    position_tolerance=0.015,
    angle_tolerance=0.10,
    free_roll=True,
    windup=0.15,
    time_budget=3.5,
)


class StraightReach(CartesianMotion):
    """Reach straight for a pose; mink's limits keep the links clear of everything."""

    DEFAULTS = GROSS
