"""How far trials are: a bar on a terminal, else a line now and then."""

import sys
from typing import Protocol

import numpy as np
import pyarrow as pa
from tqdm import tqdm

from prospect_mj.closing import Closing
from prospect_mj.experiment.run.learning_curve import WINDOW

LINE_EVERY = 100
"""Trials between two lines."""


class Trials(Protocol):
    """Trials that become more."""

    @property
    def trials(self) -> pa.Table:
        """Under `records.TRIAL_SCHEMA`."""
        ...

    @property
    def n_trials(self) -> int:
        """How many are finished."""
        ...


class Progress(Closing):
    """Tells on stderr how far trials are and how many actions they took lately."""

    def __init__(self, done: Trials, total: int) -> None:
        """Show the trials that are done already, of so many."""
        self._done, self._total = done, total
        self._bar = tqdm(
            total=total,
            initial=done.n_trials,
            desc="trials",
            unit="trial",
            dynamic_ncols=True,
            disable=None,
        )

    def advance(self) -> None:
        """Count one more trial."""
        if not self._bar.disable:
            self._bar.set_postfix_str(self._lately(), refresh=False)
            self._bar.update()
        elif self._done.n_trials % LINE_EVERY == 0:
            done = f"trial {self._done.n_trials} of {self._total}"
            print(f"{done}: {self._lately()}", file=sys.stderr, flush=True)

    def close(self) -> None:
        """Leave the bar as it is on the terminal."""
        self._bar.close()

    def _lately(self) -> str:
        n_actions = self._done.trials["n_actions"]
        recent = n_actions.slice(max(self._done.n_trials - WINDOW, 0))
        mean = np.mean(recent.to_numpy())
        return f"mean actions of last {len(recent)}: {mean:.2f}"
