"""What there is to be presented, in one world or two after each other."""

from collections.abc import Sequence
from typing import NamedTuple, Self

import numpy as np
from numpy.typing import NDArray

from prospect_mj.agent.haptics import LEFT
from prospect_mj.experiment.populations.outcome_graph import HANDS
from prospect_mj.experiment.populations.recorded_world import RecordedWorld
from prospect_mj.experiment.populations.scenario import Scenario
from prospect_mj.task.presentation import ORIENTATIONS

Numbers = dict[int, NDArray[np.intp]]


class Presented(NamedTuple):
    """What the trials of a run present."""

    lid: NDArray[np.int8]
    """(n_trials,): its side, LEFT or RIGHT."""
    number: NDArray[np.int32]
    """(n_trials,): of the presentation, counted through all worlds."""


class Shown(NamedTuple):
    """The presentations of all worlds, p of them."""

    root: NDArray[np.int32]
    """(p,): node of the joined graphs where each begins."""
    histograms: NDArray[np.float64]
    """(p, 100) [pixels]."""
    numbers: tuple[Numbers, ...]
    """For each world and side of the lid, those that are complete."""

    @classmethod
    def of(cls, worlds: Sequence[RecordedWorld], max_actions: int) -> Self:
        """Those of some worlds.

        Args:
            worlds: whose presentations and nodes are counted one after the other.
            max_actions: executed actions that a presentation must be complete to.

        Raises:
            RecordingError: if there is none for a side of the lid in a world.
        """
        roots, histograms, numbers, n_nodes = [], [], [], 0
        for world in worlds:
            shown, complete = (
                world.recording.presentations,
                world.recording.complete(max_actions),
            )
            first = sum(map(len, roots))
            lids = shown.lid[complete]
            numbers.append({side: first + complete[lids == side] for side in HANDS})
            roots.append(shown.root + np.int32(n_nodes))
            histograms.append(shown.histogram.astype(np.float64))
            n_nodes += len(world.recording.nodes.child)
        return cls(np.concatenate(roots), np.concatenate(histograms), tuple(numbers))

    def presented(self, scenario: Scenario, rng: np.random.Generator) -> Presented:
        """Draw the side of the lid, and which of its presentations, for every trial."""
        draws = rng.random((scenario.all_trials, 2))
        lid = np.where(draws[:, 0] < 0.5, *HANDS).astype(np.int8)
        lid[: scenario.pretrain] = LEFT + ORIENTATIONS.index(scenario.dominant)
        number = np.empty(len(lid), np.int32)
        for (world, side), trials in _parts(scenario, lid).items():
            numbers = self.numbers[world][side]
            drawn = (draws[trials, 1] * len(numbers)).astype(np.intp)
            number[trials] = numbers[drawn]
        return Presented(lid, number)

    def one_per_side(
        self, scenario: Scenario, lid: NDArray[np.int8], rng: np.random.Generator
    ) -> NDArray[np.int32]:
        """(n_trials,): a presentation of each side whose picture all others have."""
        number = np.empty(len(lid), np.int32)
        for (world, side), trials in _parts(scenario, lid).items():
            number[trials] = rng.choice(self.numbers[world][side])
        return number


def _parts(
    scenario: Scenario, lid: NDArray[np.int8]
) -> dict[tuple[int, int], NDArray[np.bool_]]:
    """For each world and side, whether a trial (n_trials,) is of both."""
    world = np.arange(len(lid)) >= scenario.trials
    n_worlds = 2 if scenario.then_trials else 1
    return {
        (number, side): (world == number) & (lid == side)
        for number in range(n_worlds)
        for side in HANDS
    }
