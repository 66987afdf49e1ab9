"""A run that was never written down, and a grasp, for what is drawn of them."""

from contextlib import closing
from itertools import chain
from pathlib import Path

import numpy as np
import pytest
from ideal_env import IdealEnv

from prospect_mj.actions.action import Action
from prospect_mj.experiment.run.config import TrainConfig
from prospect_mj.experiment.run.environment import make_environment
from prospect_mj.experiment.run.records import action_table, trial_table
from prospect_mj.experiment.run.training import new_learner, train
from prospect_mj.experiment.view.run_view import RunView

CONFIG = TrainConfig(trials=230, pretrain=80, dominant="left", seed=2)


@pytest.fixture(scope="session")
def view():
    """Makes the view of a run on the ideal environment; no file is written."""

    def run(config=CONFIG):
        learner = new_learner(config)
        finished = list(train(config, IdealEnv(config, noise=0.05), learner))
        trials = trial_table([one.trial for one in finished])
        actions = action_table(list(chain(*(one.actions for one in finished))))
        return RunView(Path("runs/ideal"), config, "", learner, actions, trials)

    return run


@pytest.fixture(scope="session")
def pretrained(view):
    return view()


@pytest.fixture(scope="session")
def grasped():
    """A grasp of the lid on live physics: its outcome, and the episode."""
    with closing(make_environment(TrainConfig(trials=1))) as env:
        watched = env.watch()
        watched.reset("left", np.random.default_rng(2))
        outcome = watched.execute(Action.GRASP_LEFT)
        return outcome, watched.episode()
