"""What is noted while an action runs."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from prospect_mj.actions.action import ActionOutcome, PlanOutcome
from prospect_mj.control.controller import CONTROL_PERIOD, Controller
from prospect_mj.episodes.episode import (
    QUANTITIES,
    ActionSpan,
    ControllerSpan,
    PlannedPath,
    Signals,
)
from prospect_mj.robot.names import SIDES


class SignalTrace:
    """What controllers measure, a row for each control period."""

    def __init__(self) -> None:
        """Begin with none."""
        self._times: list[float] = []
        self._measured: list[np.ndarray] = []

    def add(self, now: float, controllers: Sequence[Controller]) -> None:
        """Note what those that are running have measured."""
        row = np.full((len(SIDES), len(QUANTITIES)), np.nan, np.float32)
        for controller in controllers:
            values = [getattr(controller.measured, name) for name in QUANTITIES]
            row[SIDES.index(controller.side)] = [
                np.nan if value is None else value for value in values
            ]
        self._times.append(now)
        self._measured.append(row)

    def as_arrays(self) -> Signals:
        """All rows."""
        shape = len(self._times), len(SIDES), len(QUANTITIES)
        measured = np.array(self._measured, np.float32).reshape(shape)
        return Signals(np.array(self._times, np.float64), measured)


class ActionTrace:
    """The controllers and planned paths of one action."""

    def __init__(self) -> None:
        """Begin with none."""
        # Kept by identity, and the objects with it: no other one gets its number.
        self._spans: dict[int, tuple[Controller, float, float]] = {}
        self._paths: dict[int, tuple[Controller, np.ndarray, float, float]] = {}

    def add(self, now: float, controllers: Sequence[Controller]) -> None:
        """Note which controllers run, and what they follow."""
        end = now + CONTROL_PERIOD
        for controller in controllers:
            _, start, _ = self._spans.get(id(controller), (controller, now, end))
            self._spans[id(controller)] = controller, start, end
            if (path := controller.planned_path) is not None:
                _, _, start, _ = self._paths.get(id(path), (controller, path, now, end))
                self._paths[id(path)] = controller, path, start, end

    def ended(
        self,
        name: str,
        outcome: ActionOutcome | PlanOutcome,
        start: float,
        end: float,
    ) -> ActionSpan:
        """The action as a whole.

        Args:
            name: the action's label, or the plan's name.
            outcome: what it did.
            start: when it began [s].
            end: when it had ended [s].
        """
        controllers = tuple(
            ControllerSpan(
                type(controller).__name__,
                controller.side,
                first,
                last,
                controller.result.status,
                controller.result.reason,
            )
            for controller, first, last in self._spans.values()
        )
        paths = tuple(
            PlannedPath(controller.side, first, last, path.astype(np.float32))
            for controller, path, first, last in self._paths.values()
        )
        # What ran is told by the spans.
        told = replace(outcome, runs=())
        return ActionSpan(name, told, start, end, controllers, paths)
