"""Watching a trial without changing it: a task that remembers what it went through."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from prospect_mj.actions.action import Action, ActionOutcome, PlanOutcome
from prospect_mj.actions.plan import Plan
from prospect_mj.closing import Closing
from prospect_mj.control.controller import Controller
from prospect_mj.episodes.action_trace import ActionTrace, SignalTrace
from prospect_mj.episodes.episode import ActionSpan, Episode, LookTaken, States
from prospect_mj.errors import InvalidValue
from prospect_mj.robot.names import Side
from prospect_mj.robot.torso import Reading
from prospect_mj.sim.simulation import Simulation
from prospect_mj.supervisor.predicates import PredicateState
from prospect_mj.supervisor.supervisor import Supervisor
from prospect_mj.task.pick_place import PickPlaceTask
from prospect_mj.task.presentation import Orientation, Presentation
from prospect_mj.task.trial_state import TrialState
from prospect_mj.vision.look import Look

_STRIDE = 2
"""Control periods from state to state; signals are kept in every one."""


@dataclass(frozen=True, eq=False)
class Moment:
    """A trial between two of its actions, from which it can go on."""

    trial: TrialState
    presentation: Presentation
    look: LookTaken


class WatchedTask(Closing):
    """A live task that remembers the trial under way.

    It does just what the task does: who watches only reads.

    Args:
        task: where everything happens; closed with this one.

    Attributes:
        task: as given.
        supervisor: the task's.
    """

    def __init__(self, task: PickPlaceTask) -> None:
        """Begin to watch."""
        self.task = task
        self.supervisor: Supervisor = task.supervisor
        self._shown: Presentation | None = None
        self._look: LookTaken | None = None
        self._forget()
        task.runner.watcher = self._watch

    @property
    def simulation(self) -> Simulation:
        """The task's."""
        return self.task.simulation

    @property
    def predicates(self) -> PredicateState:
        """The task's."""
        return self.task.predicates

    @property
    def holder(self) -> Side | None:
        """The task's."""
        return self.task.holder

    @property
    def inserted(self) -> bool:
        """The task's."""
        return self.task.inserted

    def reset(self, orientation: Orientation, rng: np.random.Generator) -> Look:
        """Present the jar, and forget the trial before."""
        look = self.task.reset(orientation, rng)
        self._forget()
        self._shown = self.task.presentation
        self._look = LookTaken(
            self.task.images, look.histogram, look.status, look.position, look.axis
        )
        self._keep_state()
        return look

    def execute(self, action: Action) -> ActionOutcome:
        """Run an action, and remember what came of it."""
        start, self._trace = self._now, ActionTrace()
        outcome = self.task.execute(action)
        self._end(action.label, outcome, start)
        return outcome

    def follow(self, plan: Plan, name: str) -> PlanOutcome:
        """Run a plan of one's own, and remember what came of it by a name."""
        start, self._trace = self._now, ActionTrace()
        outcome = self.task.follow(plan)
        self._end(name, outcome, start)
        return outcome

    def _end(
        self, name: str, outcome: ActionOutcome | PlanOutcome, start: float
    ) -> None:
        self._keep_state()
        self._actions.append(self._trace.ended(name, outcome, start, self._now))

    def save(self) -> Moment:
        """The trial as it stands, from which it can go on bit-identically.

        Raises:
            InvalidValue: if none has begun.
        """
        presentation, look = self._begun()
        return Moment(self.task.save(), presentation, look)

    def restore(self, moment: Moment) -> None:
        """Go on from a saved moment of any trial; what is remembered begins there."""
        self.task.restore(moment.trial)
        self._forget()
        self._shown, self._look = moment.presentation, moment.look
        self._keep_state()

    @property
    def look(self) -> LookTaken:
        """What the robot saw before it began.

        Raises:
            InvalidValue: if no trial has begun.
        """
        return self._begun()[1]

    def _begun(self) -> tuple[Presentation, LookTaken]:
        if self._shown is None or self._look is None:
            raise InvalidValue("trial", None, "one that began with a reset")
        return self._shown, self._look

    def episode(self) -> Episode:
        """What happened since the last reset, or since a moment that was restored.

        Raises:
            InvalidValue: if no trial has begun.
        """
        presentation, look = self._begun()
        return Episode(
            scene=self.task.simulation.settings,
            presentation=presentation,
            look=look,
            states=States(np.array(self._times), np.array(self._rows)),
            signals=self._signals.as_arrays(),
            actions=tuple(self._actions),
            inserted=self.inserted,
        )

    def close(self) -> None:
        """Watch no more, and close the task."""
        self.task.runner.watcher = None
        self.task.close()

    @property
    def _now(self) -> float:
        """Simulated time [s]."""
        return float(self.task.simulation.data.time)

    def _forget(self) -> None:
        self._times: list[float] = []
        self._rows: list[np.ndarray] = []
        self._actions: list[ActionSpan] = []
        self._signals, self._trace = SignalTrace(), ActionTrace()
        self._periods = 0

    def _watch(self, controllers: Sequence[Controller], reading: Reading) -> None:
        """One control period, before the physics goes on."""
        if self._periods % _STRIDE == 0:
            self._keep_state()
        self._periods += 1
        self._signals.add(self._now, controllers)
        self._trace.add(self._now, controllers)

    def _keep_state(self) -> None:
        if not self._times or self._now > self._times[-1]:
            self._times.append(self._now)
            self._rows.append(self.task.simulation.save())
