"""The supervisor: which action may run, and which the learner may choose from.

Both are read off the maximally permissive supervisor that `plant.supervision` computes.
What the learner may choose is a matter of mode and schedule; whatever it chooses, an
action that is dangerous or can't start in the present state is not run.
"""

from collections.abc import Sequence
from functools import cache
from typing import Literal, get_args

import numpy as np

from prospect_mj.actions.action import Action
from prospect_mj.checks import check_choice
from prospect_mj.errors import InvalidValue
from prospect_mj.supervisor import effects
from prospect_mj.supervisor.plant import Situation, Start, supervision
from prospect_mj.supervisor.predicates import PredicateState, every_state
from prospect_mj.supervisor.shaping import Schedule

Mode = Literal["none", "safe", "productive"]
MODES: tuple[Mode, ...] = get_args(Mode)


class Supervisor:
    """Decides on actions by the predicates.

    Args:
        mode: `none`: the learner may choose all six; `safe`: not those that can lead to
            a forbidden state; `productive`: nor those that can change no predicate,
            unless there is no other.
        shaping: actions that the learner may not choose in the first trials, such as
            `swap-left-to-right:200`.

    Raises:
        InvalidChoice: on a mode or an action that does not exist.
        InvalidValue: if the schedule can't be read, or leaves nothing to choose in a
            state that can be reached under it.
    """

    def __init__(self, mode: Mode = "none", shaping: Sequence[str] = ()) -> None:
        """Supervise in a mode."""
        check_choice("supervisor mode", mode, MODES)
        self.mode: Mode = mode
        self.schedule = Schedule.parse(shaping)
        if self.schedule.entries:
            _check(mode, self.schedule)

    def may_run(self, action: Action, state: PredicateState) -> bool:
        """Whether an action is run when it is chosen; the same in all modes."""
        return _is_enabled(action, state) and effects.can_start(action, state)

    def choice_set(self, state: PredicateState, trial: int = 0) -> np.ndarray:
        """The learner's choice set as a mask (6,) int8, 1 = may be chosen.

        Args:
            state: the present predicates.
            trial: number of the trial, from 0, for the schedule.

        Raises:
            InvalidValue: if the state is one that supervision never lets happen.
        """
        if Situation(state) not in supervision().kept:
            raise InvalidValue("state", str(state), "one that supervision allows")
        offered = _offered(self.mode, self.schedule, state, trial)
        return np.array([action in offered for action in Action], dtype=np.int8)


@cache
def _is_enabled(action: Action, state: PredicateState) -> bool:
    """Whether the maximally permissive supervisor lets an action start."""
    kept, running = supervision().kept, Situation(state, action)
    return Situation(state) in kept and running in kept


@cache
def _choices(mode: Mode, state: PredicateState) -> frozenset[Action]:
    """What a mode offers in a state, the schedule aside; never nothing."""
    if mode == "none":
        return frozenset(Action)
    safe = frozenset(action for action in Action if _is_enabled(action, state))
    if mode == "safe":
        return safe
    useful = frozenset(action for action in safe if effects.can_change(action, state))
    # Where the jar is lost nothing is of use, and yet the trial goes on to its end.
    return useful or safe


def _offered(
    mode: Mode, schedule: Schedule, state: PredicateState, trial: int
) -> frozenset[Action]:
    choices = _choices(mode, state)
    return frozenset(a for a in choices if not schedule.disables(a, trial))


def _check(mode: Mode, schedule: Schedule) -> None:
    """Refuse a schedule that leaves nothing to choose somewhere, at some time."""
    for trial in schedule.phases:
        for state in _reachable(mode, schedule, trial):
            if not _offered(mode, schedule, state, trial):
                named = " ".join(f"{a.label}:{n}" for a, n in schedule.entries)
                expected = (
                    f"a schedule that leaves something to choose in mode {mode} "
                    f"when {state} (trial {trial})"
                )
                raise InvalidValue("shaping", named, expected)


def _reachable(mode: Mode, schedule: Schedule, trial: int) -> list[PredicateState]:
    """States between actions that the choices of a trial can lead to."""

    def is_closed(situation: Situation, event: object) -> bool:
        offered = _offered(mode, schedule, situation.predicates, trial)
        return isinstance(event, Start) and event.action not in offered

    open_to_choice = supervision().automaton.without(is_closed)
    reached = open_to_choice.reachable()
    return [state for state in every_state() if Situation(state) in reached]
