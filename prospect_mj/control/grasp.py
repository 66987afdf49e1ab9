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

import mink
import numpy as np

from prospect_mj.control.arm_control import ArmControl
from prospect_mj.control.cartesian_motion import HandServo, MotionSettings
from prospect_mj.control.contact_residual import (
    ContactResidual,
    contact_residual,
    required_friction,
)
from prospect_mj.control.controller import CONTROL_PERIOD, Controller
from prospect_mj.control.grasp_settings import GraspResult, GraspSettings
from prospect_mj.control.result import Status, Targets
from prospect_mj.robot.torso import ArmReading, Reading

_CORRECTION = MotionSettings(
    speed=0.10,
    turn_speed=1.0,
    position_tolerance=0.0008,
    angle_tolerance=0.008,
    free_roll=False,
    windup=0.15,
    time_budget=0.6,
)


class GraspController(Controller):
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
        self._residual: ContactResidual | None = None
        self._rate: float | None = None
        self._friction: float | None = None
        self._trajectory: list[tuple[float, float]] = []
        self._procedure = self._grasp()
        next(self._procedure)

    def _law(self, reading: Reading) -> Targets:
        try:
            return self._procedure.send(reading[self.side])
        except StopIteration:
            return Targets()

    def _finish(self, status: Status, reason: str = "") -> None:
        self.result = GraspResult(
            status,
            reason,
            self.seconds,
            residual=None if self._residual is None else self._residual.value,
            residual_rate=self._rate,
            required_friction=self._friction,
            probes=self._probes,
            trajectory=tuple(self._trajectory),
        )

    def _grasp(self) -> Generator[Targets, ArmReading, None]:
        own = yield Targets()
        while True:
            own = yield from self._touch(own)
            if self._residual is None:
                self._finish(Status.LOST, "the fingers closed without touching")
                return
            if self._balanced():
                break
            if self._probes >= self._settings.max_probes:
                reason = f"residual {self._residual.value:.3f} does not fall"
                self._finish(Status.STALLED, reason)
                return
            own = yield from self._correct(own)
        own = yield from self._squeeze(own)
        self._judge(own)

    def _balanced(self) -> bool:
        settings = self._settings
        assert self._residual is not None
        assert self._rate is not None
        at_rest = abs(self._rate) < settings.rate_threshold
        return self._residual.value < settings.residual_threshold and at_rest

    def _touch(self, own: ArmReading) -> Generator[Targets, ArmReading, ArmReading]:
        """Close each finger until it touches; measure the residual of the contacts."""
        settings = self._settings
        self._probes += 1
        self._residual = None
        settled, motors = 0.0, own.finger_command
        latched = np.zeros(3, dtype=bool)
        step = settings.closing_speed * CONTROL_PERIOD
        while settled < settings.settle_time:
            pressing = own.touch.found & (own.touch.force > settings.touch_force)
            # Measured, not commanded: the servo lags, and would push on by its lag.
            motors = np.where(
                pressing & ~latched, own.fingers + settings.touch_lead, motors
            )
            latched = pressing | (latched & own.touch.found)
            touching = latched
            motors = np.where(latched, motors, motors + step)
            if (motors > settings.closed).any():
                self._residual = None
                return own
            settled = settled + CONTROL_PERIOD if touching.all() else 0.0
            if touching.all():
                self._measure(own)
            own = yield Targets(fingers=motors)
        return own

    def _measure(self, own: ArmReading) -> None:
        before = self._residual
        touch = own.touch
        self._residual = contact_residual(touch.position, touch.normal)
        self._friction = required_friction(touch.position, touch.normal)
        change = 0.0 if before is None else self._residual.value - before.value
        self._rate = change / CONTROL_PERIOD
        self._trajectory.append((self.seconds, self._residual.value))

    def _correct(self, own: ArmReading) -> Generator[Targets, ArmReading, ArmReading]:
        """Lift the fingers off, then take back the offset and tilt of the hand."""
        settings = self._settings
        assert self._residual is not None
        target = self._corrected(self._residual)
        apart = own.fingers - settings.lift_off
        for _ in range(round(settings.lift_off_time / CONTROL_PERIOD)):
            own = yield Targets(fingers=apart)
        for _ in range(round(_CORRECTION.time_budget / CONTROL_PERIOD)):
            error = self._servo.error(target)
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

    def _judge(self, own: ArmReading) -> None:
        weakest = float(own.touch.force.min())
        if not own.touch.found.all() or weakest < self._settings.least_force:
            reason = f"the weakest fingertip presses with {weakest:.1f} N"
            self._finish(Status.LOST, reason)
        else:
            self._finish(Status.CONVERGED)


def _across(vector: np.ndarray, axis: np.ndarray) -> np.ndarray:
    return vector - (vector @ axis) * axis
