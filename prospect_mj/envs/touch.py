"""The category of the grasp that holds the jar, as a trial goes on."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from prospect_mj.actions.action import ActionOutcome, ActionResult
from prospect_mj.haptics import CategoryRecogniser, TrajectoryModels
from prospect_mj.recording.trial import RecordedTrial

if TYPE_CHECKING:
    from prospect_mj.envs.tasks import Task

NO_CATEGORY = -1
"""Told where no hand holds the jar, or there are no models."""


class Touch:
    """Recognises each grasp that takes hold, and remembers what it was.

    Args:
        models: the categories; None: there are none.

    Attributes:
        category: of the latest grasp that took hold, from 0; 0 before the first.
    """

    def __init__(self, models: TrajectoryModels | None) -> None:
        """Nothing was felt yet."""
        self._models = models
        self._known: dict[bytes, int] = {}
        self.category = 0

    def begin(self) -> None:
        """Forget the trial before."""
        self.category = 0

    def feel(self, task: "Task", outcome: ActionOutcome) -> None:
        """Take in what an action has felt like, if it took the jar.

        Args:
            task: on which it was run last.
            outcome: what it did.
        """
        if self._models is None or outcome.result != ActionResult.SUCCESS:
            return
        felt = _felt(task, outcome)
        if len(felt):
            self.category = self._recognised(felt, self._models)

    def told(self, holding: str) -> int:
        """The category as the agent is told it; `holding` is the hand, or "none"."""
        unknown = self._models is None or holding == "none"
        return NO_CATEGORY if unknown else self.category

    def _recognised(self, felt: NDArray[np.float32], models: TrajectoryModels) -> int:
        """The category of a grasp (m, 2), taken in sample by sample."""
        # A recording has the same grasps again and again.
        name = felt.tobytes()
        if name not in self._known:
            recogniser = CategoryRecogniser(models)
            for seconds, residual in felt.tolist():
                recogniser.feel(seconds, residual)
            self._known[name] = recogniser.category
        return self._known[name]


def _felt(task: "Task", outcome: ActionOutcome) -> NDArray[np.float32]:
    """What the action that was run last felt like (m, 2)."""
    if isinstance(task, RecordedTrial):
        return task.felt
    # Only here: where nothing is simulated, nothing of MuJoCo is loaded.
    from prospect_mj.recording.last_grasp import last_grasp

    return last_grasp(outcome)
