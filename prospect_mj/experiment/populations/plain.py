"""The same runs by the readable learners on recorded trials, action by action.

This is what the compiled kernels are held against: the learners, `RecordedTask`,
`Supervisor` and the rule for failed actions as everything else uses them, given the
numbers that the kernels draw.
"""

import numpy as np
from numpy.typing import NDArray

from prospect_mj.actions.action import Action
from prospect_mj.agent import Observation, Transition
from prospect_mj.agent.discovery import DiscoveryQ
from prospect_mj.agent.failed_actions import FailedActionRule
from prospect_mj.agent.features import HOLDINGS
from prospect_mj.agent.haptics import haptic_state, n_haptic
from prospect_mj.experiment.populations.population import Learned
from prospect_mj.experiment.populations.programme import Programme, Run
from prospect_mj.recording.task import RecordedTask


class _Drawn:
    """Gives out numbers that were drawn before, in place of a generator."""

    def __init__(self, draws: NDArray[np.float64]) -> None:
        self.random = iter(draws.ravel().tolist()).__next__


def learn_plainly(programme: Programme, number: int) -> Learned:
    """Let one learner of a population learn, action by action."""
    run, settings = programme.run(number), programme.settings
    done = Learned.nothing(run, settings.max_actions, n_haptic(settings.categories))
    begins = 0
    for number_of_world, world in enumerate(programme.worlds):
        task = RecordedTask(world.recording, programme.supervisor, settings.max_actions)
        trials = _PlainTrials(programme, run, number_of_world, task, done)
        ends = begins + len(world.recording.nodes.child)
        roots = run.trials.root
        for trial in np.flatnonzero((begins <= roots) & (roots < ends)):
            task.begin(int(roots[trial]) - begins)
            trials.run(int(trial))
        begins = ends
    if isinstance(run.learner, DiscoveryQ):
        done.splits[:] = run.learner.contexts.first_split
    return done


class _PlainTrials:
    """Runs trials in one of the worlds.

    Args:
        programme: of the population.
        run: the learner's.
        world: number of the world.
        task: in it.
        done: written to.
    """

    def __init__(
        self,
        programme: Programme,
        run: Run,
        world: int,
        task: RecordedTask,
        done: Learned,
    ) -> None:
        """Run nothing yet."""
        self._programme, self._run, self._task = programme, run, task
        self._world, self._done = programme.worlds[world], done

    def run(self, trial: int) -> None:
        """Let the learner learn from a trial that has begun."""
        task, run, settings = self._task, self._run, self._programme.settings
        draws, done = _Drawn(run.trials.draws[trial]), self._done
        rule = FailedActionRule(settings.failed_actions)
        seen = self._observation(trial)
        for step in range(settings.max_actions):
            holding, allowed = self._holding, self._allowed(rule, trial)
            action = run.learner.select(seen, draws, allowed).action
            done.action[trial, step] = action
            done.executed[trial, step] = task.execute(Action(action)).executed
            done.inserted[trial, step] = inserted = task.inserted
            rule.note(holding, action, self._holding, inserted)
            cut_off = step + 1 == settings.max_actions
            ends = inserted or (cut_off and not settings.bootstrap_at_truncation)
            before, seen = seen, self._observation(trial)
            allowed = self._allowed(rule, trial)
            told = Transition(before, action, -1.0, seen, ends, cut_off, allowed)
            run.learner.update(told, run.rng)
            if inserted:
                done.n_actions[trial], done.solved[trial] = step + 1, True
                return

    def _allowed(self, rule: FailedActionRule, trial: int) -> NDArray[np.bool_]:
        offered = self._programme.supervisor.choice_set(self._task.predicates, trial)
        return rule.remaining(self._holding, offered)

    @property
    def _holding(self) -> int:
        return HOLDINGS.index(self._task.holder or "none")

    def _observation(self, trial: int) -> Observation:
        """The present state, as every learner knows it."""
        trials, holding = self._run.trials, self._holding
        histogram = self._run.histograms[trials.image[trial]]
        generator, world = self._programme.generator, self._world
        category = 0 if world.category is None else world.category[self._task.node]
        return Observation(
            generator.generate(histogram, HOLDINGS[holding], int(category)),
            generator.scaled_histogram(histogram),
            haptic_state(holding, int(category), world.categories),
            int(trials.orientation[trial]),
        )
