"""The command line of the study of development."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Annotated

import pyarrow.parquet as pq
import tyro

from prospect_mj.checks import check_integer
from prospect_mj.cli import command_line
from prospect_mj.cli.output import Output
from prospect_mj.experiment.development.development import develop
from prospect_mj.experiment.development.study.recordings import Recordings
from prospect_mj.experiment.development.study.settings import Extent, StudySettings
from prospect_mj.experiment.development.study.tables import MEASURED
from prospect_mj.experiment.populations.population import MOST_JOBS


@dataclass(frozen=True)
class DevelopmentOptions:
    """Study on recorded physics which learners develop as infants do; write a report.

    The same command again goes on where it was stopped.
    """

    config: Annotated[StudySettings, tyro.conf.arg(name="")] = field(
        default_factory=StudySettings
    )
    """Size of the study."""
    extent: Annotated[Extent, tyro.conf.arg(name="")] = field(default_factory=Extent)
    """Parts of it."""
    out: Path = Path("runs/development")
    """Folder of the report: new, empty, or of the same study."""
    recording: Path | None = None
    """Folder of the standard world's recording. Default: the one that comes with the
    package."""
    recordings: Path | None = None
    """Folder with the recordings of other worlds, each in a folder with its world's
    name. Default: those that come with the package."""
    jobs: int = 2
    """Threads, and processes, side by side."""
    output: Annotated[Output, tyro.conf.arg(name="")] = field(default_factory=Output)
    """What is printed."""

    def __post_init__(self) -> None:
        """Refuse what can't work."""
        check_integer("jobs", self.jobs, 1, MOST_JOBS)


def main(argv: Sequence[str] | None = None, prog: str = "development.py") -> int:
    """Study as the command line says.

    Args:
        argv: the arguments; None for those of the process.
        prog: the name in its help.

    Returns:
        The exit code; see `command_line.run`.
    """
    words = "interrupted: what was finished is kept"
    return command_line.main(_develop, DevelopmentOptions(), prog, argv, words)


def _develop(options: DevelopmentOptions) -> None:
    worlds = options.extent.all_worlds
    recordings = Recordings.load(worlds, options.recording, options.recordings)
    for recording in recordings.by_world.values():
        recording.warn_if_foreign()
    path = develop(
        options.out,
        options.config,
        options.extent,
        recordings,
        options.jobs,
        options.output.say,
    )
    options.output.result(f"wrote {path}", _figures(path))


def _figures(report: Path) -> dict[str, object]:
    """What was measured, as it is in a table."""
    found = report.parent / "tables" / f"{MEASURED}.parquet"
    rows = pq.read_table(found).to_pylist() if found.exists() else []
    return {"report": report, "measured": rows}
