"""The rule for failed actions: whether one that had no effect may be run again.

Under "suppressed" an action that left the haptic state as it was, and did not insert
the jar, is neither chosen in that holding state for the rest of the trial, nor counts
in the maximum of a target. Where nothing would remain to be chosen, the rule is lifted
for that choice. It is the trial's, not the learner's, and the same for all of them.
"""

from typing import Literal, get_args

import numpy as np
from numpy.typing import ArrayLike, NDArray

from prospect_mj.agent.haptics import N_HOLDINGS
from prospect_mj.checks import check_choice

FailedActions = Literal["allowed", "suppressed"]
RULES: tuple[FailedActions, ...] = get_args(FailedActions)


class FailedActionRule:
    """What has failed in a trial.

    Args:
        rule: whether it may be run again.
        n_actions: number of actions.
    """

    def __init__(self, rule: FailedActions, n_actions: int = 6) -> None:
        """Begin a trial, in which nothing has failed."""
        check_choice("rule for failed actions", rule, RULES)
        self._suppresses = rule == "suppressed"
        self._failed = np.zeros((N_HOLDINGS, n_actions), bool)

    def note(
        self, holding: int, action: int, next_holding: int, inserted: bool
    ) -> None:
        """Take in what an action has led to.

        Args:
            holding: before it, 0 none, 1 left, 2 right (`haptics.holding_of`).
            action: what was tried, run or not.
            next_holding: after it.
            inserted: whether the jar stands in the receptacle.
        """
        if self._suppresses and holding == next_holding and not inserted:
            self._failed[holding, action] = True

    def remaining(self, holding: int, allowed: ArrayLike) -> NDArray[np.bool_]:
        """What may be chosen.

        Args:
            holding: at present, 0 none, 1 left, 2 right.
            allowed: (n_actions,) true where the supervisor allows an action.

        Returns:
            (n_actions,), a new array: `allowed` without what has failed in this
            holding state, or all of it where nothing would remain.
        """
        mask = np.array(allowed, bool)
        remaining = mask & ~self._failed[holding]
        return remaining if remaining.any() else mask
