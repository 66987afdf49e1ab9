"""How far a run is: a bar on a terminal, else a line now and then."""

import sys

import numpy as np
from tqdm import tqdm

from prospect_mj.closing import Closing
from prospect_mj.experiment.learning_curve import WINDOW
from prospect_mj.experiment.run_folder import RunFolder

LINE_EVERY = 100
"""Trials between two lines."""


class Progress(Closing):
    """Tells on stderr how far the run is and how well the learner did lately."""

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
        if not self._bar.disable:
            self._bar.set_postfix_str(_recent_success(folder), refresh=False)
            self._bar.update()
        elif folder.n_trials % LINE_EVERY == 0:
            done = f"trial {folder.n_trials} of {folder.config.trials}"
            print(f"{done}: {_recent_success(folder)}", file=sys.stderr, flush=True)

    def close(self) -> None:
        """Leave the bar as it is on the terminal."""
        self._bar.close()


def _recent_success(folder: RunFolder) -> str:
    recent = folder.trials["n_actions"].slice(max(folder.n_trials - WINDOW, 0))
    mean = np.mean(recent.to_numpy())
    return f"mean actions of last {len(recent)}: {mean:.2f}"
