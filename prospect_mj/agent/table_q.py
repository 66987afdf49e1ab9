"""Q-learning with a table that is told the orientation: nothing is to be discovered.

Q(o, h, a) of orientation o, haptic state h and action a moves towards its target,

    Q(o, h, a) <- Q(o, h, a) + alpha [r + gamma max_a' Q(o, h', a') - Q(o, h, a)] .

It is a control: what it shows as well as others do can't be owed to seeing or to
discovering. With `copied_habit` an orientation that was never learned from has a copy
of the other one's values, and with `known_correction` the two actions that mend the
wrong grasp have their right values in it.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from prospect_mj.agent import state_arrays
from prospect_mj.agent.action_numbers import INSERTS, SWAPS_TO
from prospect_mj.agent.choice import (
    Choice,
    allowed_actions,
    checked_action,
    epsilon_greedy,
)
from prospect_mj.agent.experience import Experience, Step, is_experience
from prospect_mj.agent.haptics import LEFT, categories_of, holding_of
from prospect_mj.agent.observation import Observation, Transition
from prospect_mj.agent.settings import TableSettings
from prospect_mj.checks import check_integer

N_ORIENTATIONS = 2


class TableQ:
    """A value for each orientation, haptic state and action.

    Attributes:
        settings: the learner's parameters.
        values: Q, (2, n_haptic, n_actions) [actions].
        seen: (2,): the orientations that it has learned from.
        n_updates: transitions learned from so far, those replayed not counted.
    """

    def __init__(
        self,
        settings: TableSettings | None = None,
        rng: np.random.Generator | None = None,
    ) -> None:
        """Start without experience.

        Args:
            settings: parameters.
            rng: draws the initial values; None: they are zero.
        """
        self.settings = known = TableSettings() if settings is None else settings
        shape = N_ORIENTATIONS, known.n_haptic, known.n_actions
        self.values = np.zeros(shape)
        if rng is not None:
            self.values += rng.normal(0.0, known.initial_sd, shape)
        self.seen = np.zeros(N_ORIENTATIONS, bool)
        self.n_updates = 0
        self._experience: Experience | None = None
        if known.replays:
            self._experience = Experience(
                known.buffer, 2, known.n_actions, np.int64, known.replays_forget
            )

    def q_values(self, observation: Observation) -> NDArray[np.float64]:
        """The value of every action: (n_actions,) [actions]."""
        orientation, haptic = self._cell(observation)
        return self._known(orientation)[haptic].copy()

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
        """Learn from one transition, then from remembered ones, this one among them.

        Args:
            transition: what has just happened.
            rng: draws what is replayed, if anything is.

        Returns:
            The temporal-difference error of `transition` before.
        """
        step = self._step(transition)
        orientation = int(step.state[0])
        self.values[orientation] = self._known(orientation)
        self.seen[orientation] = True
        error = self._learn(step)
        self.n_updates += 1
        if self._experience is not None:
            self._experience.add(step)
            self._experience.replay(self.settings.replays, rng, self._learn)
        return error

    def state(self) -> dict[str, NDArray]:
        """Values, orientations that were seen, number of updates, any experience."""
        remembered = {} if self._experience is None else self._experience.arrays()
        return {**self._own(), **remembered}

    def restore(self, state: dict[str, NDArray]) -> None:
        """Take over what `state` gave.

        Raises:
            ProspectError: if it is of another learner, or not of finite numbers.
        """
        remembered = {}
        if self._experience is not None:
            remembered = {n: a for n, a in state.items() if is_experience(n)}
        own = {name: state[name] for name in state.keys() - remembered.keys()}
        state_arrays.check(own, self._own())
        if self._experience is not None:
            self._experience.restore(remembered)
        self.values[:], self.seen[:] = own["values"], own["seen"]
        self.n_updates = int(own["n_updates"])
        state_arrays.check_count("number of updates", self.n_updates)

    def _own(self) -> dict[str, NDArray]:
        """All of the state but the experience."""
        values, seen = self.values.copy(), self.seen.copy()
        return {"values": values, "seen": seen, "n_updates": np.array(self.n_updates)}

    def _known(self, orientation: int) -> NDArray[np.float64]:
        """(n_haptic, n_actions): values that an orientation has, or has as a copy."""
        other = 1 - orientation
        is_copied = self.settings.copied_habit and self.seen[other]
        if self.seen[orientation] or not is_copied:
            return self.values[orientation]
        copy = self.values[other].copy()
        if self.settings.known_correction:
            self.correct(copy, orientation)
        return copy

    def correct(self, values: NDArray[np.float64], orientation: int) -> None:
        """Value the swap to the lid's hand, and the insertion by it, as they are.

        Args:
            values: (n_haptic, n_actions) [actions], of one orientation; changed in
                place, but for all other actions.
            orientation: which, 0 left, 1 right.
        """
        n_haptic = self.settings.n_haptic
        for haptic in range(1, n_haptic):
            hand = holding_of(haptic, categories_of(n_haptic)) - LEFT
            if hand == orientation:
                values[haptic, INSERTS[hand]] = -1.0
            else:
                swap = SWAPS_TO[orientation]
                values[haptic, swap] = -1.0 - self.settings.discount

    def _learn(self, step: Step) -> float:
        """Move one value; give the error before."""
        orientation, haptic = step.state
        target = step.reward
        if not step.terminated:
            follows = self.values[tuple(step.next_state)][step.allowed]
            target += self.settings.discount * float(follows.max())
        error = target - float(self.values[orientation, haptic, step.action])
        self.values[orientation, haptic, step.action] += self.settings.step_size * error
        return error

    def _step(self, transition: Transition) -> Step:
        """The checked numbers of a transition."""
        n_actions = self.settings.n_actions
        action = checked_action(transition.action, n_actions)
        if not transition.terminated:
            allowed_actions(transition.allowed, n_actions)
        return Step(
            np.array(self._cell(transition.observation)),
            action,
            float(transition.reward),
            np.array(self._cell(transition.next_observation)),
            bool(transition.terminated),
            np.asarray(transition.allowed, bool),
        )

    def _cell(self, observation: Observation) -> tuple[int, int]:
        """Orientation and haptic state of an observation, checked."""
        orientation, haptic = int(observation.orientation), int(observation.haptic)
        check_integer("orientation", orientation, 0, N_ORIENTATIONS - 1)
        check_integer("haptic state", haptic, 0, self.settings.n_haptic - 1)
        return orientation, haptic
