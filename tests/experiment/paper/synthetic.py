"""Populations made by hand, of which everything is known."""

import numpy as np

from prospect_mj.agent.haptics import LEFT, RIGHT
from prospect_mj.experiment.paper.measures.sample import Resampling, Sample
from prospect_mj.experiment.populations.population import Population
from prospect_mj.experiment.populations.scenario import Scenario
from prospect_mj.experiment.populations.strategies import Strategy

ACTIONS = np.array([2, 3, 4, 10], np.int8)
"""Actions of a trial with each strategy; what fits none is cut off here."""


def of_strategies(strategy, lid, scenario):
    """The population whose trials (runs, trials) had these strategies.

    A trial that is cut off begins with the right hand, as an optimal one does.
    """
    strategy = np.asarray(strategy, np.int8)
    solved = strategy != Strategy.OTHER
    lid = np.broadcast_to(np.asarray(lid, np.int8), strategy.shape)
    corrected = (strategy == Strategy.EARLY) | (strategy == Strategy.LATE)
    hand = np.where(corrected, LEFT + RIGHT - lid, lid).astype(np.int8)
    n_actions, splits = ACTIONS[strategy], np.full((len(lid), 3, 6), -1, np.int16)
    return Population(scenario, lid, n_actions, solved, strategy, hand, splits)


def improving(runs, scenario, seed, speed=1.0):
    """Learners whose chance of the optimal strategy rises with every trial.

    In pretraining the lid lies to the right; later the right hand is chosen less at
    first, as in the paper. Of the rest a half is cut off, and a quarter each corrected.
    """
    rng = np.random.default_rng(seed)
    trial, start = np.arange(scenario.trials), scenario.pretrain
    optimal = np.clip(speed * trial / 500, 0, 0.97)
    if start:
        optimal = np.clip(trial / 230, 0, 0.97)
        later = np.clip(0.3 + speed * (trial - start) / 500, 0, 0.97)
        optimal = np.where(trial < start, optimal, later)
    rest = (1 - optimal)[:, None] * [0.25, 0.25, 0.5]
    ends = np.cumsum(np.column_stack([optimal, rest]), axis=1)
    drawn = rng.random((runs, scenario.trials, 1))
    lid = rng.choice([LEFT, RIGHT], (runs, scenario.trials))
    lid[:, :start] = RIGHT
    return of_strategies((drawn > ends[:, :3]).sum(axis=2), lid, scenario)


def pair(runs=40, trials=1000, seed=0):
    """Both scenarios."""
    return (
        improving(runs, Scenario(trials), seed),
        improving(runs, Scenario(trials, 400), seed + 1),
    )


def sampled(baseline, dominant, seed=0):
    """Both populations with resamples of their runs."""
    rng = np.random.default_rng(seed)
    return Sample.of(baseline, dominant, Resampling.draw(len(baseline.lid), rng))
