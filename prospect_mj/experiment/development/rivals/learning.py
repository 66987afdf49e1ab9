"""How many trials each learner needs to be near-optimal, and its curve.

Three measures. *All runs* is the reproduction's (`paper.measures.learning`): the first
trial of the first set of ten from which on every set has a mean over runs of at most
2.4 actions. It asks for hundreds of runs, as one unlucky set of few runs breaks the
"every". *Smoothed* asks the same of moving means over five sets, and of a group of as
many runs for every learner: estimate and interval are the medians over the groups of
those who have more. The interval is one of resamples of a group's runs, whose curves
are rougher than that of the runs themselves, so that it lies rather late. *Single run*
is the end of the first 50 successive trials of a run with such a mean, its median over
runs.
"""

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from prospect_mj.experiment.estimate import mean_of_few
from prospect_mj.experiment.paper.measures.bootstrap import (
    RESAMPLES,
    Floats,
    Interval,
    band,
    interval,
    median,
)
from prospect_mj.experiment.paper.measures.curves import in_sets, moving_means
from prospect_mj.experiment.run.learning_curve import (
    BLOCK,
    NEAR_OPTIMAL,
    WINDOW,
    first_near_optimal_window,
    settled,
)

CURVES = pa.schema(
    {
        "agent": pa.string(),
        "trial": pa.int32(),
        "actions": pa.float64(),
        "low": pa.float64(),
        "high": pa.float64(),
    }
)
"""Mean actions of a set of ten that begins with a trial, and its 95 % band."""
LEARNING = pa.schema(
    {
        "agent": pa.string(),
        "runs": pa.int32(),
        "trials": pa.int32(),
        "all_runs": pa.float64(),
        "smoothed_runs": pa.int32(),
        "smoothed": pa.float64(),
        "smoothed_low": pa.float64(),
        "smoothed_high": pa.float64(),
        "single_run": pa.float64(),
        "single_run_low": pa.float64(),
        "single_run_high": pa.float64(),
        "last_actions": pa.float64(),
        "last_low": pa.float64(),
        "last_high": pa.float64(),
        "seconds_per_run": pa.float64(),
    }
)
"""Trials until near-optimal, infinite where it is not reached, and how many runs the
smoothed ones are of; mean actions of the last hundred trials; processor time of a
run [s]."""

_LAST = 100
_MOST_GROUPS = 100


class Runs(NamedTuple):
    """What the runs of a learner did."""

    n_actions: NDArray[np.integer]
    """(runs, trials) [actions]."""
    seconds: float
    """Processor time of a run [s]."""


def curves(learners: Mapping[str, Runs], size: int, seed: int) -> pa.Table:
    """The learning curve of every learner, over all of its runs.

    Args:
        learners: what their runs did, by name.
        size: runs of a resample, from which the band comes.
        seed: of the resamples.
    """
    parts = []
    for agent, runs in learners.items():
        sets = _sums(runs.n_actions)
        low, high = band(_resampled(sets, size, _rng(seed, agent)))
        mean = sets.mean(axis=0) / BLOCK
        trial = BLOCK * np.arange(len(mean), dtype=np.int32)
        parts.append(
            pa.table([[agent] * len(mean), trial, mean, low, high], schema=CURVES)
        )
    return pa.concat_tables(parts)


def learning(learners: Mapping[str, Runs], size: int, seed: int) -> pa.Table:
    """The measures of every learner, each with its 95 % interval.

    Args:
        learners: as in `curves`.
        size: runs of a group.
        seed: of the resamples.
    """
    rows = [
        {"agent": agent, **_measured(runs, size, _rng(seed, agent))}
        for agent, runs in learners.items()
    ]
    return pa.Table.from_pylist(rows, schema=LEARNING)


def _measured(runs: Runs, size: int, rng: np.random.Generator) -> dict[str, object]:
    n_runs, n_trials = runs.n_actions.shape
    means = _sums(runs.n_actions).mean(axis=0, keepdims=True) / BLOCK
    last = mean_of_few(runs.n_actions[:, -_LAST:].mean(axis=1))
    return {
        "runs": n_runs,
        "trials": n_trials,
        "all_runs": _settled(means)[0],
        "smoothed_runs": min(n_runs, size),
        **_with_bounds("smoothed", _smoothed(runs.n_actions, size, rng)),
        **_with_bounds("single_run", _single_runs(runs.n_actions, rng)),
        "last_actions": last.estimate,
        "last_low": last.low,
        "last_high": last.high,
        "seconds_per_run": runs.seconds,
    }


def _with_bounds(name: str, found: Interval) -> dict[str, float]:
    return {name: found.estimate, f"{name}_low": found.low, f"{name}_high": found.high}


def _smoothed(
    n_actions: NDArray[np.integer], size: int, rng: np.random.Generator
) -> Interval:
    """Trials until the moving means of so many runs are near-optimal."""
    sets = _sums(n_actions)
    begins = range(0, max(len(sets) - size, 0) + 1, size)[:_MOST_GROUPS]
    groups = np.array([_group(sets[begin:][:size], rng)[:3] for begin in begins])
    return Interval(*map(float, median(groups.T)))


def _group(sets: Floats, rng: np.random.Generator) -> Interval:
    """Of the runs themselves, and of resamples of them."""
    own = sets.mean(axis=0, keepdims=True) / BLOCK
    resampled = _resampled(sets, len(sets), rng)
    estimate, others = (_settled(moving_means(each)) for each in (own, resampled))
    return interval(estimate[0], others)


def _single_runs(n_actions: NDArray[np.integer], rng: np.random.Generator) -> Interval:
    """Median trials until a run is near-optimal, the window counted."""
    reached = [first_near_optimal_window(row) for row in n_actions]
    trials = np.array([np.inf if n is None else n + WINDOW for n in reached])
    drawn = trials[rng.integers(len(trials), size=(RESAMPLES, len(trials)))]
    return interval(float(median(trials)), median(drawn))


def _settled(curves: Floats) -> Floats:
    """Trials (b,) from which on curves (b, s) stay near-optimal."""
    return BLOCK * settled(curves, NEAR_OPTIMAL)


def _sums(n_actions: NDArray[np.integer]) -> Floats:
    """Actions (runs, sets) in each set of ten, in whole numbers."""
    return in_sets(n_actions).sum(axis=2).astype(np.float64)


def _resampled(sets: Floats, size: int, rng: np.random.Generator) -> Floats:
    """Mean curves (b, sets) of `size` runs each, drawn with replacement."""
    n_runs = len(sets)
    times = rng.multinomial(size, np.full(n_runs, 1.0 / n_runs), size=RESAMPLES)
    return times @ sets / (BLOCK * size)


def _rng(seed: int, agent: str) -> np.random.Generator:
    """The same for a learner whichever others there are."""
    return np.random.default_rng([seed, *agent.encode()])
