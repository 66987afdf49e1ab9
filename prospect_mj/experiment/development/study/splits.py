"""When contexts split: the insertion and the grasp that a habit consists of."""

from typing import NamedTuple, Self

import numpy as np
from numpy.typing import NDArray

from prospect_mj.agent.haptics import NONE, categories_of, holding_of
from prospect_mj.experiment.paper.measures.bootstrap import (
    RESAMPLES,
    Interval,
    interval,
    median,
)
from prospect_mj.experiment.populations.population import Population
from prospect_mj.recording.hands import GRASPS, INSERTIONS, NUMBERS

NOT_SPLIT = -1


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
        """Of a population of discovery learners.

        With categories of grasps the insertion has a context for each: the first split
        of any of them counts.

        Args:
            population: with a dominant hand.
            rng: draws the resamples of runs.
        """
        scenario = population.scenario
        hand = NUMBERS[scenario.dominant]
        actions = {hand: INSERTIONS[hand], NONE: GRASPS[hand]}
        trials = [_after(population, *context) for context in actions.items()]
        runs = len(population.lid)
        drawn = rng.integers(runs, size=(RESAMPLES, runs))
        medians = (interval(float(median(one)), median(one[drawn])) for one in trials)
        return cls(*medians)


def _after(population: Population, holding: int, action: int) -> NDArray[np.float64]:
    """Trials (runs,) of an action's first split; infinite where it has none."""
    states = range(population.splits.shape[1])
    categories = categories_of(len(states))
    of_hand = [state for state in states if holding_of(state, categories) == holding]
    split = population.splits[:, of_hand, action].astype(np.float64)
    after = np.where(split == NOT_SPLIT, np.inf, split - population.scenario.pretrain)
    return after.min(axis=1)
