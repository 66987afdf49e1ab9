"""How many trials each learner needs to be near-optimal, and its curve.

Three measures. *All runs* is the reproduction's (`paper.measures.learning`): the first
trial of the first set of ten from which on every set has a mean over runs of at most
2.4 actions. It asks for hundreds of runs, as one unlucky set of few runs breaks the
"every". *Smoothed* asks the same of moving means over five sets, and of samples of as
many runs for every learner: subsets of those who have more. *Single run* is the end of
the first 50 successive trials of a run with such a mean, its median over runs.
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
    band,
    times_drawn,
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
"""Trials until near-optimal, infinite where it is not reached; mean actions of the last
hundred trials; processor time of a run [s]."""

_LAST = 100


class Runs(NamedTuple):
    """What the runs of a learner did."""

    n_actions: NDArray[np.integer]
    """(runs, trials) [actions]."""
    seconds: float
    """Processor time of a run [s]."""


def curves(learners: Mapping[str, Runs], size: int, seed: int) -> pa.Table:
    """The learning curve of every learner.

    Args:
        learners: what their runs did, by name.
        size: runs of a resample, from which the band comes.
        seed: of the resamples.
    """
    parts = []
    for agent, runs in learners.items():
        sets = _sums(runs)
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
        size: runs of a resample.
        seed: of the resamples.
    """
    rows = [
        _measured(agent, runs, size, _rng(seed, agent))
        for agent, runs in learners.items()
    ]
    return pa.Table.from_pylist(rows, schema=LEARNING)


def _measured(
    agent: str, runs: Runs, size: int, rng: np.random.Generator
) -> dict[str, object]:
    n_runs, n_trials = runs.n_actions.shape
    sets = _sums(runs)
    strict = BLOCK * settled(sets.mean(axis=0, keepdims=True) / BLOCK, NEAR_OPTIMAL)
    smooth = moving_means(_resampled(sets, size, rng))
    times = BLOCK * settled(smooth, NEAR_OPTIMAL)
    single = _single_runs(runs)
    drawn = single[rng.integers(n_runs, size=(RESAMPLES, n_runs))]
    # Not interpolated, as infinity may be among them.
    medians = np.quantile(drawn, 0.5, axis=1, method="inverted_cdf")
    last = mean_of_few(runs.n_actions[:, -_LAST:].mean(axis=1))
    values = {"smoothed": times, "single_run": medians}
    middles = {
        "smoothed": np.quantile(times, 0.5, method="inverted_cdf"),
        "single_run": np.quantile(single, 0.5, method="inverted_cdf"),
    }
    row: dict[str, object] = {"agent": agent, "runs": n_runs, "trials": n_trials}
    row["all_runs"] = float(strict[0])
    for name, resampled in values.items():
        low, high = band(resampled)
        row |= {name: middles[name], f"{name}_low": low, f"{name}_high": high}
    ends = {"last_actions": last.estimate, "last_low": last.low, "last_high": last.high}
    return row | ends | {"seconds_per_run": runs.seconds}


def _single_runs(runs: Runs) -> Floats:
    """Trials until each run is near-optimal (runs,), the window counted."""
    reached = [first_near_optimal_window(row) for row in runs.n_actions]
    return np.array([np.inf if n is None else n + WINDOW for n in reached])


def _sums(runs: Runs) -> Floats:
    """Actions (runs, sets) in each set of ten, in whole numbers."""
    return in_sets(runs.n_actions).sum(axis=2).astype(np.float64)


def _resampled(sets: Floats, size: int, rng: np.random.Generator) -> Floats:
    """Mean curves (b, sets) of `size` runs each: subsets, or resamples of so few."""
    n_runs = len(sets)
    if n_runs > size:
        chosen = np.stack(
            [rng.choice(n_runs, size, replace=False) for _ in range(RESAMPLES)]
        )
        return np.stack([sets[rows].sum(axis=0) for rows in chosen]) / (BLOCK * size)
    return times_drawn(n_runs, rng) @ sets / (BLOCK * n_runs)


def _rng(seed: int, agent: str) -> np.random.Generator:
    """The same for a learner whichever others there are."""
    return np.random.default_rng([seed, *agent.encode()])
