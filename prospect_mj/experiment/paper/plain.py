"""The same runs by the readable learner on recorded trials, action by action.

This is what the compiled kernel is held against: `LinearQ`, `StateFeatureGenerator`,
`RecordedTask` and `Supervisor` as everything else uses them, given the numbers that the
kernel draws.
"""

import time
from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from prospect_mj.actions.action import Action
from prospect_mj.agent import LinearQ
from prospect_mj.experiment.paper.population import Learned, Population, learn
from prospect_mj.experiment.paper.programme import Programme, Run
from prospect_mj.experiment.paper.scenario import PopulationSettings, Scenario
from prospect_mj.recording.recording import Recording
from prospect_mj.recording.task import RecordedTask


class Speed(NamedTuple):
    """Actions that a learner takes and learns from in a second, one after the other."""

    kernel: float
    """[1/s] compiled."""
    plain: float
    """[1/s] with NumPy alone."""


class _Drawn:
    """Gives out numbers that were drawn before, in place of a generator."""

    def __init__(self, draws: NDArray[np.float64]) -> None:
        self.random = iter(draws.ravel().tolist()).__next__


def run_population_plainly(
    recording: Recording,
    scenario: Scenario,
    settings: PopulationSettings | None = None,
) -> Population:
    """What `run_population` finds, much more slowly."""
    settings = PopulationSettings() if settings is None else settings
    programme = Programme(recording, scenario, settings)
    numbers = range(settings.runs)
    return Population.of(scenario, [learn_plainly(programme, k).row for k in numbers])


def learn_plainly(programme: Programme, number: int) -> Learned:
    """Let one learner of a population learn, action by action."""
    run, settings = programme.run(number), programme.settings
    learner = LinearQ(settings.learner)
    learner.weights[:] = run.weights
    task = RecordedTask(programme.recording, programme.supervisor, settings.max_actions)
    done = Learned.nothing(run.lid, settings.max_actions, learner.weights)
    for trial in range(len(run.lid)):
        task.begin(int(run.trials.root[trial]))
        _run_trial(programme, run, learner, task, trial, done)
    return done


def _run_trial(
    programme: Programme,
    run: Run,
    learner: LinearQ,
    task: RecordedTask,
    trial: int,
    done: Learned,
) -> None:
    settings, supervisor = programme.settings, programme.supervisor
    rng = _Drawn(run.trials.draws[trial])
    counts = run.counts[run.trials.image[trial]]
    features = programme.generator.generate(counts, task.holder or "none")
    allowed = supervisor.choice_set(task.predicates, trial)
    for step in range(settings.max_actions):
        action = learner.select(features, rng, allowed)
        outcome = task.execute(Action(action))
        next_features = programme.generator.generate(counts, task.holder or "none")
        allowed = supervisor.choice_set(task.predicates, trial)
        cut_off = step + 1 == settings.max_actions
        ends = cut_off and not settings.bootstrap_at_truncation
        terminated = task.inserted or ends
        learner.update(features, action, -1.0, next_features, terminated, allowed)
        features = next_features
        done.action[trial, step] = action
        done.executed[trial, step] = outcome.executed
        done.inserted[trial, step] = task.inserted
        if task.inserted:
            done.n_actions[trial], done.solved[trial] = step + 1, True
            return


def measured_speed(
    recording: Recording,
    scenario: Scenario,
    settings: PopulationSettings | None = None,
    runs: int = 20,
) -> Speed:
    """How fast both learn the same, in this process, on one thread.

    Args:
        recording: where outcomes and histograms come from.
        scenario: what the trials present.
        settings: of the population.
        runs: learners that the compiled kernel is timed by; the plain one is by the
            first of them.
    """
    settings = PopulationSettings() if settings is None else settings
    programme = Programme(recording, scenario, settings)
    learn(programme, 0)  # Compiled, or read from the cache, before it is timed.
    kernel = _rate(lambda number: learn(programme, number), runs)
    return Speed(kernel, _rate(lambda number: learn_plainly(programme, number), 1))


def _rate(learns: Callable[[int], Learned], runs: int) -> float:
    """Actions per second of wall time."""
    began = time.perf_counter()
    n_actions = sum(int(learns(number).n_actions.sum()) for number in range(runs))
    return n_actions / (time.perf_counter() - began)
