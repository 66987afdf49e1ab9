"""What came of a skill."""

from dataclasses import dataclass, replace
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from prospect_mj.actions.action import ActionResult, ControllerRun
from prospect_mj.checks import check_choice
from prospect_mj.episodes.episode import (
    QUANTITIES,
    ActionSpan,
    ControllerSpan,
    PlannedPath,
    Signals,
)
from prospect_mj.robot.names import SIDES, Side, checked_side
from prospect_mj.skills.sensors import Sensors, Trajectory

_UNTRIED = (ActionResult.NOT_ALLOWED, ActionResult.NOT_SEEN)
"""Results after which nothing has moved."""

_Part = TypeVar("_Part", ControllerSpan, PlannedPath)


@dataclass(frozen=True, eq=False)
class SkillRun:
    """What a skill did; all times are counted from its beginning."""

    name: str
    """Such as `grasp-left`."""
    result: ActionResult
    """How it ended, as the robot itself judges."""
    executed: bool
    """Whether anything was tried: false if it may not or can't run where it is."""
    sim_seconds: float
    """Simulated time that it took [s]."""
    sensors: Sensors
    """What the robot senses at the end."""
    trajectory: Trajectory
    """What it sensed, and what its servos were told, in every control period."""
    signals: Signals
    """What the controllers measured in every control period."""
    controllers: tuple[ControllerSpan, ...]
    """Which controllers ran when, and how each ended, in the order of their start."""
    results: tuple[ControllerRun, ...]
    """What each returned, in the plan's order; that of a grasp or an insertion has
    numbers of its own, see `GraspResult` and `InsertionResult`."""
    paths: tuple[PlannedPath, ...]
    """The ways through joint space that were planned."""

    @property
    def succeeded(self) -> bool:
        """Whether it did what it is named for."""
        return self.result is ActionResult.SUCCESS

    def measured(self, quantity: str, side: Side) -> NDArray[np.float64]:
        """What the controllers of an arm measured in each of m control periods.

        Args:
            quantity: a field of `prospect_mj.control.result.Measured`, such as
                `residual` [1] or `position_error` [m].
            side: the arm.

        Returns:
            (m,), at `signals.times`; NaN where it was nobody's affair.

        Raises:
            InvalidChoice: if there is no such quantity or side.
        """
        check_choice("quantity", quantity, QUANTITIES)
        column = SIDES.index(checked_side(side)), QUANTITIES.index(quantity)
        return self.signals.measured[:, *column].astype(np.float64)


def skill_run(
    span: ActionSpan,
    signals: Signals,
    trajectory: Trajectory,
    sensors: Sensors,
    results: tuple[ControllerRun, ...],
) -> SkillRun:
    """Put together what was noted while a skill ran.

    Args:
        span: its part of the episode.
        signals: of the whole episode.
        trajectory: of the skill.
        sensors: at its end.
        results: of its controllers.
    """
    begin, outcome = span.start, span.outcome
    during = (signals.times >= begin) & (signals.times < span.end)
    own = Signals(signals.times[during] - begin, signals.measured[during])
    return SkillRun(
        name=span.name,
        result=outcome.result,
        executed=outcome.result not in _UNTRIED,
        sim_seconds=outcome.sim_seconds,
        sensors=sensors,
        trajectory=trajectory,
        signals=own,
        controllers=tuple(_since(begin, part) for part in span.controllers),
        results=results,
        paths=tuple(_since(begin, path) for path in span.paths),
    )


def _since(begin: float, part: _Part) -> _Part:
    """The same part with its times counted from `begin` [s]."""
    # Sums of many time steps are not exact to the last digits.
    start, end = np.round([part.start - begin, part.end - begin], 9)
    return replace(part, start=float(start), end=float(end))
