"""Writing the trials of a run that are kept as episodes.

An episode is written before its trial is committed: a kill between the two leaves one
whose trial is run again, with the same outcome.
"""

from pathlib import Path

from prospect_mj.episodes import episode_file
from prospect_mj.episodes.recorder import WatchedTask
from prospect_mj.errors import RunFolderError
from prospect_mj.experiment.run.kept_episodes import FOLDER, Kept, path_of
from prospect_mj.experiment.run.records import TrialRecord
from prospect_mj.storage import make_folder


class EpisodeKeeper:
    """Writes the episodes of a run's live task.

    Args:
        run: the run's folder.
        origin: the run's digest.
        task: where the trials happen.
        kept: which of them.
    """

    def __init__(self, run: Path, origin: str, task: WatchedTask, kept: Kept) -> None:
        """Make the folder.

        Raises:
            RunFolderError: if it can't be made.
        """
        self._run, self._origin, self._task, self._kept = run, origin, task, kept
        make_folder(run / FOLDER, RunFolderError)

    def look_at(self, trial: TrialRecord) -> None:
        """Write the trial that has just ended, if it is wanted."""
        if self._kept.wants(trial):
            path = path_of(self._run, trial.trial)
            episode_file.write(path, self._task.episode(), self._origin)
