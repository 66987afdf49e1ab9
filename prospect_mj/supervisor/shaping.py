"""Shaping: named actions are not offered to the learner in the first trials.

Wheeler, Fagg and Grupen (2002), section 3.1: "temporarily disabling selected actions to
reduce the initial exploration space". The schedule is lifted action by action; trials
are counted from 0.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Self

from prospect_mj.actions.action import Action
from prospect_mj.checks import check_choice
from prospect_mj.errors import InvalidValue

_ACTIONS = {action.label: action for action in Action}


@dataclass(frozen=True)
class Schedule:
    """For how many trials which actions are disabled."""

    entries: tuple[tuple[Action, int], ...] = ()
    """Each action once, with the number of its first trials without it."""

    @classmethod
    def parse(cls, texts: Sequence[str]) -> Self:
        """Read entries such as `swap-left-to-right:200`.

        Raises:
            InvalidChoice: on an action that does not exist.
            InvalidValue: on an entry of another form, a number of trials that is none,
                or an action named twice.
        """
        entries = tuple(map(_entry, texts))
        actions = [action for action, _ in entries]
        for action in actions:
            if actions.count(action) > 1:
                raise InvalidValue("shaping", " ".join(texts), "each action once")
        return cls(entries)

    def disables(self, action: Action, trial: int) -> bool:
        """Whether an action is not offered in a trial."""
        return any(named == action and trial < n for named, n in self.entries)

    @property
    def phases(self) -> tuple[int, ...]:
        """The first trial of every phase in which the same actions are disabled."""
        return tuple(sorted({0, *(n for _, n in self.entries)}))


def _entry(text: str) -> tuple[Action, int]:
    form = "<action>:<trials>, such as swap-left-to-right:200"
    if not isinstance(text, str) or text.count(":") != 1:
        raise InvalidValue("shaping", text, form)
    name, number = text.split(":")
    check_choice("action in shaping", name, _ACTIONS)
    if not (number.isascii() and number.isdigit()):
        raise InvalidValue(f"trials of {name} in shaping", number, "0 or more")
    return _ACTIONS[name], int(number)
