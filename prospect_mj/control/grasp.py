"""Grasp control: probe, correct by the force and moment residuals, squeeze, lock.

After Coelho & Grupen (1997): the fingers close until each touches, the contacts'
residual is measured, the fingers lift off and the hand moves so as to reduce it. For
three contacts evenly round a cylinder of radius r an offset d of the hand gives
rho_f = -(3/2) d / r, a tilt a gives rho_m = (3/2) a, which the hand takes back in one
damped Newton step. Displacing the hand while the fingers still touch would drag the
object along and leave the residual as it was. Once the residual is small the fingers
squeeze and stay where they are: the hand is non-backdrivable.
"""

from collections.abc import Generator
from dataclasses import dataclass

import mink
import numpy as np

from prospect_mj.control.arm_control import ArmControl
from prospect_mj.control.contact_residual import (
    ContactResidual,
    contact_residual,
    required_friction,
)
from prospect_mj.control.controller import (
    CONTROL_PERIOD,
    ProceduralController,
    Procedure,
)
from prospect_mj.control.grasp_settings import GraspResult, GraspSettings
from prospect_mj.control.hand_servo import HandServo, MotionSettings
from prospect_mj.control.result import Measured, Status, Targets
from prospect_mj.robot.torso import ArmReading, Touch

_CORRECTION = MotionSettings(
    speed=0.10,
    turn_speed=1.0,
    position_tolerance=0.0008,
    angle_tolerance=0.008,
    free_roll=False,
    windup=0.15,
    time_budget=0.6,
)


@dataclass(frozen=True)
class Probe:
    """What the fingertips told while all three touched."""

    residual: ContactResidual
    rate: float
    """d eps/dt [1/s]."""
    friction: float
    """Coefficient that the contacts need."""


