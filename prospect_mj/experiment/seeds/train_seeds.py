"""Training several seeds at once, and summing them up."""

import warnings
from collections.abc import Callable, Collection, Iterable, Sequence
from contextlib import closing
from dataclasses import asdict, replace
from pathlib import Path

import numpy as np
import yaml

from prospect_mj.errors import RunFolderError
from prospect_mj.experiment.run import side_by_side
from prospect_mj.experiment.run.config import TrainConfig
from prospect_mj.experiment.run.environment import MakeEnvironment, make_environment
from prospect_mj.experiment.run.finishing import check_keepable
from prospect_mj.experiment.run.kept_episodes import Kept
from prospect_mj.experiment.run.side_by_side import Wanted, Warned, folder_name
from prospect_mj.experiment.seeds import seeds_folder
from prospect_mj.experiment.seeds.curves_figure import learning_curves
from prospect_mj.experiment.seeds.seeds_folder import CURVES, FIGURES, SUMMARY
from prospect_mj.experiment.seeds.seeds_progress import SeedsProgress
from prospect_mj.experiment.seeds.seeds_summary import SeedsSummary
from prospect_mj.experiment.view.run_view import RunView
from prospect_mj.locking import LockedFolder
from prospect_mj.storage import make_folder, replace_file

Say = Callable[[str], None]


def train_seeds(
    config: TrainConfig,
    seeds: Sequence[int],
    out: Path,
    jobs: int,
    make_env: MakeEnvironment = make_environment,
    say: Say = print,
    kept: Kept | None = None,
) -> SeedsSummary:
    """Bring a run of each seed to its end, and sum them up in their folder.

    What was finished is left as it is, what was stopped goes on.

    Args:
        config: the runs, their seeds apart.
        seeds: of the runs, each once.
        out: folder of their folders.
        jobs: processes.
        make_env: makes the environment.
        say: told where they are as soon as there is something to find there.
        kept: which trials of each are kept as episodes; None: none.

    Raises:
        RecordingError: if episodes of recorded physics are to be kept.
        RunFolderError: if `out` can't be had; nothing was written; or a run failed.
        ChildProcessError: if machine or physics failed in a run.
    """
    runs = [
        Wanted(out / folder_name(seed), replace(config, seed=seed), make_env, kept)
        for seed in seeds
    ]
    seeds_folder.check(out, runs)
    left = [run for run in runs if not seeds_folder.is_finished(run)]
    told = _told_at_start(left[0]) if left else set()
    make_folder(out, RunFolderError)
    with LockedFolder(out):
        if left:
            say(f"training in {out}; the same command goes on after a stop")
            _finish(left, jobs, told)
        return _sum_up(out, [RunView.read(run.path) for run in runs])


def _told_at_start(run: Wanted) -> set[Warned]:
    """What is wrong with the physics is found, and told, before anything is written."""
    with (
        warnings.catch_warnings(record=True) as caught,
        closing(run.make_env(run.config)) as env,
    ):
        check_keepable(env, run.kept)
    told = side_by_side.warned_of(caught)
    _warn(told)
    return set(told)


def _warn(told: Iterable[Warned]) -> None:
    """Tell once what several runs say alike."""
    for one in dict.fromkeys(told):
        warnings.warn(one.words, one.category, stacklevel=3)


def _finish(runs: Sequence[Wanted], jobs: int, told: Collection[Warned]) -> None:
    """Bring runs to their end; what they warn of is told, but for what was."""
    ended = []
    trials = runs[0].config.trials
    with SeedsProgress([run.path for run in runs], trials) as progress:
        for run in side_by_side.finish(runs, min(jobs, len(runs))):
            ended.append(run)
            progress.ended(run)
    _warn(one for run in ended for one in run.warned if one not in told)
    side_by_side.check_all_finished(ended)


def _sum_up(out: Path, runs: Sequence[RunView]) -> SeedsSummary:
    """Write figures and picture, but for what is there already."""
    summary, config = SeedsSummary.of(runs), runs[0].config
    n_actions = np.array([run.trials["n_actions"].to_numpy() for run in runs])
    contents = {
        SUMMARY: summary.markdown().encode(),
        FIGURES: yaml.safe_dump(asdict(summary), sort_keys=False).encode(),
        CURVES: learning_curves(n_actions, config.pretrain, config.max_actions),
    }
    for name, content in contents.items():
        path = out / name
        # The disk may be one to which nothing can be written any more.
        if not path.is_file() or path.read_bytes() != content:
            replace_file(path, content)
    return summary
