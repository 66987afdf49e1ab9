"""When contexts split: the insertion and the grasp that a habit consists of."""

from typing import NamedTuple, Self

import numpy as np
from numpy.typing import NDArray

from prospect_mj.experiment.paper.measures.bootstrap import (
    RESAMPLES,
    Interval,
    interval,
)
from prospect_mj.experiment.populations.population import Population
from prospect_mj.recording.hands import GRASPS, INSERTIONS, NONE, NUMBERS

NEVER = -1


class Splits(NamedTuple):
    """Median trials, counted from the end of the pretraining, of the first split.

    Infinite where fewer than half of the runs have it.
    """

    insertion: Interval
    """By the dominant hand, which holds the jar."""
    grasp: Interval
    """By the dominant hand, while none holds it."""

    @classmethod
    def of(cls, population: Population, rng: np.random.Generator) -> Self:
        """Of a population of discovery learners without categories of grasps.

        Args:
            population: with a dominant hand.
            rng: draws the resamples of runs.
        """
        scenario = population.scenario
        hand = NUMBERS[scenario.dominant]
        contexts = (hand, INSERTIONS[hand]), (NONE, GRASPS[hand])
        trials = [_after(population, *context) for context in contexts]
        runs = len(population.lid)
        drawn = rng.integers(runs, size=(RESAMPLES, runs))
        return cls(*(_median(one, drawn) for one in trials))


def _after(population: Population, haptic: int, action: int) -> NDArray[np.float64]:
    """Trials (runs,) of a context's first split; infinite where it has none."""
    split = population.splits[:, haptic, action].astype(np.float64)
    return np.where(split == NEVER, np.inf, split - population.scenario.pretrain)


def _median(trials: NDArray[np.float64], drawn: NDArray[np.intp]) -> Interval:
    """The lower median, which is a trial of a run even where others have none."""
    middle = (len(trials) - 1) // 2
    many = np.partition(trials[drawn], middle, axis=1)[:, middle]
    return interval(float(np.sort(trials)[middle]), many)