class GraspController(ProceduralController):
    """Close the hand of one arm on whatever is between its fingers.

    Args:
        arm: which arm, and its kinematics.
        posture: joint angles (7,) [rad] that resolve the redundancy.
        settings: of probing and squeezing.
    """

    def __init__(
        self,
        arm: ArmControl,
        posture: np.ndarray,
        settings: GraspSettings | None = None,
    ) -> None:
        """Start from an open hand round the object."""
        self._settings = GraspSettings() if settings is None else settings
        super().__init__(arm.side, self._settings.time_budget)
        self._arm = arm
        self._servo = HandServo(arm, posture, _CORRECTION)
        self._probes = 0
        self._last: Probe | None = None
        self._trajectory: list[tuple[float, float]] = []

    def _finish(self, status: Status, reason: str = "") -> None:
        probe = self._last
        self.result = GraspResult(
            status,
            reason,
            self.seconds,
            residual=None if probe is None else probe.residual.value,
            residual_rate=None if probe is None else probe.rate,
            required_friction=None if probe is None else probe.friction,
            probes=self._probes,
            trajectory=tuple(self._trajectory),
        )

    def _procedure(self) -> Procedure:
        own = yield Targets()
        while True:
            own, probe = yield from self._touch(own)
            if probe is None:
                self._finish(Status.LOST, "the fingers closed without touching")
                return
            if self._balanced(probe):
                break
            if self._probes >= self._settings.max_probes:
                reason = f"residual {probe.residual.value:.3f} does not fall"
                self._finish(Status.STALLED, reason)
                return
            own = yield from self._correct(own, probe.residual)
        own = yield from self._squeeze(own)
        weakest = float(own.touch.force.min())
        if not own.touch.found.all() or weakest < self._settings.least_force:
            reason = f"the weakest fingertip presses with {weakest:.1f} N"
            self._finish(Status.LOST, reason)
            return
        yield from self._tug(own)

    def _balanced(self, probe: Probe) -> bool:
        small = probe.residual.value < self._settings.residual_threshold
        return small and abs(probe.rate) < self._settings.rate_threshold

    def _touch(
        self, own: ArmReading
    ) -> Generator[Targets, ArmReading, tuple[ArmReading, Probe | None]]:
        """Close each finger until it touches; measure the residual of the contacts."""
        settings = self._settings
        self._probes += 1
        probe, settled, motors = None, 0.0, own.finger_command
        latched = np.zeros(3, dtype=bool)
        while settled < settings.settle_time:
            pressing = own.touch.found & (own.touch.force > settings.touch_force)
            # Measured, not commanded: the servo lags, and would push on by its lag.
            held = own.fingers + settings.touch_lead
            motors = np.where(pressing & ~latched, held, motors)
            latched = pressing | (latched & own.touch.found)
            motors = np.where(latched, motors, motors + settings.closing_step)
            if (motors > settings.closed).any():
                return own, None
            settled = settled + CONTROL_PERIOD if latched.all() else 0.0
            if latched.all():
                probe = self._measure(own.touch, probe)
            own = yield Targets(fingers=motors)
        return own, probe

    def _measure(self, touch: Touch, before: Probe | None) -> Probe:
        residual = contact_residual(touch.position, touch.normal)
        change = 0.0 if before is None else residual.value - before.residual.value
        friction = required_friction(touch.position, touch.normal)
        self._trajectory.append((self.seconds, residual.value))
        self.measured = Measured(residual=residual.value)
        self._last = Probe(residual, change / CONTROL_PERIOD, friction)
        return self._last

    def _correct(
        self, own: ArmReading, residual: ContactResidual
    ) -> Generator[Targets, ArmReading, ArmReading]:
        """Lift the fingers off, then take back the offset and tilt of the hand."""
        settings = self._settings
        target = self._corrected(residual)
        apart = own.fingers - settings.lift_off
        for _ in range(round(settings.lift_off_time / CONTROL_PERIOD)):
            own = yield Targets(fingers=apart)
        for _ in range(round(_CORRECTION.time_budget / CONTROL_PERIOD)):
            error = self._servo.error(target)
            self.measured = Measured(
                position_error=error.position, angle_error=error.angle
            )
            if (
                error.position < _CORRECTION.position_tolerance
                and error.angle < _CORRECTION.angle_tolerance
            ):
                break
            own = yield Targets(joints=self._servo.step(own, target))
        return own

    def _corrected(self, residual: ContactResidual) -> mink.SE3:
        settings = self._settings
        pose = self._arm.grasp_pose()
        palm_axis = pose.rotation().as_matrix()[:, 2]
        share = settings.gain / 1.5
        shift = share * settings.contact_radius * _across(residual.force, palm_axis)
        turn = -share * _across(residual.moment, palm_axis)
        rotation = mink.SO3.exp(turn) @ pose.rotation()
        return mink.SE3.from_rotation_and_translation(
            rotation, pose.translation() + shift
        )

    def _squeeze(self, own: ArmReading) -> Generator[Targets, ArmReading, ArmReading]:
        """Press with all fingers together, then leave the motors where they are."""
        settings = self._settings
        start = own.fingers
        n = round(settings.squeeze_time / CONTROL_PERIOD)
        for i in range(n):
            lead = settings.touch_lead + (i + 1) / n * (
                settings.squeeze_lead - settings.touch_lead
            )
            own = yield Targets(fingers=start + lead)
        for _ in range(round(settings.settle_time / CONTROL_PERIOD)):
            own = yield Targets()
        return own

    def _tug(self, own: ArmReading) -> Procedure:
        """Pull a little along the palm's axis: an object that is gripped resists."""
        settings = self._settings
        pose = self._arm.grasp_pose()
        back = pose.translation() - settings.tug * pose.rotation().as_matrix()[:, 2]
        target = mink.SE3.from_rotation_and_translation(pose.rotation(), back)
        strongest = 0.0
        for _ in range(round(settings.tug_time / CONTROL_PERIOD)):
            own = yield Targets(joints=self._servo.step(own, target))
            strongest = max(strongest, float(own.touch.shear.sum()))
            if strongest > settings.gripping_shear:
                self._finish(Status.CONVERGED)
                return
        reason = f"the fingers slip at {strongest:.1f} N: not graspable"
        self._finish(Status.STALLED, reason)


def _across(vector: np.ndarray, axis: np.ndarray) -> np.ndarray:
    return vector - (vector @ axis) * axis
