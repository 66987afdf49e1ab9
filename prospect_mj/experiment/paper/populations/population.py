"""Many runs of the learner on recorded physics, by the compiled kernel."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple, Self

import numpy as np
from joblib import Parallel, delayed
from numpy.typing import NDArray

from prospect_mj.checks import check_integer
from prospect_mj.experiment.paper.populations import compiled_learner
from prospect_mj.experiment.paper.populations.kernel import Graph, Outcomes, Trials
from prospect_mj.experiment.paper.populations.programme import Programme
from prospect_mj.experiment.paper.populations.scenario import (
    PopulationSettings,
    Scenario,
)
from prospect_mj.experiment.paper.populations.strategies import classify, first_hand
from prospect_mj.recording.recording import Recording

MOST_JOBS = 1024
"""Threads that may be asked for."""


@dataclass(frozen=True)
class Population:
    """What all learners did in all trials."""

    scenario: Scenario
    """What was presented."""
    lid: NDArray[np.int8]
    """(runs, trials): side of the lid, LEFT or RIGHT."""
    n_actions: NDArray[np.int8]
    """(runs, trials) [actions], all that a trial may have where it was not solved."""
    solved: NDArray[np.bool_]
    """(runs, trials): whether the jar was inserted."""
    strategy: NDArray[np.int8]
    """(runs, trials): numbers of `Strategy`."""
    first_hand: NDArray[np.int8]
    """(runs, trials): hand of the first executed grasp, LEFT or RIGHT; NONE where there
    was no grasp."""

    @classmethod
    def of(cls, scenario: Scenario, rows: Sequence[tuple[NDArray, ...]]) -> Self:
        """Put all runs together, each as `Learned.row` has it."""
        return cls(scenario, *map(np.stack, zip(*rows, strict=True)))


class Learned(NamedTuple):
    """One run of the learner, when it has ended; false or -1 after a trial's end."""

    lid: NDArray[np.int8]
    """(n_trials,), side of the lid, LEFT or RIGHT."""
    n_actions: NDArray[np.int8]
    """(n_trials,) [actions], all that a trial may have where it was not solved."""
    solved: NDArray[np.bool_]
    """(n_trials,): whether the jar was inserted."""
    action: NDArray[np.int8]
    """(n_trials, max_actions): the action taken."""
    executed: NDArray[np.bool_]
    """(n_trials, max_actions): whether it was run."""
    inserted: NDArray[np.bool_]
    """(n_trials, max_actions): whether it left the jar in the receptacle."""
    weights: NDArray[np.float64]
    """(6, 303) at the end."""

    @classmethod
    def nothing(
        cls, lid: NDArray[np.int8], max_actions: int, weights: NDArray[np.float64]
    ) -> Self:
        """A run before its first trial."""
        shape = len(lid), max_actions
        n_actions = np.full(len(lid), max_actions, np.int8)
        solved, action = np.zeros(len(lid), np.bool_), np.full(shape, -1, np.int8)
        executed, inserted = np.zeros((2, *shape), np.bool_)
        return cls(lid, n_actions, solved, action, executed, inserted, weights)

    @property
    def row(self) -> tuple[NDArray, ...]:
        """What a `Population` keeps of it, each (n_trials,), in the same order."""
        strategy = classify(self.lid, self.action, self.executed, self.inserted)
        hand = first_hand(self.action, self.executed)
        return self.lid, self.n_actions, self.solved, strategy, hand


def run_population(
    recording: Recording,
    scenario: Scenario,
    settings: PopulationSettings | None = None,
    jobs: int = 1,
) -> Population:
    """Let a population learn.

    Args:
        recording: where outcomes and histograms come from.
        scenario: what the trials present.
        settings: of the population.
        jobs: threads; the result doesn't depend on their number.

    Raises:
        RecordingError: if the recording has too few complete presentations.
        InvalidValue: if a learner diverges.
    """
    check_integer("jobs", jobs, 1, MOST_JOBS)
    settings = PopulationSettings() if settings is None else settings
    programme = Programme(recording, scenario, settings)
    rows = Parallel(n_jobs=jobs, prefer="threads")(
        delayed(_row)(programme, number) for number in range(settings.runs)
    )
    return Population.of(scenario, rows)


def learn(programme: Programme, number: int) -> Learned:
    """Let one learner of a population learn."""
    run, settings = programme.run(number), programme.settings
    outcomes = compiled_learner.run_trials(
        run.weights,
        programme.graph,
        run.trials,
        settings.learner,
        settings.features.reading == "one_hot",
        settings.bootstrap_at_truncation,
    )
    return Learned(
        run.lid,
        outcomes.n_actions,
        outcomes.solved,
        outcomes.action,
        *_what_ran(programme.graph, run.trials, outcomes),
        run.weights,
    )


def _row(programme: Programme, number: int) -> tuple[NDArray, ...]:
    return learn(programme, number).row


def _what_ran(
    graph: Graph, trials: Trials, outcomes: Outcomes
) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
    """(n_trials, max_actions) twice: was an action run, did it insert the jar."""
    led_to = outcomes.node
    before = np.column_stack([trials.root, graph.situation[led_to[:, :-1]]])
    # In the node of an action that found nothing to do the trial does not stay.
    executed = (led_to >= 0) & (led_to != before) & (graph.situation[led_to] == led_to)
    return executed, executed & graph.inserted[led_to]
