"""Q-learning that discovers features as it needs them, after Piater and Grupen.

A context, which is a haptic state and an action, has one value to begin with, whatever
the picture. When what comes out of it is a surprise, a feature of the picture is sought
that tells the examples that came out better than its mean from those that came out
worse; if there is one, the context splits, and the values of its leaves are estimated
from remembered examples. The values are learned by Q-learning (Watkins 1989), the
features as in Piater and Grupen (ICML 2000); docs/learners.md has the whole of it.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from prospect_mj.agent import state_arrays
from prospect_mj.agent.choice import Choice, allowed_actions, epsilon_greedy
from prospect_mj.agent.discovery import saved
from prospect_mj.agent.discovery.contexts import Contexts
from prospect_mj.agent.discovery.discoverer import Discoverer, Visit
from prospect_mj.agent.discovery.examples import NOT_READ, Example, Examples
from prospect_mj.agent.discovery.feature import cumulative
from prospect_mj.agent.discovery.forced import forced_after
from prospect_mj.agent.discovery.values import Values
from prospect_mj.agent.features import N_BINS
from prospect_mj.agent.observation import Observation, Transition
from prospect_mj.agent.settings import DiscoverySettings
from prospect_mj.checks import check_integer
from prospect_mj.errors import InvalidValue


class DiscoveryQ:
    """An action-value function that makes its own features.

    Attributes:
        settings: the learner's parameters.
        contexts: values, and the detectors that were found.
        examples: what is remembered.
        n_updates: transitions learned from so far.
        n_trials: trials that have ended so far.
    """

    def __init__(
        self,
        settings: DiscoverySettings | None = None,
        rng: np.random.Generator | None = None,
    ) -> None:
        """Start without experience: all values are zero.

        Args:
            settings: parameters.
            rng: nothing is drawn from it; other learners draw where they start.
        """
        self.settings = DiscoverySettings() if settings is None else settings
        self.contexts = Contexts.whole(self.settings)
        self.examples = Examples.none(self.settings)
        self.n_updates, self.n_trials = 0, 0
        known = self.settings, self.contexts, self.examples
        self._values = Values(*known)
        self._discoverer = Discoverer(*known, self._values)
        self._forced_after = forced_after(self.settings)
        self._visits: list[Visit] = []
        self._rewards: list[float] = []

    def q_values(self, observation: Observation) -> NDArray[np.float64]:
        """The value of every action, (n_actions,) [actions]."""
        haptic, orientation = self._checked(observation)
        return self._values.of(haptic, self._picture(observation), orientation)

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
        """Learn values from a transition, and features from a trial that has ended.

        Args:
            transition: what has just happened.
            rng: draws new features.

        Returns:
            The temporal-difference error, before anything was learned.
        """
        visit = self._visit(transition)
        if all(visit.context != earlier.context for earlier in self._visits):
            self._visits.append(visit)
        self._rewards.append(visit.example.reward)
        target, least = visit.example.target, self.settings.least_rate
        self.contexts.learn(visit.context, visit.leaf, target, least)
        self.n_updates += 1
        if transition.is_last:
            self._end_trial(rng)
        return target - visit.predicted

    def state(self) -> dict[str, NDArray]:
        """Contexts, examples and counts: all but a trial that is going on."""
        arrays = saved.named(self.contexts, self.examples)
        counts = {"n_updates": self.n_updates, "n_trials": self.n_trials}
        copies = {name: array.copy() for name, array in arrays.items()}
        return {**copies, **{name: np.array(count) for name, count in counts.items()}}

    def restore(self, state: dict[str, NDArray]) -> None:
        """Take over what `state` gave, between two trials.

        Raises:
            InvalidValue: if it is of another learner, or not of finite numbers.
        """
        state_arrays.check(state, self.state())
        for name in ("n_updates", "n_trials"):
            state_arrays.check_count(name, int(state[name]))
        saved.take_over(state, self.contexts, self.examples)
        self.n_updates, self.n_trials = int(state["n_updates"]), int(state["n_trials"])
        self._visits, self._rewards = [], []

    def _visit(self, transition: Transition) -> Visit:
        """What is to be known of a transition until its trial ends."""
        before, action = transition.observation, int(transition.action)
        check_integer("action", action, 0, self.settings.n_actions - 1)
        haptic, orientation = self._checked(before)
        next_haptic, _ = self._checked(transition.next_observation)
        allowed = np.array(transition.allowed, np.bool_)
        if not transition.terminated:
            allowed_actions(allowed, self.settings.n_actions)
        example = Example(
            # Seen at the trial's begin, it is the same for the next state.
            self._picture(before),
            orientation,
            float(transition.reward),
            next_haptic,
            bool(transition.terminated),
            allowed,
            target=np.nan,
        )
        context = haptic, action
        leaf = self.contexts.leaf(context, example.picture, orientation)
        return Visit(
            context,
            example._replace(target=self._values.target(example)),
            leaf,
            self.contexts.value(context, leaf),
            float(self.contexts.mean[context]),
            len(self._rewards),
        )

    def _end_trial(self, rng: np.random.Generator) -> None:
        """Consider what was done for the first time in the trial, in that order."""
        outcomes = self._outcomes()
        for visit in self._visits:
            self._discoverer.consider(visit, outcomes[visit.step], self.n_trials, rng)
        # Insertions first, grasps last: each is estimated by what follows it.
        due = np.argwhere(self.n_trials == self._forced_after.T)
        for action, haptic in due[::-1]:
            self._values.split((int(haptic), int(action)), [], self.n_trials)
        self._visits, self._rewards = [], []
        self.n_trials += 1

    def _outcomes(self) -> dict[int, float]:
        """What each step that is considered is judged by [actions]."""
        if self.settings.labels == "td":
            return {visit.step: visit.example.target for visit in self._visits}
        outcomes, total = {}, 0.0
        for step in reversed(range(len(self._rewards))):
            total = self._rewards[step] + self.settings.discount * total
            outcomes[step] = total
        return outcomes

    def _checked(self, observation: Observation) -> tuple[int, int]:
        """Haptic state and orientation, which without forced splits is not read."""
        haptic = int(observation.haptic)
        check_integer("haptic state", haptic, 0, self.settings.n_haptic - 1)
        if not self.settings.forced_splits:
            return haptic, NOT_READ
        orientation = int(observation.orientation)
        check_integer("orientation", orientation, 0, 1)
        return haptic, orientation

    def _picture(self, observation: Observation) -> NDArray[np.float64]:
        """The cumulative histogram, (101,) [1]."""
        visual = np.asarray(observation.visual, np.float64)
        if visual.shape != (N_BINS,):
            raise InvalidValue("scaled histogram shape", visual.shape, f"({N_BINS},)")
        if not np.isfinite(visual).all():
            raise InvalidValue("scaled histogram", "NaN or infinite", "finite numbers")
        return cumulative(visual)
