"""The command line that makes runs on live physics, to compare recorded ones with."""

import warnings
from collections.abc import Sequence
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Annotated, Any

import tyro

from prospect_mj.cli import command_line
from prospect_mj.cli.output import Output
from prospect_mj.experiment.paper.live import live_runs
from prospect_mj.experiment.paper.live.live_runs import LiveRuns
from prospect_mj.experiment.run.side_by_side import Ended, check_all_finished
from prospect_mj.experiment.seeds.seeds_progress import SeedsProgress
from prospect_mj.experiment.seeds.seeds_summary import SeedFigures
from prospect_mj.experiment.view.run_view import RunView
from prospect_mj.recording.workers import Workers
from prospect_mj.sim import gl


@dataclass(frozen=True)
class LiveOptions:
    """Make runs on live physics, some minutes each.

    The same command again starts those that are not there and resumes those that were
    stopped.
    """

    out: Path = Path("runs/live")
    """Folder of the run folders."""
    wanted: Annotated[LiveRuns, tyro.conf.arg(name="")] = field(
        default_factory=LiveRuns
    )
    """The runs."""
    jobs: int = 2
    """Processes of this machine."""
    output: Annotated[Output, tyro.conf.arg(name="")] = field(default_factory=Output)
    """What is printed."""

    def __post_init__(self) -> None:
        """Refuse what can't work."""
        Workers(self.jobs)


def main(argv: Sequence[str] | None = None, prog: str = "live_runs.py") -> int:
    """Make the runs as the command line says.

    Args:
        argv: the arguments; None for those of the process.
        prog: the name in its help.

    Returns:
        The exit code; see `command_line.run`.
    """
    words = "interrupted: finished trials are kept"
    return command_line.main(_make, LiveOptions(), prog, argv, words)


def _make(options: LiveOptions) -> None:
    gl.require_gl()
    wanted, ended = options.wanted, []
    folders = wanted.folders(options.out)
    with SeedsProgress(folders, wanted.trials, "runs") as progress:
        for run in live_runs.advance(wanted, options.out, options.jobs):
            ended.append(run)
            progress.ended(run)
            for told in run.warned:
                words = f"{run.path.name}: {told.words}"
                warnings.warn(words, told.category, stacklevel=2)
    check_all_finished(ended)
    if options.output.json:
        # Reading them takes a while, and words don't need it.
        options.output.result("", _figures(options.out, ended))
    else:
        counted = "1 run is" if len(ended) == 1 else f"{len(ended)} runs are"
        print(f"{options.out}: {counted} finished")


def _figures(out: Path, ended: Sequence[Ended]) -> dict[str, Any]:
    """What each run came to."""
    runs = [RunView.read(run.path) for run in ended]
    told = [
        {"path": run.path, "trials": run.n_trials, **asdict(SeedFigures.of(run))}
        for run in runs
    ]
    return {"path": out, "runs": told}
