"""A recording in memory, to be stepped without physics."""

import warnings
from dataclasses import dataclass
from pathlib import Path
from typing import Self

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from prospect_mj.errors import RecordingError
from prospect_mj.recording import arrays, files, shipped
from prospect_mj.recording.arrays import Nodes, PredicateStates, Presentations
from prospect_mj.recording.hands import NUMBERS
from prospect_mj.recording.key import RecordingKey


@dataclass(frozen=True)
class Recording:
    """Outcomes of full physics: a tree of executed actions for each presentation."""

    key: RecordingKey
    """What it is of, and what made it."""
    nodes: Nodes
    """What every sequence of executed actions led to."""
    presentations: Presentations
    """Where each tree begins, and what was seen."""
    predicates: PredicateStates
    """The supervisor's states that occur."""

    @classmethod
    def load(cls, path: Path | None = None) -> Self:
        """Read a recording, grown to its end or not.

        Args:
            path: its folder; None for the one of the standard world that comes with the
                package.

        Raises:
            RecordingError: if it is missing or damaged.
        """
        path = shipped.folder() if path is None else path
        key = RecordingKey.read(path)
        return cls.of(key, files.all_trees(path, key))

    @classmethod
    def of(cls, key: RecordingKey, table: pa.Table) -> Self:
        """The recording of trees that are in a table, one after the other.

        Args:
            key: what it is of.
            table: as `files.read` gives it.
        """
        states, number = arrays.predicate_states(table)
        nodes = arrays.nodes(table, states, number)
        return cls(key, nodes, arrays.presentations(table, nodes), states)

    def warn_if_foreign(self) -> None:
        """Warn if what decides outcomes has changed since the recording was made."""
        changed = self.key.differences(RecordingKey.present(self.key.config))
        if changed:
            warnings.warn(
                f"the recording may differ from live physics: {'; '.join(changed)}",
                stacklevel=2,
            )

    def complete(self, depth: int) -> NDArray[np.intp]:
        """Presentations in which no outcome is missing up to a depth.

        Args:
            depth: executed actions.

        Returns:
            Their numbers (k,), at least one for each side of the lid.

        Raises:
            RecordingError: if there is none for a side.
        """
        found = np.flatnonzero(self.presentations.depth >= depth)
        for orientation, lid in NUMBERS.items():
            if not (self.presentations.lid[found] == lid).any():
                raise RecordingError(
                    "the recording has no presentation with the lid to the "
                    f"{orientation} that is complete to {depth} executed actions; "
                    f"{self._deepest()}"
                )
        return found

    def presentation_of(self, nodes: NDArray[np.integer]) -> NDArray[np.intp]:
        """The presentation in whose tree each node is, by number; both are (n,)."""
        return np.searchsorted(self.presentations.root, nodes, side="right") - 1

    def _deepest(self) -> str:
        """How long trials may be for both sides to have a presentation, in words."""
        shown = self.presentations
        deepest = (shown.depth[shown.lid == lid] for lid in NUMBERS.values())
        depth = min(int(depths.max(initial=0)) for depths in deepest)
        if not depth:
            return "let it grow until both sides have one"
        return f"both sides have one complete to {depth}: max_actions={depth} steps it"
