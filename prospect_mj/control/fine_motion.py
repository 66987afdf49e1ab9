"""Fine motion: slow and exact movements of a hand over the last decimetres."""

from dataclasses import replace

import numpy as np

from prospect_mj.control.cartesian_motion import CartesianMotion
from prospect_mj.control.hand_servo import MotionSettings

FINE = MotionSettings(
    speed=0.35,
    turn_speed=1.5,
    position_tolerance=0.002,
    angle_tolerance=0.015,
    free_roll=False,
    windup=0.15,
    time_budget=2.5,
    rest_speed=0.02,
)

PASSING = replace(
    FINE, speed=0.40, position_tolerance=0.012, angle_tolerance=0.05, rest_speed=np.inf
)
"""Fine motion through a point on the way: lifting, backing out."""


class FineMotion(CartesianMotion):
    """Position a hand exactly, all six degrees of freedom held."""

    DEFAULTS = FINE
