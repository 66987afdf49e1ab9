"""Populations of which every trial's strategy is made by hand."""

import numpy as np

from prospect_mj.agent.haptics import LEFT, RIGHT
from prospect_mj.experiment.populations.population import Population
from prospect_mj.experiment.populations.scenario import Scenario
from prospect_mj.experiment.populations.strategies import Strategy

B, E, L, X = Strategy.OPTIMAL, Strategy.EARLY, Strategy.LATE, Strategy.OTHER


def population(difficult, easy=None, pretrain=10):
    """Runs of blocks in which five trials are difficult and five easy, in turn.

    Args:
        difficult: for each run, five strategies for each block.
        easy: the same of easy trials; None: all optimal.
        pretrain: easy trials before that, all optimal.
    """
    difficult = np.array(difficult, np.int8)
    easy = np.full_like(difficult, B) if easy is None else np.array(easy, np.int8)
    runs, blocks, _ = difficult.shape
    mixed = np.stack([difficult, easy], axis=-1).reshape(runs, blocks * 10)
    before = np.full((runs, pretrain), B, np.int8)
    strategy = np.concatenate([before, mixed], axis=1)
    lid = np.full(strategy.shape, RIGHT, np.int8)
    lid[:, pretrain::2] = LEFT
    scenario = Scenario(trials=strategy.shape[1], pretrain=pretrain)
    return Population(
        scenario,
        lid,
        np.full(strategy.shape, 2, np.int8),
        strategy != X,
        strategy,
        np.full(strategy.shape, RIGHT, np.int8),
        np.full((runs, 3, 6), -1, np.int16),
    )
