"""The supervisor: lets an action run only in the predicate states that it is made for.

The state is that of the two grasp predicates. What the learner may choose (its choice
set) is a matter of the mode; whatever it chooses, an action that may not run is not
run.
"""

from dataclasses import dataclass
from typing import Literal, get_args

import numpy as np

from prospect_mj.actions.action import Action
from prospect_mj.errors import InvalidChoice
from prospect_mj.robot.names import Side

Mode = Literal["none", "safe", "productive"]
MODES: tuple[Mode, ...] = get_args(Mode)


@dataclass(frozen=True)
class Precondition:
    """Grasp predicates that an action needs."""

    holder: Side | None
    """The one hand that must hold the jar; None = both hands empty."""


PRECONDITIONS: dict[Action, Precondition] = {
    Action.GRASP_LEFT: Precondition(None),
    Action.GRASP_RIGHT: Precondition(None),
    Action.SWAP_LEFT_TO_RIGHT: Precondition("left"),
    Action.SWAP_RIGHT_TO_LEFT: Precondition("right"),
    Action.INSERT_LEFT: Precondition("left"),
    Action.INSERT_RIGHT: Precondition("right"),
}

DANGEROUS_WHILE_HOLDING = (Action.GRASP_LEFT, Action.GRASP_RIGHT)
"""Both hands would pull at one jar, or a hand would open over it."""


class Supervisor:
    """Decides on actions by the grasp predicates.

    Args:
        mode: `none`: the learner may choose all six; `safe`: not the dangerous ones;
            `productive`: only those that can run.

    Raises:
        InvalidChoice: if the mode is none of these.
    """

    def __init__(self, mode: Mode = "none") -> None:
        """Supervise in a mode."""
        if mode not in MODES:
            raise InvalidChoice("supervisor mode", mode, MODES)
        self.mode: Mode = mode

    def may_run(self, action: Action, holder: Side | None) -> bool:
        """Whether an action runs while `holder` has the jar; the same in all modes."""
        return PRECONDITIONS[action].holder == holder

    def choice_set(self, holder: Side | None) -> np.ndarray:
        """The learner's choice set as a mask (6,) int8, 1 = may be chosen."""
        allowed = [self._may_choose(action, holder) for action in Action]
        return np.array(allowed, dtype=np.int8)

    def _may_choose(self, action: Action, holder: Side | None) -> bool:
        if self.mode == "none":
            return True
        if self.mode == "productive":
            return self.may_run(action, holder)
        return holder is None or action not in DANGEROUS_WHILE_HOLDING
