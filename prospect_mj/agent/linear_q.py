"""Q-learning with one linear function per action, as in the paper.

Wheeler, Fagg & Grupen (ICDL 2002), section 3.1: Q(phi, a) = theta_a . phi with
epsilon-greedy exploration and the semi-gradient update

    theta_a <- theta_a + alpha [r + gamma max_a' theta_a' . phi' - theta_a . phi] phi .
"""

from pathlib import Path
from typing import NamedTuple, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from prospect_mj.agent import weights_file
from prospect_mj.agent.settings import LearnerSettings
from prospect_mj.checks import check_integer
from prospect_mj.errors import InvalidValue


class Choice(NamedTuple):
    """An action and how it came to be chosen."""

    action: int
    """Index in [0, n_actions)."""
    explored: bool
    """True if the epsilon draw asked for a random action."""
    q_values: NDArray[np.float64]
    """(n_actions,) [actions], the estimates at the time of the choice."""


class LinearQ:
    """A linear action-value function that learns from single transitions.

    Attributes:
        settings: the learner's parameters.
        weights: theta, (n_actions, n_features).
        n_updates: transitions learned from so far.
        origin: what the weights were learned in; saved and loaded, never interpreted.
    """

    def __init__(
        self,
        settings: LearnerSettings | None = None,
        origin: str = "",
        rng: np.random.Generator | None = None,
    ) -> None:
        """Start without experience.

        Args:
            settings: parameters.
            origin: what the weights will be learned in.
            rng: draws the initial weights; None: they are zero, whatever their
                deviation in `settings`.
        """
        self.origin = origin
        self.settings = LearnerSettings() if settings is None else settings
        shape = self.settings.n_actions, self.settings.n_features
        self.weights = np.zeros(shape)
        if rng is not None:
            self.weights += rng.normal(0.0, self.settings.initial_sd, shape)
        self.n_updates = 0

    def q_values(self, features: ArrayLike) -> NDArray[np.float64]:
        """Estimate the value of every action.

        Args:
            features: phi, (n_features,).

        Returns:
            theta phi, (n_actions,).
        """
        return self._q_values(self._checked_features(features))

    def select(
        self,
        features: ArrayLike,
        rng: np.random.Generator,
        allowed: ArrayLike | None = None,
    ) -> int:
        """Choose an action epsilon-greedily; see `choose`."""
        return self.choose(features, rng, allowed).action

    def choose(
        self,
        features: ArrayLike,
        rng: np.random.Generator,
        allowed: ArrayLike | None = None,
    ) -> Choice:
        """Choose an action epsilon-greedily and tell how.

        Exactly two numbers u1, u2 are drawn by `rng.random()`, in this order. The
        candidates are the allowed actions if u1 < epsilon, else those of them with the
        largest value; the action is number floor(u2 n) of the n candidates in
        ascending order. So ties are broken at random, and an implementation given the
        same numbers makes the same choices.

        Args:
            features: phi, (n_features,).
            rng: source of the two numbers.
            allowed: (n_actions,) true where an action may be chosen; None allows all.
        """
        q_values = self.q_values(features)
        candidates = self._allowed_actions(allowed)
        explore_draw, candidate_draw = rng.random(), rng.random()
        explored = explore_draw < self.settings.epsilon
        if not explored:
            values = q_values[candidates]
            candidates = candidates[values == values.max()]
        action = int(candidates[int(candidate_draw * len(candidates))])
        return Choice(action, explored, q_values)

    def update(
        self,
        features: ArrayLike,
        action: int,
        reward: float,
        next_features: ArrayLike,
        terminated: bool,
        allowed: ArrayLike | None = None,
    ) -> float:
        """Learn from one transition by the paper's update (section 3.1).

        Args:
            features: phi, (n_features,), of the state that was left.
            action: the action taken there.
            reward: r [actions].
            next_features: phi', (n_features,), of the state that was reached.
            terminated: whether that state ends the task: its value is then zero.
            allowed: (n_actions,) true where an action may be chosen in the state that
                was reached; the maximum is over these. None allows all.

        Returns:
            The temporal-difference error, the bracket of the update.
        """
        phi = self._checked_features(features)
        self._check_action(action)
        target = float(reward)
        if not terminated:
            next_values = self.q_values(next_features)[self._allowed_actions(allowed)]
            target += self.settings.discount * float(next_values.max())
        error = target - float(self._q_values(phi)[action])
        if not np.isfinite(error):
            raise InvalidValue(
                "temporal-difference error",
                error,
                "a finite number (step size x |features|^2 must stay below 2)",
            )
        self.weights[action] += self.settings.step_size * error * phi
        self.n_updates += 1
        return error

    def save(self, path: str | Path) -> None:
        """Write all that the learner remembers to `path`, all or nothing.

        Raises:
            InvalidValue: if `path` is a folder or in none that exists.
        """
        stored = weights_file.StoredWeights(
            self.settings, self.weights, self.n_updates, self.origin
        )
        weights_file.write(Path(path), stored)

    @classmethod
    def load(cls, path: str | Path) -> Self:
        """Read what `save` wrote; learning continues bit for bit.

        Raises:
            InvalidValue: if `path` cannot be read or is not such a file.
        """
        stored = weights_file.read(Path(path))
        learner = cls(stored.settings, stored.origin)
        learner.weights[:] = stored.weights
        learner.n_updates = stored.n_updates
        return learner

    def _q_values(self, phi: NDArray[np.float64]) -> NDArray[np.float64]:
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

    def _check_action(self, action: int) -> None:
        # A negative index would silently count from the end.
        plain = int(action) if isinstance(action, np.integer) else action
        check_integer("action", plain, 0, self.settings.n_actions - 1)

    def _allowed_actions(self, allowed: ArrayLike | None) -> NDArray[np.intp]:
        """Indices of the allowed actions, ascending."""
        if allowed is None:
            return np.arange(self.settings.n_actions)
        mask = np.asarray(allowed)
        if mask.shape != (self.settings.n_actions,):
            raise InvalidValue(
                "action mask shape", mask.shape, f"({self.settings.n_actions},)"
            )
        actions = np.flatnonzero(mask)
        if actions.size == 0:
            raise InvalidValue("action mask", mask.tolist(), "one action allowed")
        return actions
