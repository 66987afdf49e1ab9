"""The presentation of a trial of a run once more, on live physics.

A run of live physics drew it by a seed of the trial's own. A run of recorded physics
drew by that seed the number of a presentation; what that one looks like follows from
the recording's seed and this number.
"""

from pathlib import Path

import numpy as np

from prospect_mj import paths
from prospect_mj.episodes.recorder import WatchedTask
from prospect_mj.experiment.run.environment import make_environment
from prospect_mj.experiment.view.run_view import RunView
from prospect_mj.recording import files
from prospect_mj.recording.config import Extent
from prospect_mj.recording.grower import presentation_rng, task_settings
from prospect_mj.recording.key import RecordingKey
from prospect_mj.recording.presenter import Presenter
from prospect_mj.recording.recording import Recording
from prospect_mj.task.pick_place import PickPlaceTask
from prospect_mj.task.presentation import Orientation


def present_again(run: RunView, trial: int, orientation: Orientation) -> WatchedTask:
    """Show what a trial of a run showed; the caller closes the task.

    Args:
        run: the run, or an evaluation.
        trial: its number.
        orientation: the side on which the lid lay.

    Raises:
        RecordingError: if the run's recording is gone or damaged.
    """
    if run.config.physics == "recorded":
        return _recorded(run, trial, orientation)
    env = make_environment(run.config)
    watched = env.watch()
    options = {"orientation": orientation, "trial": trial}
    env.reset(seed=run.presentation_seed(trial), options=options)
    return watched


def recording_of(run: RunView) -> Path:
    """Folder of the recording that a run learned from."""
    chosen = run.config.recording
    return paths.RECORDING if chosen is None else Path(chosen)


def _recorded(run: RunView, trial: int, orientation: Orientation) -> WatchedTask:
    config = RecordingKey.read(recording_of(run)).config
    number = drawn_presentation(run, trial, orientation)
    watched = WatchedTask(PickPlaceTask(task_settings(config)))
    watched.reset(orientation, presentation_rng(config, orientation, number))
    return watched


def drawn_presentation(run: RunView, trial: int, orientation: Orientation) -> int:
    """Number of the recorded presentation that a trial drew.

    Args:
        run: a run of recorded physics.
        trial: its number.
        orientation: the side on which the lid lay.
    """
    # Gymnasium seeds an environment's generator in the same way.
    rng = np.random.default_rng(run.presentation_seed(trial))
    folder = recording_of(run)
    if run.config.grow:
        n_presentations = max(Extent.presentations, files.n_presentations(folder))
        return int(rng.integers(n_presentations))
    recording = Recording.load(folder)
    drawn = Presenter(recording, run.config.max_actions).draw(orientation, rng)
    return int(recording.presentations.number[drawn])
