"""Runs on live physics, to be compared with recorded ones."""

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from prospect_mj.checks import check_integer
from prospect_mj.errors import RunFolderError
from prospect_mj.experiment.paper.live.live_check import EXPECTED
from prospect_mj.experiment.run import side_by_side
from prospect_mj.experiment.run.config import TrainConfig
from prospect_mj.experiment.run.environment import MakeEnvironment, make_environment
from prospect_mj.experiment.run.side_by_side import Ended, Wanted, folder_name
from prospect_mj.storage import make_folder


@dataclass(frozen=True)
class LiveRuns:
    """Which runs there are to be."""

    runs: int = EXPECTED
    """Runs; each has its number as its seed."""
    trials: int = 1000
    """Trials per run, without a dominant hand."""

    def __post_init__(self) -> None:
        """Refuse numbers that make no runs."""
        check_integer("runs", self.runs, 1, 100_000)
        TrainConfig(trials=self.trials)

    def config(self, number: int) -> TrainConfig:
        """The settings of one of the runs."""
        return TrainConfig(trials=self.trials, seed=number)

    def folders(self, out: Path) -> list[Path]:
        """Those of the runs, in the folder of them all."""
        return [out / folder_name(number) for number in range(self.runs)]


def advance(
    wanted: LiveRuns,
    out: Path,
    jobs: int,
    make_env: MakeEnvironment = make_environment,
) -> Iterator[Ended]:
    """Bring every run to its end; a killed process loses no finished trial.

    Args:
        wanted: the runs.
        out: folder of their folders.
        jobs: processes.
        make_env: makes the environment.

    Yields:
        Each run, as it ends. One that fails keeps no other from its end.

    Raises:
        RunFolderError: if `out` is no folder and can't become one.
    """
    make_folder(out, RunFolderError)
    runs = [
        Wanted(path, wanted.config(number), make_env)
        for number, path in enumerate(wanted.folders(out))
    ]
    yield from side_by_side.finish(runs, jobs)
