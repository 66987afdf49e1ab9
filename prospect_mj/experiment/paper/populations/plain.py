"""The same runs by the readable learner on recorded trials, action by action.

This is what the compiled kernel is held against: `LinearQ`, `StateFeatureGenerator`,
`RecordedTask` and `Supervisor` as everything else uses them, given the numbers that the
kernel draws.
"""

import numpy as np
from numpy.typing import NDArray

from prospect_mj.actions.action import Action
from prospect_mj.agent import LinearQ
from prospect_mj.experiment.paper.populations.population import Learned
from prospect_mj.experiment.paper.populations.programme import Programme, Run
from prospect_mj.recording.task import RecordedTask


class _Drawn:
    """Gives out numbers that were drawn before, in place of a generator."""

    def __init__(self, draws: NDArray[np.float64]) -> None:
        self.random = iter(draws.ravel().tolist()).__next__


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
    histogram = run.histograms[run.trials.image[trial]]
    features = programme.generator.generate(histogram, task.holder or "none")
    allowed = supervisor.choice_set(task.predicates, trial)
    for step in range(settings.max_actions):
        action = learner.select(features, rng, allowed)
        outcome = task.execute(Action(action))
        next_features = programme.generator.generate(histogram, task.holder or "none")
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
