"""Predicates of the supervisor, observed from the robot's own sensing."""

from dataclasses import dataclass

import numpy as np

from prospect_mj.actions.belief import Belief
from prospect_mj.actions.workspace import Workspace
from prospect_mj.control.kinematics import KinematicTwin
from prospect_mj.robot import posture
from prospect_mj.robot.names import SIDES, Side
from prospect_mj.robot.torso import Reading
from prospect_mj.supervisor.predicates import ArmState, Jar, Place, PredicateState


@dataclass(frozen=True)
class SensorSettings:
    """When a predicate of an arm is true."""

    rest_joints: float = 0.05
    """Largest error of a joint at rest [rad]: the motion's tolerance, and the sag of a
    servo that holds still."""
    rest_fingers: float = 0.10
    """Largest error of an open finger [rad]; round the jar it is closed by more."""


class PredicateSensor:
    """Tells the predicates from encoders and belief.

    Args:
        twin: where the hands are, by the encoders.
        workspace: the places of the task.
        settings: tolerances.
    """

    def __init__(
        self,
        twin: KinematicTwin,
        workspace: Workspace,
        settings: SensorSettings | None = None,
    ) -> None:
        """Keep what the predicates are told from."""
        self._twin = twin
        self._settings = SensorSettings() if settings is None else settings
        self._front = np.array(workspace.presentation)
        # A hand that grips there is `reach` away, one that has backed out more than
        # `stand_off` further.
        self._radius = workspace.reach + workspace.stand_off / 2

    def observe(self, reading: Reading, belief: Belief) -> PredicateState:
        """The predicates between two actions.

        Args:
            reading: of both arms.
            belief: what the robot knows of the jar.
        """
        self._twin.update(reading)
        left, right = (self._arm(side, reading, belief) for side in SIDES)
        return PredicateState(left, right, _jar(belief))

    def _arm(self, side: Side, reading: Reading, belief: Belief) -> ArmState:
        return ArmState(side in belief.held, self._place(side, reading))

    def _place(self, side: Side, reading: Reading) -> Place:
        own, settings = reading[side], self._settings
        away = np.abs(own.joints - posture.home(side)).max()
        closed = np.abs(own.fingers - posture.OPEN).max()
        if away < settings.rest_joints and closed < settings.rest_fingers:
            return Place.REST
        hand = self._twin.grasp_pose(side).translation()
        in_front = float(np.linalg.norm(hand - self._front)) < self._radius
        return Place.FRONT if in_front else Place.ASTRAY


def _jar(belief: Belief) -> Jar:
    if belief.seen is not None:
        return Jar.SEEN
    return Jar.UNKNOWN if belief.inserted is None else Jar.INSERTED
