"""Exact models that a search can run actions in: a recording, or live physics itself.

`PickPlaceTask.save` and `restore` make live physics a model of itself: an action that
is run from a restored state does bit by bit what it would have done.
"""

from collections.abc import Callable
from functools import wraps
from typing import Any, NamedTuple, Protocol

import numpy as np

from prospect_mj.actions.action import Action
from prospect_mj.recording.grower import presentation_rng
from prospect_mj.recording.hands import NUMBERS, hand_of
from prospect_mj.recording.recording import Recording
from prospect_mj.supervisor.predicates import PredicateState
from prospect_mj.supervisor.supervisor import Supervisor
from prospect_mj.task.pick_place import PickPlaceTask
from prospect_mj.task.trial_state import TrialState

_USEFUL = Supervisor("productive")


class Ran(NamedTuple):
    """What an action led to."""

    state: object
    """Where the search may go on; of the simulator's own kind."""
    inserted: bool
    sim_seconds: float
    """Simulated time of it [s]."""


class Simulator(Protocol):
    """A model in which any action can be run from any state that it gave."""

    def open_actions(self, state: object) -> tuple[Action, ...]:
        """What could change anything, by number (mode `productive`)."""
        ...

    def run(self, state: object, action: Action) -> Ran:
        """Run an action to its end."""
        ...


class RecordedSimulator:
    """What was recorded; a state is the number of a node.

    Args:
        recording: the outcomes.
    """

    def __init__(self, recording: Recording) -> None:
        """Keep it."""
        self._recording = recording

    def open_actions(self, state: int) -> tuple[Action, ...]:
        """What could change anything, by number."""
        number = self._recording.nodes.predicates[state]
        return useful(self._recording.predicates.states[number])

    def run(self, state: int, action: Action) -> Ran:
        """Look up what the action led to."""
        nodes = self._recording.nodes
        led_to = nodes.child[state, action]
        inserted, seconds = bool(nodes.inserted[led_to]), nodes.sim_seconds[led_to]
        return Ran(int(nodes.situation[led_to]), inserted, float(seconds))


class LiveSimulator:
    """Live physics; a state is that of the trial.

    Args:
        task: the physics.

    Attributes:
        motion_plans: large movements that were planned.
        ik_solutions: inverse kinematics that were solved.
    """

    def __init__(self, task: PickPlaceTask) -> None:
        """Count from now on."""
        self._task = task
        self.motion_plans, self.ik_solutions = 0, 0
        for arm in task.runner.arms.values():
            self._counted(arm.ik, "ik_solutions", ("solve", "solve_posture"))
            if arm.planner is not None:
                self._counted(arm.planner, "motion_plans", ("plan", "resume"))

    def present(self, recording: Recording, number: int) -> TrialState:
        """Present the jar as it was recorded, look at it, and forget what was counted.

        Args:
            recording: of a world that may differ from this one.
            number: of its presentation.
        """
        shown, config = recording.presentations, recording.key.config
        orientation = hand_of(int(shown.lid[number]))
        rng = presentation_rng(config, orientation, int(shown.number[number]))
        self._task.reset(orientation, rng)
        self.motion_plans, self.ik_solutions = 0, 0
        return self._task.save()

    def open_actions(self, state: TrialState) -> tuple[Action, ...]:
        """What could change anything, by number."""
        return useful(state.predicates)

    def run(self, state: TrialState, action: Action) -> Ran:
        """Simulate the action from a state."""
        self._task.restore(state)
        outcome = self._task.execute(action)
        return Ran(self._task.save(), self._task.inserted, outcome.sim_seconds)

    def _counted(self, owner: object, counter: str, names: tuple[str, ...]) -> None:
        """Count every call of some methods."""
        for name in names:
            setattr(owner, name, self._counting(getattr(owner, name), counter))

    def _counting(self, method: Callable[..., Any], counter: str) -> Callable[..., Any]:
        @wraps(method)
        def counted(*args: object, **kwargs: object) -> object:
            setattr(self, counter, getattr(self, counter) + 1)
            return method(*args, **kwargs)

        return counted


def useful(predicates: PredicateState) -> tuple[Action, ...]:
    """What the supervisor lets run and could change anything, by number."""
    offered = _USEFUL.choice_set(predicates)
    return tuple(action for action in Action if offered[action])


def first_presentations(recording: Recording, most: int) -> list[int]:
    """Numbers of the first presentations of each orientation."""
    lids = recording.presentations.lid
    of_side = [np.flatnonzero(lids == lid)[:most] for lid in NUMBERS.values()]
    return [int(number) for number in np.concatenate(of_side)]
