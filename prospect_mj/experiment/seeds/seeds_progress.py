"""How far runs in other processes are: a bar on a terminal, else a line for each."""

import sys
import threading
from collections.abc import Sequence
from pathlib import Path

from tqdm import tqdm

from prospect_mj.closing import Closing
from prospect_mj.experiment.run.side_by_side import Ended
from prospect_mj.experiment.seeds.seeds_folder import n_finished

_EVERY = 0.5
"""Between two looks at the folders [s]."""


class SeedsProgress(Closing):
    """Tells on stderr how many trials are done, by what is in the runs' folders.

    Args:
        runs: folders of the runs.
        trials: that are wanted of each; one that was made longer counts as many.
        noun: what the runs are called.
    """

    def __init__(self, runs: Sequence[Path], trials: int, noun: str = "seeds") -> None:
        """Show what is there already, and look again from time to time."""
        self._runs, self._trials, self._noun = runs, trials, noun
        self._n_ended = 0
        self._bar = tqdm(
            total=trials * len(runs),
            initial=self._n_trials(),
            desc="trials",
            unit="trial",
            dynamic_ncols=True,
            disable=None,
        )
        self._closing = threading.Event()
        self._watch = threading.Thread(target=self._follow, daemon=True)
        if not self._bar.disable:
            self._watch.start()

    def ended(self, run: Ended) -> None:
        """Tell that a run has ended."""
        self._n_ended += 1
        if self._bar.disable:
            how = "finished" if run.failure is None else "failed"
            told = f"{run.path.name} {how}, {self._n_ended} of {len(self._runs)}"
            print(told, file=sys.stderr, flush=True)

    def close(self) -> None:
        """Leave the bar as it is on the terminal."""
        self._closing.set()
        if self._watch.is_alive():
            self._watch.join()
        if not self._bar.disable:
            self._show()
        self._bar.close()

    def _follow(self) -> None:
        while not self._closing.wait(_EVERY):
            self._show()

    def _show(self) -> None:
        self._bar.set_postfix_str(
            f"{self._n_ended} of {len(self._runs)} {self._noun}", refresh=False
        )
        self._bar.update(self._n_trials() - self._bar.n)

    def _n_trials(self) -> int:
        return sum(min(n_finished(run), self._trials) for run in self._runs)
