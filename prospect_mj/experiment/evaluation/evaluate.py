"""The greedy policy of a run on fresh presentations.

Greedy: no exploration and no learning; ties between equal values are broken as in
training.
"""

from collections.abc import Callable, Iterator
from contextlib import closing
from dataclasses import replace
from pathlib import Path

from prospect_mj.agent import Learner, new_learner
from prospect_mj.agent.failed_actions import FailedActionRule
from prospect_mj.experiment.evaluation import places
from prospect_mj.experiment.evaluation.evaluation_folder import (
    EvaluationFolder,
    is_begun,
)
from prospect_mj.experiment.run import trial_loop
from prospect_mj.experiment.run.environment import (
    Environment,
    MakeEnvironment,
    make_environment,
)
from prospect_mj.experiment.run.finishing import check_keepable, keeper_of, work_off
from prospect_mj.experiment.run.kept_episodes import Kept
from prospect_mj.experiment.run.trial_loop import FinishedTrial, Presented
from prospect_mj.experiment.view import evaluation_file
from prospect_mj.experiment.view.evaluation_file import Learned, StoredEvaluation
from prospect_mj.experiment.view.evaluation_settings import EvaluationSettings
from prospect_mj.experiment.view.run_view import RunView

Say = Callable[[str], None]


def evaluate(
    run: RunView,
    settings: EvaluationSettings,
    out: Path | None = None,
    make_env: MakeEnvironment = make_environment,
    say: Say = print,
    kept: Kept | None = None,
) -> RunView:
    """Evaluate a run, or go on with an evaluation that was stopped.

    Args:
        run: the run, as far as it has come.
        settings: of the evaluation.
        out: its folder; None for one in that of the run.
        make_env: makes the environment.
        say: told where it is as soon as there is something to find there.
        kept: which trials are kept as episodes; None: none.

    Returns:
        The finished evaluation.

    Raises:
        RunFolderError: if `run` is no run, or `out` can't be had; nothing was written.
        RecordingError: if episodes of recorded physics are to be kept; the same.
    """
    run.check_is_run()
    config = settings.config(run.config)
    learned = Learned(run.origin, run.n_trials)
    wanted = evaluation_file.present(config, settings, learned)
    path = places.place(run.path, wanted, out)
    if is_begun(path):
        _go_on(path, make_env, say, kept)
    else:
        with closing(make_env(config)) as env:
            check_keepable(env, kept)
            with EvaluationFolder.create(path, wanted, run.learner) as folder:
                _finish(folder, env, say, kept)
    return RunView.read(path)


def policy(learner: Learner) -> Learner:
    """The same learner without exploration."""
    greedy = new_learner(replace(learner.settings, epsilon=0.0))
    greedy.restore(learner.state())
    return greedy


def trials(
    evaluation: StoredEvaluation, env: Environment, learner: Learner, first: int = 0
) -> Iterator[FinishedTrial]:
    """Run the trials of an evaluation from a number on, each as it is asked for.

    Args:
        evaluation: what it is.
        env: where the actions happen.
        learner: what is evaluated.
        first: number of the first trial.
    """
    settings, greedy = evaluation.settings, policy(learner)
    failed_actions = evaluation.config.failed_actions
    for trial in range(first, settings.n_trials):
        presented = Presented(
            trial,
            settings.orientation(trial),
            settings.presentation_seed(trial),
            # A shaping schedule stays where the training had come to.
            counted_as=evaluation.learned.trials,
        )
        rule, rng = FailedActionRule(failed_actions), settings.policy_rng(trial)
        yield trial_loop.run(env, presented, greedy, rng, rule)


def _go_on(path: Path, make_env: MakeEnvironment, say: Say, kept: Kept | None) -> None:
    with EvaluationFolder.open(path) as folder:
        if folder.n_trials == folder.evaluation.settings.n_trials:
            say(f"{path} is finished")
            return
        with closing(make_env(folder.evaluation.config)) as env:
            _finish(folder, env, say, kept)


def _finish(
    folder: EvaluationFolder, env: Environment, say: Say, kept: Kept | None
) -> None:
    """Run what is left."""
    evaluation, first = folder.evaluation, folder.n_trials
    told = f"at trial {first}" if first else "the same command goes on after a stop"
    say(f"evaluating in {folder.path}; {told}")
    left = trials(evaluation, env, folder.state.learner, first)
    keeper = keeper_of(folder, env, kept)
    work_off(left, folder, evaluation.settings.n_trials, keeper)
