"""How a grasp is probed and squeezed, and what it returns."""

from dataclasses import dataclass

from prospect_mj.control.controller import CONTROL_PERIOD
from prospect_mj.control.result import ControlResult


@dataclass(frozen=True)
class GraspSettings:
    """How to probe and how hard to squeeze."""

    closing_speed: float = 1.2
    """Of the finger motors [rad/s]."""
    touch_force: float = 0.3
    """At which a finger stops closing [N]."""
    touch_lead: float = 0.008
    """Servo lead that keeps a stopped finger in touch [rad]."""
    closed: float = 1.9
    """Motor angle at which nothing can be between the fingers any more [rad]."""
    settle_time: float = 0.06
    """All three must touch for this long before the residual counts [s]."""
    residual_threshold: float = 0.02
    """eps below which the contacts balance [1]."""
    rate_threshold: float = 0.2
    """|d eps/dt| below which the residual is at rest [1/s]."""
    gain: float = 0.9
    """Share of the Newton step taken per probe."""
    contact_radius: float = 0.05
    """Object radius plus fingertip radius [m]."""
    lift_off: float = 0.16
    """How far the fingers open before the hand is displaced [rad]."""
    lift_off_time: float = 0.1
    """[s]"""
    max_probes: int = 6
    squeeze_lead: float = 0.075
    """Final servo lead [rad]; 25 N m/rad make 17 N per fingertip of it."""
    squeeze_time: float = 0.2
    """[s]"""
    tug: float = 0.004
    """How far the hand pulls back along the palm's axis to feel its grip [m]."""
    tug_time: float = 0.3
    """For how long it tries [s]."""
    gripping_shear: float = 1.5
    """Tangential force of all fingertips together that proves a grip [N]."""
    least_force: float = 4.0
    """Every fingertip must press at least this hard in the end [N]."""
    time_budget: float = 5.0
    """[s]"""

    @property
    def closing_step(self) -> float:
        """Of a finger motor in one control period [rad]."""
        return self.closing_speed * CONTROL_PERIOD


@dataclass(frozen=True)
class GraspResult(ControlResult):
    """The end of a grasp; the numbers are None if the object was never touched."""

    residual: float | None = None
    """eps at the last probe [1]."""
    residual_rate: float | None = None
    """d eps/dt at the last probe [1/s]."""
    required_friction: float | None = None
    """Coefficient that the contacts need, infinite if they cannot balance."""
    probes: int = 0
    trajectory: tuple[tuple[float, float], ...] = ()
    """(seconds, eps) of every control period in which all three tips touched."""
