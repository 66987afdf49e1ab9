"""How far a recording has grown: a bar on a terminal, else a line for each tree."""

import sys

from tqdm import tqdm

from prospect_mj.closing import Closing
from prospect_mj.recording.growth import Growth


class RecordProgress(Closing):
    """Tells on stderr how much is recorded, and how long the rest will take."""

    def __init__(self, growth: Growth) -> None:
        """Show what is there already."""
        self._growth, self._n_told = growth, growth.n_complete
        self._bar = tqdm(
            total=growth.n_expected,
            initial=growth.n_actions,
            desc="actions",
            unit="action",
            dynamic_ncols=True,
            disable=None,
        )

    def advance(self) -> None:
        """Count what was added."""
        growth = self._growth
        if not self._bar.disable:
            self._bar.total = growth.n_expected
            self._bar.set_postfix_str(self._trees, refresh=False)
            self._bar.update(growth.n_actions - self._bar.n)
        elif growth.n_complete > self._n_told:
            print(f"{self._trees}: {growth.n_actions} actions", file=sys.stderr)
            self._n_told = growth.n_complete

    @property
    def _trees(self) -> str:
        return f"{self._growth.n_complete} of {self._growth.n_trees} trees"

    def close(self) -> None:
        """Leave the bar as it is on the terminal."""
        self._bar.close()
