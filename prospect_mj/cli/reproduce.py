"""The command line of the paper's experiment."""

import sys
import warnings
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Annotated

import tyro
from tqdm import tqdm

from prospect_mj.agent.checks import check_integer
from prospect_mj.cli import command_line
from prospect_mj.experiment.paper.reproduce import n_steps, reproduce
from prospect_mj.experiment.paper.reproduction import ReproduceConfig
from prospect_mj.recording.recording import Recording

_MOST_JOBS = 1024


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
    """Folder with the run folders of scripts/live_runs.py, to compare with."""
    jobs: int = 2
    """Threads."""

    def __post_init__(self) -> None:
        """Refuse what can't work."""
        check_integer("jobs", self.jobs, 1, _MOST_JOBS)


def main(argv: Sequence[str] | None = None) -> int:
    """Reproduce as the command line says.

    Returns:
        The exit code; see `command_line.run`.
    """
    arguments = sys.argv[1:] if argv is None else argv
    return command_line.run(
        lambda: _reproduce(arguments),
        interrupted="interrupted: finished populations are kept",
    )


def _reproduce(argv: Sequence[str]) -> None:
    default = ReproduceOptions()
    options = command_line.parse(ReproduceOptions, argv, default, "reproduce.py")
    recording = Recording.load(options.recording)
    _warn(recording)
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
    print(f"wrote {path}")


def _warn(recording: Recording) -> None:
    """Say in a line what is not as it was when the recording was made."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        recording.warn_if_foreign()
    for warning in caught:
        print(f"warning: {warning.message}", file=sys.stderr)
