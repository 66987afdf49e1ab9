"""The paper's linear learner, which goes through its latest experience again.

After the update of an action follow the same updates for transitions drawn from those
remembered, each with the target that it has by the weights of that moment.
"""

import numpy as np
from numpy.typing import NDArray

from prospect_mj.agent.experience import Experience, is_experience
from prospect_mj.agent.linear_q import LinearQ
from prospect_mj.agent.observation import Transition
from prospect_mj.agent.settings import ReplaySettings


class ReplayQ(LinearQ):
    """A linear action-value function with replayed experience.

    Attributes:
        settings: the learner's parameters.
        weights: theta, (n_actions, n_features).
        n_updates: transitions learned from so far, those replayed not counted.
    """

    def __init__(
        self,
        settings: ReplaySettings | None = None,
        rng: np.random.Generator | None = None,
    ) -> None:
        """Start without experience; see `LinearQ`."""
        known = ReplaySettings() if settings is None else settings
        super().__init__(known, rng)
        self.settings: ReplaySettings = known
        self._experience = Experience(
            known.buffer,
            known.n_features,
            known.n_actions,
            np.float64,
            known.replays_forget,
        )

    def update(self, transition: Transition, rng: np.random.Generator) -> float:
        """Learn from one transition, then from remembered ones, this one among them.

        Args:
            transition: what has just happened.
            rng: draws what is replayed.

        Returns:
            The temporal-difference error of `transition` before.
        """
        error = super().update(transition, rng)
        self._experience.add(self._step(transition))
        self._experience.replay(self.settings.replays, rng, self._learn)
        return error

    def state(self) -> dict[str, NDArray]:
        """Weights, number of updates and experience."""
        return {**super().state(), **self._experience.arrays()}

    def restore(self, state: dict[str, NDArray]) -> None:
        """Take over what `state` gave.

        Raises:
            ProspectError: if it is of another learner, or not of finite numbers.
        """
        super().restore({n: a for n, a in state.items() if not is_experience(n)})
        self._experience.restore({n: a for n, a in state.items() if is_experience(n)})
