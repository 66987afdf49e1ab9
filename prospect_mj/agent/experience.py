"""The latest transitions, remembered to be learned from again.

Replayed experience after Lin, "Self-improving reactive agents based on reinforcement
learning, planning and teaching", Machine Learning 8 (1992).
"""

from collections.abc import Callable, Mapping
from typing import NamedTuple

import numpy as np
from numpy.typing import DTypeLike, NDArray

from prospect_mj.agent import state_arrays


class Step(NamedTuple):
    """A transition in the numbers that one learner knows states by."""

    state: NDArray
    """(width,): the state that was left."""
    action: int
    reward: float
    """[actions]."""
    next_state: NDArray
    """(width,): the state that was reached."""
    terminated: bool
    allowed: NDArray[np.bool_]
    """(n_actions,): what could be chosen there."""


class Experience:
    """A ring of steps: the newest takes the place of the oldest.

    Args:
        capacity: steps remembered.
        width: numbers of a state.
        n_actions: number of actions.
        dtype: kind of a state's numbers.
        forgets: whether it isn't remembered what could be chosen, so that all actions
            count.
    """

    def __init__(
        self,
        capacity: int,
        width: int,
        n_actions: int,
        dtype: DTypeLike,
        forgets: bool = False,
    ) -> None:
        """Remember nothing yet."""
        self._capacity, self._n_added, self._forgets = capacity, 0, forgets
        self._rings = Step(
            state=np.zeros((capacity, width), dtype),
            action=np.zeros(capacity, np.int64),
            reward=np.zeros(capacity),
            next_state=np.zeros((capacity, width), dtype),
            terminated=np.zeros(capacity, bool),
            allowed=np.zeros((capacity, n_actions), bool),
        )

    def __len__(self) -> int:
        """Steps remembered at present."""
        return min(self._n_added, self._capacity)

    def add(self, step: Step) -> None:
        """Remember a step: number n of all goes to place n modulo the capacity."""
        place = self._n_added % self._capacity
        for ring, value in zip(self._rings, step, strict=True):
            ring[place] = value
        self._rings.allowed[place] |= self._forgets
        self._n_added += 1

    def replay(
        self, times: int, rng: np.random.Generator, learn: Callable[[Step], object]
    ) -> None:
        """Learn from steps again.

        Args:
            times: how many; each may be any of those remembered, whatever came before.
            rng: draws the place of each, just before it is learned from, by
                `rng.integers(n)` of the n that are taken.
            learn: told of each.
        """
        for _ in range(times):
            place = int(rng.integers(len(self)))
            learn(Step(*(ring[place] for ring in self._rings)))

    def arrays(self) -> dict[str, NDArray]:
        """All that is remembered, by name: places that are taken, and the count."""
        taken = {
            f"experience_{name}": ring[: len(self)].copy()
            for name, ring in self._rings._asdict().items()
        }
        return {**taken, "experience_count": np.array(self._n_added)}

    def restore(self, arrays: Mapping[str, NDArray]) -> None:
        """Take over what `arrays` gave.

        Raises:
            ProspectError: if there is other than that, or what is no finite number.
        """
        self._n_added = int(arrays.get("experience_count", 0))
        state_arrays.check_count("experience_count", self._n_added)
        state_arrays.check(arrays, self.arrays())
        for name, ring in self._rings._asdict().items():
            ring[: len(self)] = arrays[f"experience_{name}"]


def is_experience(name: str) -> bool:
    """Whether an array of a learner's state is of its experience, by its name."""
    return name.startswith("experience_")
