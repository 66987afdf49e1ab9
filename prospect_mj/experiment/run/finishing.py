"""Working off trials: each is kept, if it is wanted, and made permanent as it ends."""

from collections.abc import Iterable
from pathlib import Path
from typing import Protocol

from prospect_mj.experiment.run.environment import Environment
from prospect_mj.experiment.run.kept_episodes import Kept
from prospect_mj.experiment.run.progress import Progress, Trials
from prospect_mj.experiment.run.records import TrialRecord
from prospect_mj.experiment.run.trial_loop import FinishedTrial


class TrialFolder(Trials, Protocol):
    """A folder whose trials become more."""

    path: Path

    @property
    def origin(self) -> str:
        """Digest that marks its files."""
        ...

    def commit(self, finished: FinishedTrial) -> None:
        """Make a finished trial permanent."""
        ...


class Keeper(Protocol):
    """What keeps episodes; see `episode_keeper`."""

    def look_at(self, trial: TrialRecord) -> None:
        """Write the trial that has just ended, if it is wanted."""
        ...


def check_keepable(env: Environment, kept: Kept | None) -> None:
    """Refuse to keep episodes of what can't be seen, before there is a folder.

    Raises:
        RecordingError: on recorded physics.
    """
    if kept is not None:
        env.watch()


def keeper_of(
    folder: TrialFolder, env: Environment, kept: Kept | None
) -> Keeper | None:
    """What keeps the trials that are wanted.

    Args:
        folder: where they go.
        env: where they happen.
        kept: which of them; None: none.

    Raises:
        RecordingError: on recorded physics.
        RunFolderError: if there can be no folder for them.
    """
    if kept is None:
        return None
    # Where nothing is to be seen, nothing of MuJoCo is loaded.
    from prospect_mj.experiment.run.episode_keeper import EpisodeKeeper

    return EpisodeKeeper(folder.path, folder.origin, env.watch(), kept)


def work_off(
    trials: Iterable[FinishedTrial],
    folder: TrialFolder,
    total: int,
    keeper: Keeper | None,
) -> None:
    """Run the trials that are left, and tell how far they are.

    Args:
        trials: those that are left, run as they are asked for.
        folder: where they go.
        total: how many it has in the end.
        keeper: keeps some of them as episodes.
    """
    with Progress(folder, total) as progress:
        for finished in trials:
            if keeper is not None:
                keeper.look_at(finished.trial)
            folder.commit(finished)
            progress.advance()
