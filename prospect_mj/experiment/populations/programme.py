"""The programme of every run: what its trials present, and the numbers it draws.

Each run has a seed of its own, made of the study's seed, the scenario's pretraining and
the run's number, and in it one for each source of chance. So a run is the same whoever
computes it, in a study of any size, a change of one source leaves the others as they
are, and no two scenarios or seeds share a draw. Up to the change of its world a run is
that of the scenario without one.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from prospect_mj.agent import AnyLearnerSettings, Learner, new_learner
from prospect_mj.agent.features import StateFeatureGenerator
from prospect_mj.agent.haptics import LEFT, RIGHT
from prospect_mj.checks import check_integer
from prospect_mj.experiment.populations.compiled_learner import rule_of
from prospect_mj.experiment.populations.kernels.graph import Rule, Trials
from prospect_mj.experiment.populations.outcome_graph import joined, recorded_graph
from prospect_mj.experiment.populations.recorded_world import RecordedWorld
from prospect_mj.experiment.populations.scenario import PopulationSettings, Scenario
from prospect_mj.experiment.populations.shown import Shown
from prospect_mj.experiment.populations.spread import drawn_settings
from prospect_mj.recording.choices import phases
from prospect_mj.recording.recording import Recording
from prospect_mj.supervisor.supervisor import Supervisor
from prospect_mj.task.presentation import ORIENTATIONS

# Tells these seeds from the recording's own, which begin with the lid's side, 0 or 1.
_RUNS = 2


class Run(NamedTuple):
    """One run of the learner, before it begins."""

    lid: NDArray[np.int8]
    """(n_trials,), side of the lid, LEFT or RIGHT."""
    inserts: NDArray[np.int8]
    """(n_trials,), the hand that can insert the jar: on the lid's side, or on the other
    one where it goes in with its lid down."""
    histograms: NDArray[np.float64]
    """(n_images, 100), those of `trials.image` before they are scaled."""
    trials: Trials
    """What is presented, and the random numbers of the learner's choices."""
    learner: Learner
    """Without experience."""
    rng: np.random.Generator
    """What it learns with."""


class _Sources(NamedTuple):
    """Of chance: a generator for each."""

    presents: np.random.Generator
    draws: np.random.Generator
    start: np.random.Generator
    noise: np.random.Generator
    picked: np.random.Generator
    learning: np.random.Generator
    settings: np.random.Generator


class Programme:
    """Makes the runs of a population.

    Args:
        recording: where outcomes and histograms come from.
        scenario: what the trials present.
        settings: of the population.
        then: the world of the scenario's last trials, if it has such.

    Attributes:
        worlds: the one or two that trials take place in.
        settings: as given.
        supervisor: decides what the learner may choose from.
        graph: what actions lead to, in all worlds.
        generator: makes the features.
    """

    def __init__(
        self,
        recording: Recording | RecordedWorld,
        scenario: Scenario,
        settings: PopulationSettings,
        then: Recording | RecordedWorld | None = None,
    ) -> None:
        """Find the presentations that are complete, and scale their histograms.

        Raises:
            RecordingError: if there is none for a side of the lid.
            InvalidValue: if there is not just the number of worlds that the scenario
                has, or their categories are not those of the settings.
        """
        given = (recording,) if then is None else (recording, then)
        self.worlds = tuple(map(RecordedWorld.of, given))
        self._check_worlds(scenario, settings)
        self.settings, self._scenario = settings, scenario
        self.supervisor = Supervisor(settings.supervisor, settings.shaping)
        graphs = [recorded_graph(world, self.supervisor) for world in self.worlds]
        self.graph = graphs[0] if then is None else joined(*graphs)
        self.generator = StateFeatureGenerator(settings.features, settings.categories)
        self._phase = phases(self.supervisor, np.arange(scenario.all_trials))
        self._shown = Shown.of(self.worlds, settings.max_actions)
        self._visual = self._scaled(self._shown.histograms)
        self._lid_first = tuple(world.lid_first for world in self.worlds)

    def run(self, number: int) -> Run:
        """Run `number` of the population, from 0."""
        rngs = self._rngs(number)
        lid, shown = self._shown.presented(self._scenario, rngs.presents)
        image, histograms, visual = shown, self._shown.histograms, self._visual
        if self.settings.pictures == "one_per_side":
            image = self._shown.one_per_side(self._scenario, lid, rngs.picked)
        if self.settings.image_noise:
            histograms = self._noisy(visual[image], rngs.noise)
            visual = self._scaled(histograms)
            image = np.arange(len(shown), dtype=np.int32)
        trials = Trials(
            root=self._shown.root[shown],
            image=image,
            visual=visual,
            orientation=lid.astype(np.int64) - LEFT,
            phase=self._phase,
            draws=rngs.draws.random((len(lid), self.settings.max_actions, 2)),
        )
        learner = new_learner(self._drawn(rngs.settings), rngs.start)
        return Run(lid, self._inserts(lid), histograms, trials, learner, rngs.learning)

    def rule(self, learner: Learner) -> Rule:
        """What a learner keeps to."""
        settings = self.settings
        return rule_of(
            learner.settings,
            settings.features.reading == "one_hot",
            settings.bootstrap_at_truncation,
            settings.failed_actions,
        )

    def _inserts(self, lid: NDArray[np.int8]) -> NDArray[np.int8]:
        second = np.arange(len(lid)) >= self._scenario.trials
        turned = np.where(second, self._lid_first[-1], self._lid_first[0])
        return np.where(turned, LEFT + RIGHT - lid, lid).astype(np.int8)

    def _rngs(self, number: int) -> _Sources:
        scenario = self._scenario
        dominant = ORIENTATIONS.index(scenario.dominant)
        key = _RUNS, scenario.pretrain, dominant, number
        seed = np.random.SeedSequence(self.settings.seed, spawn_key=key)
        seeds = seed.spawn(len(_Sources._fields))
        return _Sources(*map(np.random.default_rng, seeds))

    def _drawn(self, rng: np.random.Generator) -> AnyLearnerSettings:
        return drawn_settings(self.settings.learner, self.settings.spread, rng)

    def _check_worlds(self, scenario: Scenario, settings: PopulationSettings) -> None:
        n_worlds = 2 if scenario.then_trials else 1
        check_integer("number of worlds", len(self.worlds), n_worlds, n_worlds)
        for world in self.worlds:
            known = settings.categories
            check_integer("haptic categories", world.categories, known, known)

    def _noisy(
        self, visual: NDArray[np.float64], rng: np.random.Generator
    ) -> NDArray[np.float64]:
        noise = rng.normal(0.0, self.settings.image_noise, visual.shape)
        return np.maximum(visual + noise, 0.0)

    def _scaled(self, histograms: NDArray[np.float64]) -> NDArray[np.float64]:
        return np.stack([self.generator.scaled_histogram(row) for row in histograms])
