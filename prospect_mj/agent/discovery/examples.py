"""What happened in each context, remembered: the latest examples of either class."""

from typing import NamedTuple, Self

import numpy as np
from numpy.typing import NDArray

from prospect_mj.agent.features import N_BINS
from prospect_mj.agent.settings import DiscoverySettings

Context = tuple[int, int]
"""A haptic state and an action."""
NOT_READ = 0
"""In place of the orientation, where no split is forced."""


class Example(NamedTuple):
    """One step of a trial, as it is remembered."""

    picture: NDArray[np.float64]
    """c, (101,) [1], the cumulative histogram."""
    orientation: int
    """Side of the lid where splits are forced, else NOT_READ."""
    reward: float
    """[actions]."""
    next_haptic: int
    """The haptic state that was reached."""
    terminated: bool
    """Whether the task had ended there."""
    allowed: NDArray[np.bool_]
    """(n_actions,): what could be chosen there."""
    target: float
    """[actions], as it was at the time."""


class Examples(NamedTuple):
    """Rings of examples, (n_haptic, n_actions, 2, memory, ...), the two by class."""

    picture: NDArray[np.float64]
    orientation: NDArray[np.int64]
    reward: NDArray[np.float64]
    next_haptic: NDArray[np.int64]
    terminated: NDArray[np.bool_]
    allowed: NDArray[np.bool_]
    target: NDArray[np.float64]
    added: NDArray[np.int64]
    """(n_haptic, n_actions, 2): all that there ever were; the newest one takes the
    place of the oldest."""

    @classmethod
    def none(cls, settings: DiscoverySettings) -> Self:
        """Room for examples."""
        rings = settings.n_haptic, settings.n_actions, 2
        places = *rings, settings.memory
        return cls(
            picture=np.zeros((*places, N_BINS + 1)),
            orientation=np.zeros(places, np.int64),
            reward=np.zeros(places),
            next_haptic=np.zeros(places, np.int64),
            terminated=np.zeros(places, np.bool_),
            allowed=np.zeros((*places, settings.n_actions), np.bool_),
            target=np.zeros(places),
            added=np.zeros(rings, np.int64),
        )

    def add(self, context: Context, kind: int, example: Example) -> None:
        """Remember an example of a class."""
        ring = *context, kind
        place = *ring, self.added[ring] % self.target.shape[-1]
        for array, value in zip(self[:-1], example, strict=True):
            array[place] = value
        self.added[ring] += 1

    def number(self, context: Context, kind: int) -> int:
        """Examples of a class that are remembered."""
        return min(int(self.added[*context, kind]), self.target.shape[-1])

    def pictures(self, context: Context, kind: int) -> NDArray[np.float64]:
        """(n, 101): the pictures of a class."""
        return self.picture[*context, kind, : self.number(context, kind)]

    def of(self, context: Context) -> list[Example]:
        """All examples of a context: class by class, place by place."""
        return [
            Example(*(array[*context, kind, place] for array in self[:-1]))
            for kind in range(2)
            for place in range(self.number(context, kind))
        ]
