"""The numbers behind each figure, a row per point, with 95 % bands over runs."""

import numpy as np
import pyarrow as pa

from prospect_mj.experiment.paper.measures.bootstrap import Floats, band
from prospect_mj.experiment.paper.measures.curves import Curves
from prospect_mj.experiment.populations.strategies import Strategy
from prospect_mj.experiment.run.learning_curve import BLOCK

CORRECTION = "correction"
"""Early and late corrections together, as in the paper's figure 6."""
STRATEGIES = (*(strategy.name.lower() for strategy in Strategy), CORRECTION)

ACTIONS_SCHEMA = pa.schema(
    {
        "trial": pa.int32(),
        "actions": pa.float64(),
        "low": pa.float64(),
        "high": pa.float64(),
        "unsolved": pa.float64(),
        "optimum": pa.float64(),
    }
)
"""A set of ten trials: its first trial, mean actions per trial, their band, the share
of trials that were cut off, the best possible mean."""

STRATEGY_SCHEMA = pa.schema(
    {
        "trial": pa.int32(),
        "strategy": pa.string(),
        "share": pa.float64(),
        "low": pa.float64(),
        "high": pa.float64(),
        "optimum": pa.float64(),
    }
)
"""A strategy in a set of ten trials: its first trial, the strategy's share of the easy
or the difficult ones among these, its band; the best possible share of the optimal
strategy. Sets without such trials are left out."""


def actions_table(mean: Curves, resampled: Curves, optimum: Floats) -> pa.Table:
    """Figure 5: actions per trial under `ACTIONS_SCHEMA`.

    Args:
        mean: of all runs.
        resampled: of resamples of the runs.
        optimum: (s,) [actions], the best possible mean of each set.
    """
    low, high = band(resampled.actions)
    columns = {
        "trial": BLOCK * np.arange(len(low)),
        "actions": mean.actions[0],
        "low": low,
        "high": high,
        "unsolved": mean.unsolved[0],
        "optimum": optimum,
    }
    return pa.table(columns, schema=ACTIONS_SCHEMA)


def strategy_table(mean: Floats, resampled: Floats, optimum: float) -> pa.Table:
    """Figure 6: shares of the strategies under `STRATEGY_SCHEMA`.

    Args:
        mean: (1, 4, s), shares of all runs; NaN where there is no such trial.
        resampled: (b, 4, s), shares of resamples of the runs.
        optimum: share of the optimal strategy, where every trial takes the fewest
            actions.
    """
    shown = np.flatnonzero(np.isfinite(resampled).all(axis=(0, 1)))
    shares = _with_corrections(mean[..., shown])[0]
    low, high = band(_with_corrections(resampled[..., shown]))
    columns = {
        "trial": np.tile(BLOCK * shown, len(STRATEGIES)),
        "strategy": np.repeat(STRATEGIES, len(shown)),
        "share": shares.ravel(),
        "low": low.ravel(),
        "high": high.ravel(),
        "optimum": np.full(shares.size, optimum),
    }
    return pa.table(columns, schema=STRATEGY_SCHEMA)


def _with_corrections(shares: Floats) -> Floats:
    """Shares (b, 4, s) with the sum of both corrections as a fifth class."""
    corrections = shares[:, Strategy.EARLY] + shares[:, Strategy.LATE]
    return np.concatenate([shares, corrections[:, None]], axis=1)
