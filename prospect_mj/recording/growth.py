"""Growing a recording to a wanted size, in parallel and in small steps."""

import platform
from collections.abc import Iterator
from functools import lru_cache
from itertools import islice, product
from typing import NamedTuple

from prospect_mj.errors import RecordingError
from prospect_mj.recording.config import Extent
from prospect_mj.recording.grower import Grower
from prospect_mj.recording.growing import GrowingRecording
from prospect_mj.recording.key import RecordingKey
from prospect_mj.recording.tree import OutcomeTree, usual_actions
from prospect_mj.recording.workers import Workers
from prospect_mj.task.presentation import ORIENTATIONS, Orientation

_ACTIONS_PER_UNIT = 32
"""Actions that a process runs at a time; a kill loses no more of each."""
_UNITS_PER_JOB = 4
"""Trees that grow side by side, per process."""


class Unit(NamedTuple):
    """A piece of work for one process."""

    key: RecordingKey
    orientation: Orientation
    number: int
    tree: OutcomeTree | None
    """As far as it has grown; None: it is to be planted."""
    depth: int

    @property
    def n_actions(self) -> int:
        """Actions that are recorded."""
        return 0 if self.tree is None else self.tree.n_actions


class Growth:
    """A recording on its way to a wanted size.

    Args:
        recording: where it grows.
        extent: the wanted size.

    Attributes:
        n_trees: the wanted trees.
        n_complete: those of them that are complete.
        n_actions: actions recorded in the wanted trees.
    """

    def __init__(self, recording: GrowingRecording, extent: Extent) -> None:
        """Look through what is there, so that nothing damaged is found hours later.

        Raises:
            RecordingError: if a tree is damaged or belongs to another recording.
        """
        self._recording, self._depth = recording, extent.depth
        names = list(product(range(extent.presentations), ORIENTATIONS))
        self.n_trees, self.n_complete, self.n_actions = len(names), 0, 0
        self._in_complete = 0
        self._unfinished = [
            (orientation, number)
            for number, orientation in names
            if not self._counted(recording.tree(orientation, number))
        ]

    def _counted(self, tree: OutcomeTree | None) -> bool:
        """Count a tree that is there; whether it is complete."""
        if tree is None:
            return False
        self.n_actions += tree.n_actions
        return self._noted(tree)

    def _noted(self, tree: OutcomeTree) -> bool:
        """Note a tree that is complete; whether it is."""
        complete = tree.is_complete(self._depth)
        self.n_complete += complete
        self._in_complete += complete * tree.n_actions
        return complete

    @property
    def n_expected(self) -> int:
        """Actions that there will be in the end, if the rest goes as usual."""
        n_left = self.n_trees - self.n_complete
        usual = self._in_complete + n_left * usual_actions(self._depth)
        return max(usual, self.n_actions)

    def run(self, workers: Workers) -> Iterator[OutcomeTree]:
        """Grow until the wanted size is reached, and keep every step.

        Args:
            workers: who runs the actions.

        Yields:
            The tree to which something was added, when it is permanent.
        """
        if not self._unfinished:
            return
        left, active = self._units(), list[Unit]()
        width = workers.jobs * _UNITS_PER_JOB
        with workers.mapper() as mapped:
            while units := [*active, *islice(left, width - len(active))]:
                active = []
                before = {unit[1:3]: unit.n_actions for unit in units}
                for tree in mapped(grown, units):
                    self._recording.keep(tree)
                    self.n_actions += tree.n_actions - before[tree.name]
                    if not self._noted(tree):
                        active.append(self._unit(tree.name, tree))
                    yield tree

    def _units(self) -> Iterator[Unit]:
        """Work on the trees that are not complete, the first presentations first."""
        for name in self._unfinished:
            yield self._unit(name, self._recording.tree(*name))

    def _unit(self, name: tuple[Orientation, int], tree: OutcomeTree | None) -> Unit:
        return Unit(self._recording.key, *name, tree, self._depth)


def grown(unit: Unit) -> OutcomeTree:
    """Do a piece of work on the physics of this process.

    Raises:
        RecordingError: if outcomes on this machine are not those of the recording.
    """
    grower = _grower(unit.key)
    tree = unit.tree or grower.plant(unit.orientation, unit.number)
    for edge in islice(tree.open_edges(unit.depth), _ACTIONS_PER_UNIT):
        grower.extend(tree, edge)
    return tree


@lru_cache(maxsize=1)
def _grower(key: RecordingKey) -> Grower:
    """The physics of this process, which stays for the next piece of work."""
    changed = key.differences(RecordingKey.present(key.config))
    if changed:
        raise RecordingError(
            f"the recording can't grow on {platform.node()}: {'; '.join(changed)}"
        )
    return Grower(key.config)
