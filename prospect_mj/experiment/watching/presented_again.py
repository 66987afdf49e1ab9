"""The presentation of a trial of a run once more, on live physics.

A run of live physics drew it by a seed of the trial's own. A run of recorded physics
drew by that seed the number of a presentation; what that one looks like follows from
the recording's seed and this number.
"""

from contextlib import ExitStack

import numpy as np

from prospect_mj.episodes.recorder import WatchedTask
from prospect_mj.errors import RunFolderError
from prospect_mj.experiment.run import fingerprint
from prospect_mj.experiment.run.environment import make_environment
from prospect_mj.experiment.view.run_view import RunView
from prospect_mj.recording.grower import presentation_rng, task_settings
from prospect_mj.recording.key import RecordingKey
from prospect_mj.recording.presenter import GrowingPresenter, Presenter
from prospect_mj.task.pick_place import PickPlaceTask
from prospect_mj.task.presentation import Orientation


def present_again(run: RunView, trial: int, orientation: Orientation) -> WatchedTask:
    """Show what a trial of a run showed; the caller closes the task.

    Args:
        run: the run, or an evaluation.
        trial: its number.
        orientation: the side on which the lid lay.

    Raises:
        RunFolderError, RecordingError: as `drawn_presentation`.
    """
    if run.config.physics == "recorded":
        return _recorded(run, trial, orientation)
    env = make_environment(run.config)
    with ExitStack() as failing:
        failing.callback(env.close)
        watched = env.watch()
        options = {"orientation": orientation, "trial": trial}
        env.reset(seed=run.presentation_seed(trial), options=options)
        failing.pop_all()
    return watched


def _recorded(run: RunView, trial: int, orientation: Orientation) -> WatchedTask:
    config = RecordingKey.read(run.config.recording_folder).config
    number = drawn_presentation(run, trial, orientation)
    watched = WatchedTask(PickPlaceTask(task_settings(config)))
    with ExitStack() as failing:
        failing.callback(watched.close)
        watched.reset(orientation, presentation_rng(config, orientation, number))
        failing.pop_all()
    return watched


def drawn_presentation(run: RunView, trial: int, orientation: Orientation) -> int:
    """Number of the recorded presentation that a trial drew.

    Args:
        run: a run of recorded physics.
        trial: its number.
        orientation: the side on which the lid lay.

    Raises:
        RunFolderError: if the recording grew so that another one would be drawn.
        RecordingError: if it is gone or damaged.
    """
    # Gymnasium seeds an environment's generator in the same way.
    rng = np.random.default_rng(run.presentation_seed(trial))
    if run.config.grow:
        _check_draws_alike(run)
        return GrowingPresenter(run.config.recording_folder).draw(rng)
    recording = run.recording
    drawn = Presenter(recording, run.config.max_actions).draw(orientation, rng)
    return int(recording.presentations.number[drawn])


def _check_draws_alike(run: RunView) -> None:
    """Refuse to show something else; the outcomes alone might not tell."""
    if fingerprint.PRESENTATIONS in run.outdated():
        raise RunFolderError(
            f"{run.path}: what its trials showed can't be presented again; changed "
            f"since: {fingerprint.PRESENTATIONS}"
        )
