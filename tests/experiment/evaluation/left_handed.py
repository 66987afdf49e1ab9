"""A run whose learner knows one thing: grasp left, then insert left."""

from ideal_env import IdealEnv

from prospect_mj.agent import LinearSettings
from prospect_mj.experiment.run.config import TrainConfig
from prospect_mj.experiment.run.run_folder import RunFolder
from prospect_mj.experiment.run.training import train
from prospect_mj.experiment.view.run_view import RunView

GRASP_LEFT, INSERT_LEFT = 0, 4
# Every choice in its trials is a random one, and it can't learn to speak of.
LEARNER = LinearSettings(epsilon=1.0, step_size=1e-9, initial_sd=0.0)


def left_handed(path, trials=2, make_env=IdealEnv, **settings):
    """The view of a run whose greedy policy solves just what has the lid on the left.

    Its last two features but one say which hand holds the jar; the last one is 1.
    """
    config = TrainConfig(trials=trials, seed=3, learner=LEARNER, **settings)
    with RunFolder.create(path, config) as folder:
        folder.learner.weights[:, -1] = -9
        folder.learner.weights[GRASP_LEFT, -1] = 0
        folder.learner.weights[INSERT_LEFT, -3:] = 2, 0, -1
        learn(folder, make_env(config))
    return RunView.read(path)


def learn(folder, env):
    for finished in train(folder.config, env, folder.learner, folder.n_trials):
        folder.commit(finished)


def go_on(path, trials):
    """Give the run more trials."""
    with RunFolder.open(path) as folder:
        folder.extend(folder.config.with_trials(trials))
        learn(folder, IdealEnv(folder.config))
    return RunView.read(path)
