"""How an object is lowered into a receptacle, and what comes of it."""

from dataclasses import dataclass

from prospect_mj.control.hand_servo import MotionSettings
from prospect_mj.control.result import ControlResult

LOWERING = MotionSettings(
    speed=0.15,
    turn_speed=0.5,
    position_tolerance=0.0,
    angle_tolerance=0.0,
    free_roll=False,
    windup=0.03,
    time_budget=10.0,
)
"""Motion of the hand while it inserts; how it ends is the insertion's affair."""


@dataclass(frozen=True)
class InsertionSettings:
    """Speeds, forces and what counts as a jam."""

    free_speed: float = 0.12
    """Descent while the object is above the rim [m/s]."""
    rim_speed: float = 0.03
    """Descent where the object may meet the rim [m/s]."""
    rim_zone: tuple[float, float] = (-0.018, 0.004)
    """That stretch, relative to where the object's lower end passes the rim [m]."""
    rim_windup: float = 0.012
    """Servo lead there [rad]: about 15 N at the hand, which no grip of three times
    15 N slips under."""
    inner_speed: float = 0.10
    """Descent inside [m/s]."""
    windup: float = 0.03
    """Servo lead elsewhere [rad]."""
    lead: float = 0.004
    """Most that the reference is ahead of the measured height [m]."""
    lead_time: float = 0.15
    """The same as a time at the present speed [s]: what the servo law needs to keep
    that speed up."""
    compliance: float = 1e-4
    """Lateral shift per force and control period [m/N]."""
    yield_limit: float = 0.015
    """Most that the object may be guided sideways [m]."""
    waiting_force: float = 8.0
    """Above which the reference does not go down any further [N]."""
    contact_force: float = 2.0
    """Above which the object is felt to be supported [N]."""
    jam_time: float = 0.4
    """Supported without 1 mm of progress for this long is a jam, or the floor [s]."""
    progress: float = 0.001
    """[m]"""
    tare_time: float = 0.08
    """Averaging of the wrist sensor before the descent [s]."""
    back_out: float = 0.08
    """Height regained after a jam [m]."""
    back_out_tolerance: float = 0.01
    """How near to that is near enough [m]."""
    floor_tolerance: float = 0.008
    """How near to its full depth a supported object stands on the floor [m]."""
    entered: float = 0.6
    """Share of the receptacle's depth beyond which a stop is no jam on the rim: room
    for an object that has slipped in the hand, so that its height is uncertain."""
    time_budget: float = 10.0
    """[s]"""


@dataclass(frozen=True)
class InsertionResult(ControlResult):
    """The end of an insertion."""

    jammed: bool = False
    """Whether the object stopped on the rim; it is then still in the hand."""
    depth: float = 0.0
    """How far the hand went down below its start at most [m]."""
    peak_force: float = 0.0
    """Largest contact force that the wrist felt [N]."""
