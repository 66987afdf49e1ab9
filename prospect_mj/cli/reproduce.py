"""The command line of the paper's experiment."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Annotated

import pyarrow.parquet as pq
import tyro
from tqdm import tqdm

from prospect_mj.checks import check_integer
from prospect_mj.cli import command_line
from prospect_mj.cli.output import Output
from prospect_mj.experiment.paper.report.report import STATEMENTS
from prospect_mj.experiment.paper.reproduce import n_steps, reproduce
from prospect_mj.experiment.paper.reproduce_config import ReproduceConfig
from prospect_mj.experiment.populations.population import MOST_JOBS
from prospect_mj.recording.recording import Recording


@dataclass(frozen=True)
class ReproduceOptions:
    """Run the paper's experiment on recorded physics and write a report.

    The same command again goes on where it was stopped.
    """

    config: Annotated[ReproduceConfig, tyro.conf.arg(name="")] = field(
        default_factory=ReproduceConfig
    )
    """Size of the experiment."""
    out: Path = Path("runs/reproduce")
    """Folder of the report: new, empty, or of the same reproduction."""
    recording: Path | None = None
    """Folder of a recording. Default: the one that comes with the package."""
    live: Path | None = None
    """Folder with the run folders of prospect live-runs, to compare with."""
    jobs: int = 2
    """Threads side by side."""
    output: Annotated[Output, tyro.conf.arg(name="")] = field(default_factory=Output)
    """What is printed."""

    def __post_init__(self) -> None:
        """Refuse what can't work."""
        check_integer("jobs", self.jobs, 1, MOST_JOBS)


def main(argv: Sequence[str] | None = None, prog: str = "reproduce.py") -> int:
    """Reproduce as the command line says.

    Args:
        argv: the arguments; None for those of the process.
        prog: the name in its help.

    Returns:
        The exit code; see `command_line.run`.
    """
    words = "interrupted: finished populations are kept"
    return command_line.main(_reproduce, ReproduceOptions(), prog, argv, words)


def _reproduce(options: ReproduceOptions) -> None:
    recording = Recording.load(options.recording)
    recording.warn_if_foreign()
    with tqdm(
        total=n_steps(), unit="population", dynamic_ncols=True, disable=None
    ) as bar:
        path = reproduce(
            recording,
            options.config,
            options.out,
            options.jobs,
            options.live,
            bar.update,
        )
    options.output.result(f"wrote {path}", _figures(path))


def _figures(report: Path) -> dict[str, object]:
    """The statements of the paper beside what was measured, as they are in a table."""
    found = pq.read_table(report.parent / f"{STATEMENTS}.parquet")
    return {"report": report, "statements": found.to_pylist()}
