"""Q-learning with one linear function per action, as in the paper.

Wheeler, Fagg & Grupen (ICDL 2002), section 3.1: Q(phi, a) = theta_a . phi with
epsilon-greedy exploration and the semi-gradient update

    theta_a <- theta_a + alpha [r + gamma max_a' theta_a' . phi' - theta_a . phi] phi .
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from prospect_mj.agent import state_arrays
from prospect_mj.agent.choice import (
    Choice,
    allowed_actions,
    checked_action,
    epsilon_greedy,
)
from prospect_mj.agent.experience import Step
from prospect_mj.agent.observation import Observation, Transition
from prospect_mj.agent.settings import LinearSettings, ReplaySettings
from prospect_mj.errors import InvalidValue

_STABLE = "(step size x |features|^2 must stay below 2)"


class LinearQ:
    """A linear action-value function that learns from single transitions.

    Attributes:
        settings: the learner's parameters.
        weights: theta, (n_actions, n_features).
        n_updates: transitions learned from so far.
    """

    def __init__(
        self,
        settings: LinearSettings | ReplaySettings | None = None,
        rng: np.random.Generator | None = None,
    ) -> None:
        """Start without experience.

        Args:
            settings: parameters.
            rng: draws the initial weights; None: they are zero, whatever their
                deviation in `settings`.
        """
        self.settings = LinearSettings() if settings is None else settings
        shape = self.settings.n_actions, self.settings.n_features
        self.weights = np.zeros(shape)
        if rng is not None:
            self.weights += rng.normal(0.0, self.settings.initial_sd, shape)
        self.n_updates = 0

    def q_values(self, observation: Observation) -> NDArray[np.float64]:
        """Estimate the value of every action: theta phi, (n_actions,) [actions]."""
        return self._values(self._checked_features(observation.features))

    def select(
        self,
        observation: Observation,
        rng: np.random.Generator,
        allowed: ArrayLike | None = None,
    ) -> Choice:
        """Choose an action epsilon-greedily; see `choice.epsilon_greedy`."""
        values = self.q_values(observation)
        return epsilon_greedy(values, self.settings.epsilon, rng, allowed)

    def update(self, transition: Transition, rng: np.random.Generator) -> float:
        """Learn from one transition by the paper's update (section 3.1).

        Args:
            transition: what has just happened.
            rng: for learning; nothing is drawn from it.

        Returns:
            The temporal-difference error, the bracket of the update.
        """
        error = self._learn(self._step(transition))
        self.n_updates += 1
        return error

    def state(self) -> dict[str, NDArray]:
        """Weights and number of updates."""
        return {"weights": self.weights.copy(), "n_updates": np.array(self.n_updates)}

    def restore(self, state: dict[str, NDArray]) -> None:
        """Take over what `state` gave.

        Raises:
            ProspectError: if it is of another learner, or not of finite numbers.
        """
        state_arrays.check(state, LinearQ.state(self))
        self.weights[:] = state["weights"]
        self.n_updates = int(state["n_updates"])
        state_arrays.check_count("number of updates", self.n_updates)

    def _step(self, transition: Transition) -> Step:
        """The checked numbers of a transition."""
        phi = self._checked_features(transition.observation.features)
        action = checked_action(transition.action, self.settings.n_actions)
        follows = self._checked_features(transition.next_observation.features)
        if not transition.terminated:
            allowed_actions(transition.allowed, self.settings.n_actions)
        return Step(
            phi,
            action,
            float(transition.reward),
            follows,
            bool(transition.terminated),
            np.asarray(transition.allowed, bool),
        )

    def _learn(self, step: Step) -> float:
        """Move an action's weights; give the error before."""
        target = step.reward
        if not step.terminated:
            follows = self._values(step.next_state)[step.allowed]
            target += self.settings.discount * float(follows.max())
        error = target - float(self._values(step.state)[step.action])
        if not np.isfinite(error):
            expected = f"a finite number {_STABLE}"
            raise InvalidValue("temporal-difference error", error, expected)
        weights = self.weights[step.action]
        weights += self.settings.step_size * error * step.state
        # The error was a number; what it is multiplied by can make it none.
        if not np.isfinite(weights).all():
            size, expected = float(np.abs(weights).max()), f"finite numbers {_STABLE}"
            raise InvalidValue("largest of the learned weights", size, expected)
        return error

    def _values(self, phi: NDArray[np.float64]) -> NDArray[np.float64]:
        # Not `@`: its order of summation, hence its last bit, depends on the BLAS
        # library and the processor.
        return np.sum(self.weights * phi, axis=1)

    def _checked_features(self, features: ArrayLike) -> NDArray[np.float64]:
        phi = np.asarray(features, dtype=np.float64)
        if phi.shape != (self.settings.n_features,):
            raise InvalidValue(
                "feature vector shape", phi.shape, f"({self.settings.n_features},)"
            )
        if not np.isfinite(phi).all():
            raise InvalidValue("feature vector", "NaN or infinite", "finite numbers")
        return phi
