"""The progress bar of a run."""

from types import TracebackType
from typing import Self

import numpy as np
from tqdm import tqdm

from prospect_mj.experiment.run_folder import RunFolder

WINDOW = 50
"""Trials of the mean that is shown."""


class Progress:
    """A bar on stderr, if that is a terminal, with the learner's recent success."""

    def __init__(self, folder: RunFolder) -> None:
        """Show the trials that `folder` already has."""
        self._bar = tqdm(
            total=folder.config.trials,
            initial=folder.n_trials,
            desc="trials",
            unit="trial",
            dynamic_ncols=True,
            disable=None,
        )

    def advance(self, folder: RunFolder) -> None:
        """Count one more trial."""
        if self._bar.disable:
            return
        recent = folder.trials["n_actions"].slice(max(folder.n_trials - WINDOW, 0))
        mean = np.mean(recent.to_numpy())
        self._bar.set_postfix_str(
            f"mean actions of last {len(recent)}: {mean:.2f}", refresh=False
        )
        self._bar.update()

    def __enter__(self) -> Self:
        """Return the bar."""
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        """Leave the bar as it is on the terminal."""
        self._bar.close()
