"""What every learner can do; who trains, evaluates or saves one needs no more of it."""

from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from prospect_mj.agent.choice import Choice
from prospect_mj.agent.observation import Observation, Transition
from prospect_mj.agent.settings import AnyLearnerSettings


class Learner(Protocol):
    """Values of the actions in a state, learned from single transitions.

    Two generators drive it, so that what it draws to learn never shifts its choices:
    one for choices, of which each takes two numbers, and one for learning, of which
    every learner takes as many as it needs; the linear one takes none.

    Attributes:
        settings: the learner's parameters, whose class tells which learner it is.
        n_updates: transitions learned from so far; those learned from again don't
            count.
    """

    settings: AnyLearnerSettings
    n_updates: int

    def q_values(self, observation: Observation) -> NDArray[np.float64]:
        """Estimate the value of every action in a state: (n_actions,) [actions]."""
        ...

    def select(
        self,
        observation: Observation,
        rng: np.random.Generator,
        allowed: ArrayLike | None = None,
    ) -> Choice:
        """Choose an action epsilon-greedily and tell how.

        Args:
            observation: of the state.
            rng: for choices; exactly two numbers are drawn (`choice.epsilon_greedy`).
            allowed: (n_actions,) true where an action may be chosen; None allows all.
        """
        ...

    def update(self, transition: Transition, rng: np.random.Generator) -> float:
        """Learn from a transition, in place.

        Args:
            transition: what has just happened.
            rng: for learning.

        Returns:
            Its temporal-difference error, before anything was learned [actions].
        """
        ...

    def state(self) -> dict[str, NDArray]:
        """All that it has learned, as arrays by name; none of them is shared."""
        ...

    def restore(self, state: dict[str, NDArray]) -> None:
        """Take over what `state` gave; learning goes on from there bit for bit.

        Raises:
            ProspectError: if it is of another learner, or not of finite numbers.
        """
        ...
