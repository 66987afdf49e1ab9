"""How each trial of a run was solved, and the share of each way in sets of trials."""

from dataclasses import dataclass
from typing import Self

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from prospect_mj.experiment.paper.measures.bootstrap import Floats
from prospect_mj.experiment.paper.measures.curves import ratio
from prospect_mj.experiment.populations.strategies import Strategy, classify
from prospect_mj.experiment.run.learning_curve import BLOCK
from prospect_mj.recording.hands import NUMBERS, inserting_hand
from prospect_mj.recording.worlds import STANDARD

SET = 50
"""Trials whose shares are taken together; of a short run `BLOCK`."""
_LONG = 4 * SET


@dataclass(frozen=True, eq=False)
class TrialStrategies:
    """What became of the n trials of a run."""

    lid: NDArray[np.int8]
    """(n,), side of the lid, LEFT or RIGHT."""
    strategy: NDArray[np.int8]
    """(n,), numbers of `Strategy`."""

    @classmethod
    def of(cls, trials: pa.Table, actions: pa.Table, world: str = STANDARD) -> Self:
        """Classify trials by the actions in a run's tables.

        Args:
            trials: under `records.TRIAL_SCHEMA`, at least one.
            actions: theirs, under `records.ACTION_SCHEMA`.
            world: in which they were run; it decides which hand inserts.
        """
        lid = np.array(
            [NUMBERS[side] for side in trials["orientation"].to_pylist()], np.int8
        )
        shape = len(lid), int(trials["n_actions"].to_numpy().max())
        cells = actions["trial"].to_numpy(), actions["step"].to_numpy()
        padded = []
        for name in ("action", "executed", "inserted"):
            column = actions[name].to_numpy()
            spread = np.zeros(shape, column.dtype)
            spread[cells] = column
            padded.append(spread)
        return cls(lid, classify(inserting_hand(lid, world), *padded))

    def shares(self, of_kind: NDArray[np.bool_], edges: NDArray[np.intp]) -> Floats:
        """Share of each strategy in sets of trials.

        Args:
            of_kind: (n,), the trials that the shares are of.
            edges: (s + 1,), first trial of each set, and the end of the last.

        Returns:
            (4, s), by `Strategy`; NaN in a set without a trial of the kind.
        """
        counts = [
            np.histogram(np.flatnonzero(of_kind & (self.strategy == number)), edges)[0]
            for number in Strategy
        ]
        used = np.array(counts, np.float64)
        return ratio(used, np.broadcast_to(used.sum(axis=0), used.shape))


def set_size(n_trials: int) -> int:
    """Trials per set in a run of so many."""
    return SET if n_trials >= _LONG else BLOCK


def set_edges(n_trials: int, pretrain: int) -> NDArray[np.intp]:
    """Where sets of trials begin, and the end of the last one, (s + 1,).

    Pretraining and what follows are in no set together; the last set of each may be a
    smaller one.
    """
    switch, size = min(pretrain, n_trials), set_size(n_trials)
    first, then = np.arange(0, switch, size), np.arange(switch, n_trials, size)
    return np.concatenate([first, then, [n_trials]])
