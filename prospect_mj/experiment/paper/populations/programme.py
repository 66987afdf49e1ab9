"""The programme of every run: what its trials present, and the numbers it draws.

Each run has a seed of its own, made of the study's seed, the scenario's pretraining and
the run's number, and in it one for each source of chance. So a run is the same whoever
computes it, in a study of any size, a change of one source leaves the others as they
are, and no two scenarios or seeds share a draw.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from prospect_mj.agent import LinearQ
from prospect_mj.agent.features import StateFeatureGenerator
from prospect_mj.experiment.paper.populations.kernel import Trials
from prospect_mj.experiment.paper.populations.outcome_graph import (
    HANDS,
    recorded_graph,
)
from prospect_mj.experiment.paper.populations.scenario import (
    PopulationSettings,
    Scenario,
)
from prospect_mj.recording.choices import phases
from prospect_mj.recording.hands import LEFT
from prospect_mj.recording.recording import Recording
from prospect_mj.supervisor.supervisor import Supervisor
from prospect_mj.task.presentation import ORIENTATIONS

# Tells these seeds from the recording's own, which begin with the lid's side, 0 or 1.
_RUNS = 2


class Run(NamedTuple):
    """One run of the learner, before it begins."""

    lid: NDArray[np.int8]
    """(n_trials,), side of the lid, LEFT or RIGHT."""
    histograms: NDArray[np.float64]
    """(n_images, 100), those of `trials.image` before they are scaled."""
    trials: Trials
    """What is presented, and the learner's random numbers."""
    weights: NDArray[np.float64]
    """(6, 303), the initial ones."""


class Programme:
    """Makes the runs of a population.

    Args:
        recording: where outcomes and histograms come from.
        scenario: what the trials present.
        settings: of the population.

    Attributes:
        recording: as given.
        settings: as given.
        supervisor: decides what the learner may choose from.
        graph: what actions lead to.
        generator: makes the features.
    """

    def __init__(
        self, recording: Recording, scenario: Scenario, settings: PopulationSettings
    ) -> None:
        """Find the presentations that are complete, and scale their histograms.

        Raises:
            RecordingError: if there is none for a side of the lid.
        """
        self.recording, self.settings = recording, settings
        self._scenario = scenario
        self.supervisor = Supervisor(settings.supervisor, settings.shaping)
        self.graph = recorded_graph(recording, self.supervisor)
        self.generator = StateFeatureGenerator(settings.features)
        self._phase = phases(self.supervisor, np.arange(scenario.trials))
        self._shown = _shown(recording, settings)
        self._histograms = recording.presentations.histogram.astype(np.float64)
        self._visual = self._scaled(self._histograms)

    def run(self, number: int) -> Run:
        """Run `number` of the population, from 0."""
        scenario = self._scenario
        dominant = ORIENTATIONS.index(scenario.dominant)
        key = _RUNS, scenario.pretrain, dominant, number
        seed = np.random.SeedSequence(self.settings.seed, spawn_key=key)
        rngs = map(np.random.default_rng, seed.spawn(5))
        presents, draws, weights_rng, noise, picked = rngs
        lid, shown = self._presented(presents)
        image, histograms, visual = shown, self._histograms, self._visual
        if self.settings.pictures == "one_per_side":
            image = self._one_per_side(lid, picked)
        if self.settings.image_noise:
            histograms = self._noisy(visual[image], noise)
            visual = self._scaled(histograms)
            image = np.arange(len(shown), dtype=np.int32)
        n_trials, max_actions = len(lid), self.settings.max_actions
        trials = Trials(
            root=self.recording.presentations.root[shown],
            image=image,
            visual=visual,
            phase=self._phase,
            draws=draws.random((n_trials, max_actions, 2)),
        )
        weights = LinearQ(self.settings.learner, rng=weights_rng).weights
        return Run(lid, histograms, trials, weights)

    def _presented(
        self, rng: np.random.Generator
    ) -> tuple[NDArray[np.int8], NDArray[np.int32]]:
        """(n_trials,): the lid's side, and the number of the presentation."""
        draws = rng.random((self._scenario.trials, 2))
        lid = np.where(draws[:, 0] < 0.5, *HANDS).astype(np.int8)
        dominant = LEFT + ORIENTATIONS.index(self._scenario.dominant)
        lid[: self._scenario.pretrain] = dominant
        shown = np.empty(len(lid), np.int32)
        for side, numbers in self._shown.items():
            of_side = lid == side
            drawn = (draws[of_side, 1] * len(numbers)).astype(np.intp)
            shown[of_side] = numbers[drawn]
        return lid, shown

    def _one_per_side(
        self, lid: NDArray[np.int8], rng: np.random.Generator
    ) -> NDArray[np.int32]:
        """(n_trials,): the presentation whose picture is shown."""
        image = np.empty(len(lid), np.int32)
        for side, numbers in self._shown.items():
            image[lid == side] = rng.choice(numbers)
        return image

    def _noisy(
        self, visual: NDArray[np.float64], rng: np.random.Generator
    ) -> NDArray[np.float64]:
        noise = rng.normal(0.0, self.settings.image_noise, visual.shape)
        return np.maximum(visual + noise, 0.0)

    def _scaled(self, histograms: NDArray[np.float64]) -> NDArray[np.float64]:
        return np.stack([self.generator.scaled_histogram(row) for row in histograms])


def _shown(
    recording: Recording, settings: PopulationSettings
) -> dict[int, NDArray[np.intp]]:
    """Numbers of the complete presentations for each side of the lid."""
    complete = recording.complete(settings.max_actions)
    lids = recording.presentations.lid[complete]
    return {side: complete[lids == side] for side in HANDS}
