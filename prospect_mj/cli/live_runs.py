"""The command line that makes runs on live physics, to compare recorded ones with."""

import warnings
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Annotated

import tyro
from tqdm import tqdm

from prospect_mj.cli import command_line
from prospect_mj.experiment.paper.live import live_runs
from prospect_mj.experiment.paper.live.live_runs import LiveRuns
from prospect_mj.experiment.run.side_by_side import check_all_finished
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
    total, ended = options.wanted.runs, []
    with tqdm(total=total, unit="run", dynamic_ncols=True, disable=None) as bar:
        for run in live_runs.advance(options.wanted, options.out, options.jobs):
            ended.append(run)
            bar.update()
            for words in run.warned:
                warnings.warn(f"{run.path.name}: {words}", stacklevel=2)
    check_all_finished(ended)
    print(f"{options.out}: {total} runs are finished")
