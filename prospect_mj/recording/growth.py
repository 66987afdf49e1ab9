"""Growing a recording to a wanted size, in parallel and in small steps."""

from collections.abc import Iterator
from functools import lru_cache
from itertools import islice, product
from typing import NamedTuple

from prospect_mj.recording.config import Extent, RecordingConfig
from prospect_mj.recording.grower import Grower
from prospect_mj.recording.growing import GrowingRecording
from prospect_mj.recording.tree import OutcomeTree
from prospect_mj.recording.workers import Workers
from prospect_mj.task.presentation import ORIENTATIONS, Orientation

_EDGES_PER_UNIT = 32
"""Actions that a process runs at a time; a kill loses no more of each."""
_UNITS_PER_JOB = 4
"""Trees that grow side by side, per process."""


class Unit(NamedTuple):
    """A piece of work for one process."""

    config: RecordingConfig
    orientation: Orientation
    number: int
    tree: OutcomeTree | None
    """As far as it has grown; None: it is to be planted."""
    depth: int

    @property
    def name(self) -> tuple[Orientation, int]:
        """Of the presentation."""
        return self.orientation, self.number

    @property
    def n_nodes(self) -> int:
        """Nodes there are; the root alone if it is to be planted."""
        return 1 if self.tree is None else len(self.tree.nodes)


class Progress(NamedTuple):
    """What a piece of work has added."""

    tree: OutcomeTree
    nodes: int
    """New nodes, the root not counted."""
    complete: bool


def grow(
    recording: GrowingRecording, extent: Extent, workers: Workers
) -> Iterator[Progress]:
    """Grow a recording until it has a wanted size, and keep every step.

    Args:
        recording: where it grows.
        extent: the wanted size.
        workers: who runs the actions.

    Yields:
        What was added, when it is permanent.
    """
    config, left = recording.key.config, _unfinished(recording, extent)
    width, active = workers.jobs * _UNITS_PER_JOB, list[Unit]()
    while units := [*active, *islice(left, width - len(active))]:
        active = []
        sizes = {unit.name: unit.n_nodes for unit in units}
        for tree in workers.map(grown, units):
            recording.keep(tree)
            complete = tree.is_complete(extent.depth)
            if not complete:
                active.append(Unit(config, *tree.name, tree, extent.depth))
            yield Progress(tree, len(tree.nodes) - sizes[tree.name], complete)


def _unfinished(recording: GrowingRecording, extent: Extent) -> Iterator[Unit]:
    """Trees that are not there or not complete, the first presentations first."""
    for number, orientation in product(range(extent.presentations), ORIENTATIONS):
        tree = recording.tree(orientation, number)
        if tree is None or not tree.is_complete(extent.depth):
            config = recording.key.config
            yield Unit(config, orientation, number, tree, extent.depth)


def grown(unit: Unit) -> OutcomeTree:
    """Do a piece of work on the physics of this process."""
    grower = _grower(unit.config)
    tree = unit.tree or grower.plant(unit.orientation, unit.number)
    for edge in islice(tree.open_edges(unit.depth), _EDGES_PER_UNIT):
        grower.extend(tree, edge)
    return tree


@lru_cache(maxsize=1)
def _grower(config: RecordingConfig) -> Grower:
    """The physics of this process, which stays for the next piece of work."""
    return Grower(config)
