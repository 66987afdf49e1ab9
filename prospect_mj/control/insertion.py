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
from prospect_mj.control.cartesian_motion import (
    MIN_CONTACTS,
    RELEASE_TIME,
    HandServo,
    MotionSettings,
)
from prospect_mj.control.controller import CONTROL_PERIOD, Controller
from prospect_mj.control.insertion_settings import InsertionResult, InsertionSettings
from prospect_mj.control.result import Status, Targets
from prospect_mj.robot.torso import ArmReading, Reading

_MOTION = MotionSettings(
    speed=0.15,
    turn_speed=0.5,
    position_tolerance=0.0,
    angle_tolerance=0.0,
    free_roll=False,
    windup=0.03,
    time_budget=8.0,
)


class InsertionController(Controller):
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
        self._arm, self._free, self._depth = arm, free, depth
        self._servo = HandServo(arm, posture, _MOTION)
        self._start = start
        self._shift = np.zeros(3)
        self._peak, self._reached = 0.0, 0.0
        self._tare = np.zeros(3)
        self._empty = 0.0
        self._procedure = self._insert()
        next(self._procedure)

    def _law(self, reading: Reading) -> Targets:
        own = reading[self.side]
        held = own.touch.found.sum() >= MIN_CONTACTS
        self._empty = 0.0 if held else self._empty + CONTROL_PERIOD
        if self._empty > RELEASE_TIME:
            self._finish(Status.LOST, "fewer than two fingertips feel the object")
            return Targets()
        try:
            return self._procedure.send(own)
        except StopIteration:
            return Targets()

    def _end(self, status: Status, reason: str = "", jammed: bool = False) -> None:
        self.result = InsertionResult(
            status, reason, self.seconds, jammed, self._reached, self._peak
        )

    def _finish(self, status: Status, reason: str = "") -> None:
        self._end(status, reason)

    def _travelled(self) -> float:
        height = self._arm.grasp_pose().translation()[2]
        return float(self._start.translation()[2] - height)

    def _contact_force(self, own: ArmReading) -> np.ndarray:
        """Force of the surroundings on the held object (3,) [N], world frame."""
        # The flange carries hand and object less what the surroundings push up with.
        rotation = self._arm.twin.wrist_rotation(self.side)
        force = self._tare - rotation @ own.wrist_force
        self._peak = max(self._peak, float(np.linalg.norm(force)))
        return force

    def _insert(self) -> Generator[Targets, ArmReading, None]:
        own = yield Targets()
        own = yield from self._weigh(own)
        own, supported = yield from self._descend(own)
        self._reached = reached = self._travelled()
        entered = self._settings.entered * (self._depth - self._free)
        if reached > self._free + entered:
            self._end(Status.CONVERGED)
            return
        yield from self._retreat(own, max(0.0, reached - self._settings.back_out))
        millimetres = (self._depth - reached) * 1e3
        reason = f"supported {millimetres:.0f} mm above the floor"
        self._end(Status.STALLED, reason if supported else "blocked", jammed=True)

    def _weigh(self, own: ArmReading) -> Generator[Targets, ArmReading, ArmReading]:
        """Tare the wrist while nothing touches the object."""
        n = round(self._settings.tare_time / CONTROL_PERIOD)
        self._tare = np.zeros(3)
        total = np.zeros(3)
        for _ in range(n):
            total -= self._contact_force(own)
            own = yield Targets(joints=self._servo.step(own, self._start))
        self._tare, self._peak = total / n, 0.0
        return own

    def _descend(
        self, own: ArmReading
    ) -> Generator[Targets, ArmReading, tuple[ArmReading, bool]]:
        settings = self._settings
        reference, deepest, idle, supported = 0.0, 0.0, 0.0, False
        while idle < settings.jam_time:
            force = self._contact_force(own)
            travelled = self._travelled()
            supported = force[2] > settings.contact_force
            advanced = travelled > deepest + settings.progress
            deepest = travelled if advanced else deepest
            idle = 0.0 if advanced else idle + CONTROL_PERIOD
            if supported and travelled > self._depth - settings.floor_tolerance:
                break
            self._yield_to(force, travelled)
            speed, windup = self._pace(travelled)
            lead = max(settings.lead, speed * settings.lead_time)
            if force[2] > settings.waiting_force:
                reference, lead = min(reference, travelled), 0.0
            ahead = reference + speed * CONTROL_PERIOD
            reference = min(ahead, travelled + lead, self._depth + 0.004)
            below = self._below(reference)
            own = yield Targets(joints=self._servo.step(own, below, windup))
        return own, supported

    def _pace(self, travelled: float) -> tuple[float, float]:
        """Descent speed [m/s] and servo lead [rad] at a height."""
        settings = self._settings
        first, last = (self._free + edge for edge in settings.rim_zone)
        if travelled < first:
            return settings.free_speed, settings.windup
        if travelled < last:
            return settings.rim_speed, settings.rim_windup
        return settings.inner_speed, settings.windup

    def _yield_to(self, force: np.ndarray, travelled: float) -> None:
        """Lateral admittance, once the object can be in touch with the receptacle."""
        if travelled < self._free - 0.005:
            return
        shift = self._shift + self._settings.compliance * force * [1, 1, 0]
        length = float(np.linalg.norm(shift))
        limit = self._settings.yield_limit
        self._shift = shift if length <= limit else shift * (limit / length)

    def _below(self, distance: float) -> mink.SE3:
        place = self._start.translation() + self._shift - [0, 0, distance]
        return mink.SE3.from_rotation_and_translation(self._start.rotation(), place)

    def _retreat(
        self, own: ArmReading, target: float
    ) -> Generator[Targets, ArmReading, None]:
        """Back out of the rim, straight up, with the object still in the hand."""
        reference = self._travelled()
        step = self._settings.free_speed * CONTROL_PERIOD
        while self._travelled() > target + 0.01:
            reference = max(target, reference - step)
            own = yield Targets(joints=self._servo.step(own, self._below(reference)))
