"""Compliant insertion: lower a held object into a receptacle by feel.

Vertically the reference runs at most a few millimetres ahead of the measured hand and
waits while the wrist feels more than a threshold; laterally an admittance yields to the
contact force, which lets a chamfer guide the object in. No progress under load is a
jam; the hand then backs out with the object.
"""

from collections.abc import Generator

import mink
import numpy as np

from prospect_mj.control.arm_control import ArmControl
from prospect_mj.control.controller import (
    CONTROL_PERIOD,
    ProceduralController,
    Procedure,
)
from prospect_mj.control.grip_watch import GripWatch
from prospect_mj.control.hand_servo import HandServo
from prospect_mj.control.insertion_settings import (
    LOWERING,
    InsertionResult,
    InsertionSettings,
)
from prospect_mj.control.result import Measured, Status, Targets
from prospect_mj.robot.torso import ArmReading, Reading

Stage = Generator[Targets, ArmReading, ArmReading]


class InsertionController(ProceduralController):
    """Lower what the hand holds by a known distance, or find that it does not fit.

    Args:
        arm: which arm, and its kinematics.
        start: pose of the grasp site with the object aligned above the receptacle.
        free: how far the object can go down before it can touch the rim [m].
        depth: how far it goes down in all to stand on the floor [m].
        posture: joint angles (7,) [rad] that resolve the redundancy.
        settings: speeds and forces.
    """

    def __init__(
        self,
        arm: ArmControl,
        start: mink.SE3,
        free: float,
        depth: float,
        posture: np.ndarray,
        settings: InsertionSettings | None = None,
    ) -> None:
        """Start aligned above the receptacle."""
        self._settings = InsertionSettings() if settings is None else settings
        super().__init__(arm.side, self._settings.time_budget)
        self._arm, self._start = arm, start
        self._free, self._depth = free, depth
        self._servo = HandServo(arm, posture, LOWERING)
        self._grip = GripWatch()
        self._tare, self._shift = np.zeros(3), np.zeros(3)
        self._peak, self._deepest = 0.0, 0.0

    def _law(self, reading: Reading) -> Targets:
        if self._grip.lost(reading[self.side].touch):
            self._finish(Status.LOST, GripWatch.REASON)
            return Targets()
        return super()._law(reading)

    def _finish(self, status: Status, reason: str = "", jammed: bool = False) -> None:
        self.result = InsertionResult(
            status, reason, self.seconds, jammed, self._deepest, self._peak
        )

    def _procedure(self) -> Procedure:
        own = yield Targets()
        own = yield from self._weigh(own)
        own = yield from self._descend(own)
        inside = self._deepest - self._free
        if inside > self._settings.entered * (self._depth - self._free):
            self._finish(Status.CONVERGED)
            return
        supported = self._supported(own)
        yield from self._back_out(own)
        millimetres = (self._depth - self._deepest) * 1e3
        manner = "supported" if supported else "blocked"
        reason = f"{manner} {millimetres:.0f} mm above the floor"
        self._finish(Status.STALLED, reason, jammed=supported)

    def _travelled(self) -> float:
        """How far the hand is below its start [m]."""
        height = self._arm.grasp_pose().translation()[2]
        return float(self._start.translation()[2] - height)

    def _wrist_force(self, own: ArmReading) -> np.ndarray:
        return self._arm.twin.wrist_rotation(self.side) @ own.wrist_force

    def _contact_force(self, own: ArmReading) -> np.ndarray:
        """Force of the surroundings on the held object (3,) [N], world frame."""
        # The flange carries hand and object less what the surroundings push up with.
        force = self._tare - self._wrist_force(own)
        strength = float(np.linalg.norm(force))
        self.measured = Measured(contact_force=strength)
        self._peak = max(self._peak, strength)
        return force

    def _supported(self, own: ArmReading) -> bool:
        return bool(self._contact_force(own)[2] > self._settings.contact_force)

    def _weigh(self, own: ArmReading) -> Stage:
        """Tare the wrist while nothing touches the object."""
        forces = []
        for _ in range(round(self._settings.tare_time / CONTROL_PERIOD)):
            forces.append(self._wrist_force(own))
            own = yield Targets(joints=self._servo.step(own, self._start))
        self._tare = np.mean(forces, axis=0)
        return own

    def _descend(self, own: ArmReading) -> Stage:
        """Go down until the floor is reached or nothing moves any more."""
        settings = self._settings
        floor = self._depth - settings.floor_tolerance
        reference, mark, idle = 0.0, 0.0, 0.0
        while idle < settings.jam_time and not (
            self._deepest > floor and self._supported(own)
        ):
            travelled = self._travelled()
            advanced = travelled > mark + settings.progress
            mark = travelled if advanced else mark
            idle = 0.0 if advanced else idle + CONTROL_PERIOD
            force = self._contact_force(own)
            self._yield_to(force, travelled)
            speed, windup = self._pace(travelled)
            reference = self._ahead(reference, travelled, speed, float(force[2]))
            below = self._below(reference)
            own = yield Targets(joints=self._servo.step(own, below, windup))
            self._deepest = max(self._deepest, self._travelled())
        return own

    def _pace(self, travelled: float) -> tuple[float, float]:
        """Descent speed [m/s] and servo lead [rad] at a height."""
        settings = self._settings
        first, last = (self._free + edge for edge in settings.rim_zone)
        if travelled < first:
            return settings.free_speed, settings.windup
        if travelled < last:
            return settings.rim_speed, settings.rim_windup
        return settings.inner_speed, settings.windup

    def _ahead(
        self, reference: float, travelled: float, speed: float, load: float
    ) -> float:
        """Next reference [m]: ahead of the hand, unless the load [N] says to wait."""
        settings = self._settings
        if load > settings.waiting_force:
            return min(reference, travelled)
        lead = max(settings.lead, speed * settings.lead_time)
        end = self._depth + settings.lead
        return min(reference + speed * CONTROL_PERIOD, travelled + lead, end)

    def _yield_to(self, force: np.ndarray, travelled: float) -> None:
        """Lateral admittance, once the object can be in touch with the receptacle."""
        if travelled < self._free + self._settings.rim_zone[0]:
            return
        shift = self._shift + self._settings.compliance * force * [1, 1, 0]
        length = float(np.linalg.norm(shift))
        self._shift = shift * min(1.0, self._settings.yield_limit / max(length, 1e-9))

    def _below(self, distance: float) -> mink.SE3:
        place = self._start.translation() + self._shift - [0, 0, distance]
        return mink.SE3.from_rotation_and_translation(self._start.rotation(), place)

    def _back_out(self, own: ArmReading) -> Stage:
        """Straight up out of the rim, with the object still in the hand."""
        settings = self._settings
        reference = self._travelled()
        target = max(0.0, reference - settings.back_out)
        while self._travelled() > target + settings.back_out_tolerance:
            reference = max(target, reference - settings.free_speed * CONTROL_PERIOD)
            own = yield Targets(joints=self._servo.step(own, self._below(reference)))
        return own
