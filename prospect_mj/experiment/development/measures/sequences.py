"""What single runs do: the strategies that prevail one after the other."""

from collections import Counter
from collections.abc import Iterable, Mapping
from itertools import groupby
from types import MappingProxyType
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from prospect_mj.experiment.estimate import Estimate, share
from prospect_mj.experiment.populations.population import Population
from prospect_mj.experiment.populations.strategies import Strategy, easy

WINDOW = 10
"""Difficult trials of a run; what more than a half of them follow prevails."""
NO_MAJORITY = -1
"""In place of a strategy's number, where none prevails."""

Sequence = tuple[Strategy, ...]
"""Strategies that prevail one after the other, each other than the one before."""

NAMED: Mapping[str, Sequence] = MappingProxyType(
    {
        "other_optimal": (Strategy.OTHER, Strategy.OPTIMAL),
        "other_early_optimal": (Strategy.OTHER, Strategy.EARLY, Strategy.OPTIMAL),
        "late_early_optimal": (Strategy.LATE, Strategy.EARLY, Strategy.OPTIMAL),
        "other_late_early_optimal": (
            Strategy.OTHER,
            Strategy.LATE,
            Strategy.EARLY,
            Strategy.OPTIMAL,
        ),
    }
)
"""Those that learners of the abstract task went through; each is a number of a row."""


class SequenceShare(NamedTuple):
    """How many runs have a sequence."""

    sequence: Sequence
    share: Estimate
    """[1]"""


def difficult_trials(population: Population) -> list[NDArray[np.int8]]:
    """Strategies of the difficult trials after the pretraining, run by run."""
    after = slice(population.scenario.pretrain, None)
    hard = ~easy(population.lid, population.scenario.dominant)
    pairs = zip(population.strategy[:, after], hard[:, after], strict=True)
    return [strategy[is_hard] for strategy, is_hard in pairs]


def windows(strategies: NDArray[np.int8]) -> list[int]:
    """The strategy that more than a half of the trials follow, window by window.

    Args:
        strategies: (n,) of a run's difficult trials; those that fill no window are left
            out.

    Returns:
        Numbers of `Strategy`; `NO_MAJORITY` where none is followed so often.
    """
    whole = strategies[: len(strategies) // WINDOW * WINDOW].reshape(-1, WINDOW)
    counts = np.stack([(whole == kind).sum(axis=1) for kind in Strategy], axis=1)
    most = counts.argmax(axis=1)
    return np.where(counts.max(axis=1) > WINDOW / 2, most, NO_MAJORITY).tolist()


def prevailing(strategies: NDArray[np.int8]) -> Sequence:
    """The strategies that prevail one after the other in the `windows` of a run."""
    told = (Strategy(one) for one in windows(strategies) if one != NO_MAJORITY)
    return tuple(strategy for strategy, _ in groupby(told))


def sequences(population: Population) -> list[SequenceShare]:
    """All sequences that occur, the most frequent first."""
    runs = difficult_trials(population)
    counted = Counter(prevailing(strategies) for strategies in runs)
    ranked = sorted(counted.items(), key=lambda pair: (-pair[1], pair[0]))
    return [SequenceShare(found, share(n, len(runs))) for found, n in ranked]


def words(sequence: Sequence) -> str:
    """A sequence of strategies, such as `late, early, optimal`."""
    return ", ".join(strategy.name.lower() for strategy in sequence) or "none"


def named(found: Iterable[SequenceShare], runs: int) -> dict[str, Estimate]:
    """The shares of the sequences that have a name.

    Args:
        found: all that occur.
        runs: their number.
    """
    shares = {one.sequence: one.share for one in found}
    return {
        name: shares.get(sequence, share(0, runs)) for name, sequence in NAMED.items()
    }


def late_before_early(population: Population) -> Estimate:
    """Share of the runs whose median late correction comes before the median early one.

    A run without either has no such order.
    """
    runs = difficult_trials(population)
    return share(sum(_late_is_first(run) for run in runs), len(runs))


def late_alone(population: Population) -> Estimate:
    """Share of the runs that have a phase of late corrections alone.

    It is a window of `WINDOW` difficult trials of which more than a half are corrected
    late, before the first window with more than one early correction: one alone may
    come of exploration.
    """
    runs = difficult_trials(population)
    return share(sum(map(_is_late_alone, runs)), len(runs))


def _is_late_alone(strategies: NDArray[np.int8]) -> bool:
    whole = strategies[: len(strategies) // WINDOW * WINDOW].reshape(-1, WINDOW)
    late, early = (
        (whole == kind).sum(axis=1) for kind in (Strategy.LATE, Strategy.EARLY)
    )
    before = ~np.logical_or.accumulate(early > 1)
    return bool((before & (late > WINDOW / 2)).any())


def _late_is_first(strategies: NDArray[np.int8]) -> bool:
    late, early = (
        np.flatnonzero(strategies == kind) for kind in (Strategy.LATE, Strategy.EARLY)
    )
    return bool(len(late) and len(early) and np.median(late) < np.median(early))
