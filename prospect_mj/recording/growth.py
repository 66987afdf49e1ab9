"""Growing a recording to a wanted size, in parallel and in small steps."""

import platform
from collections.abc import Iterator
from dataclasses import replace
from functools import lru_cache
from itertools import islice, product
from typing import NamedTuple

from prospect_mj.errors import RecordingError, SimulationDiverged, UnforeseenEvent
from prospect_mj.recording.arrays import complete_depth
from prospect_mj.recording.config import Extent
from prospect_mj.recording.growing import GrowingRecording
from prospect_mj.recording.key import RecordingKey
from prospect_mj.recording.live_physics import LivePhysics
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


class Grown(NamedTuple):
    """What came of a piece of work."""

    tree: OutcomeTree | None
    """With what was added; None: it could not be planted."""
    n_added: int
    """Actions."""
    failure: str
    """Why the tree can't be grown to its end, empty if it can: the physics of an action
    is void, or not what the supervisor's model foresees."""


class Growth:
    """A recording on its way to a wanted size.

    Args:
        recording: where it grows.
        extent: the wanted size.

    Attributes:
        n_trees: the wanted trees.
        n_complete: those of them that are complete.
        n_actions: actions recorded in the wanted trees.
        failures: of trees that were left aside, each with its place and reason.
    """

    def __init__(self, recording: GrowingRecording, extent: Extent) -> None:
        """Look through what is there, so that nothing damaged is found hours later.

        Raises:
            RecordingError: if a tree is damaged or belongs to another recording.
        """
        self._recording, self._depth = recording, extent.depth
        self.n_trees = extent.presentations * len(ORIENTATIONS)
        self.n_complete = self.n_actions = self._in_complete = 0
        self.failures: list[str] = []
        self._unfinished: list[tuple[Orientation, int]] = []
        for number, orientation in product(range(extent.presentations), ORIENTATIONS):
            self._look_at(orientation, number)

    def _look_at(self, orientation: Orientation, number: int) -> None:
        """Count what there is of a tree."""
        table = self._recording.table(orientation, number)
        n_actions = 0 if table is None else table.num_rows - 1
        self.n_actions += n_actions
        if table is not None and complete_depth(table) >= self._depth:
            self._count_complete(n_actions)
        else:
            self._unfinished.append((orientation, number))

    def _count_complete(self, n_actions: int) -> None:
        self.n_complete += 1
        self._in_complete += n_actions

    @property
    def n_expected(self) -> int:
        """Actions that there will be in the end, if the rest goes as usual."""
        n_left = self.n_trees - self.n_complete
        usual = self._in_complete + n_left * usual_actions(self._depth)
        return max(usual, self.n_actions)

    def run(self, workers: Workers) -> Iterator[OutcomeTree]:
        """Grow until the wanted size is reached, and keep every step.

        A tree that can't be grown to its end is kept as far as it goes, and is told of
        in `failures`; all others grow on.

        Args:
            workers: who runs the actions; no more of them than trees are unfinished.

        Yields:
            The tree to which something was added, when it is permanent.
        """
        if not self._unfinished:
            return
        jobs = min(workers.jobs, len(self._unfinished))
        width = jobs * _UNITS_PER_JOB
        left, active = self._units(), list[Unit]()
        with replace(workers, jobs=jobs).mapper() as mapped:
            while units := [*active, *islice(left, width - len(active))]:
                active = []
                for done in mapped(grown, units):
                    if done.tree is not None:
                        self._recording.keep(done.tree)
                    if self._goes_on(done):
                        active.append(self._unit(*done.tree.name, done.tree))
                    if done.tree is not None:
                        yield done.tree

    def _goes_on(self, done: Grown) -> bool:
        """Count what was done; whether there is more to do at its tree."""
        self.n_actions += done.n_added
        if done.failure:
            self.failures.append(done.failure)
            return False
        complete = done.tree.is_complete(self._depth)
        if complete:
            self._count_complete(done.tree.n_actions)
        return not complete

    def _units(self) -> Iterator[Unit]:
        """Work on the trees that are not complete, the first presentations first."""
        for name in self._unfinished:
            yield self._unit(*name, self._recording.tree(*name))

    def _unit(
        self, orientation: Orientation, number: int, tree: OutcomeTree | None
    ) -> Unit:
        return Unit(self._recording.key, orientation, number, tree, self._depth)


def grown(unit: Unit) -> Grown:
    """Do a piece of work on the physics of this process.

    Raises:
        RecordingError: if outcomes on this machine are not those of the recording.
    """
    physics, tree, failure = _physics(unit.key), unit.tree, ""
    n_before = 0 if tree is None else tree.n_actions
    try:
        if tree is None:
            tree = physics.plant(unit.orientation, unit.number)
        for edge in islice(tree.open_edges(unit.depth), _ACTIONS_PER_UNIT):
            physics.extend(tree, edge)
    except (SimulationDiverged, UnforeseenEvent) as error:
        failure = str(error)
    n_added = 0 if tree is None else tree.n_actions - n_before
    return Grown(tree, n_added, failure)


@lru_cache(maxsize=1)
def _physics(key: RecordingKey) -> LivePhysics:
    """The physics of this process, which stays for the next piece of work."""
    changed = key.differences(RecordingKey.present(key.config))
    if changed:
        raise RecordingError(
            f"the recording can't grow on {platform.node()}: {'; '.join(changed)}"
        )
    return LivePhysics(key.config)
