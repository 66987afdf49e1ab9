"""The folder of a reproduction: it goes on where it was stopped, and mixes nothing.

reproduction.yaml   what it is of
populations/        what the learners did (`store`), to go on from and to look into
figure_5a.png ...   with the numbers of each in figure_5a.parquet ...
report.md           what came out
"""

import os
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Self

import pyarrow as pa
import yaml

from prospect_mj import locking, tables
from prospect_mj.agent.checks import check_integer
from prospect_mj.agent.storage import replace_file, temporary
from prospect_mj.closing import Closing
from prospect_mj.errors import InvalidValue, RunFolderError
from prospect_mj.experiment.learning_curve import BLOCK
from prospect_mj.experiment.paper.scenario import PopulationSettings, Scenario
from prospect_mj.recording.config import LARGEST_SEED

NAME = "reproduction.yaml"
REPORT = "report.md"
PRETRAIN = 400
"""Trials of pretraining (Wheeler, Fagg and Grupen 2002, section 3.2)."""

_FORMAT = 1
_MOST_RUNS, _MOST_TRIALS = 20_000, 100_000
_LARGEST = 20_000_000
_FEWEST_TRIALS = PRETRAIN + 3 * BLOCK


@dataclass(frozen=True)
class ReproduceConfig:
    """Size of the reproduction."""

    runs: int = 1000
    """Learners per scenario."""
    trials: int = 1000
    """Trials of each, with a dominant hand 400 of pretraining among them."""
    ablation_runs: int = 200
    """Learners per scenario and choice in the ablation table."""
    seed: int = 0
    """Equal seeds give equal reports, wall times aside."""

    def __post_init__(self) -> None:
        """Refuse numbers that make no experiment."""
        check_integer("runs", self.runs, 2, _MOST_RUNS)
        check_integer("trials", self.trials, _FEWEST_TRIALS, _MOST_TRIALS)
        check_integer("ablation runs", self.ablation_runs, 2, _MOST_RUNS)
        check_integer("seed", self.seed, 0, LARGEST_SEED - 1)
        total = max(self.runs, self.ablation_runs) * self.trials
        if total > _LARGEST:
            raise InvalidValue("runs x trials", total, f"{_LARGEST} at most")

    @property
    def scenarios(self) -> tuple[Scenario, Scenario]:
        """Without a dominant hand, and with one."""
        return Scenario(self.trials), Scenario(self.trials, PRETRAIN)

    def populations(self, runs: int) -> tuple[PopulationSettings, PopulationSettings]:
        """The default learners for each scenario; no draw is common to both."""
        return tuple(
            PopulationSettings(runs=runs, seed=self.seed + number)
            for number in range(2)
        )


class Reproduction(Closing):
    """An open folder, locked for one process.

    Attributes:
        path: the folder.
    """

    def __init__(self, path: Path, origin: str, lock: int) -> None:
        """Use `open` instead."""
        self.path, self._origin, self._lock = path, origin, lock

    @classmethod
    def open(cls, path: Path, config: ReproduceConfig, origin: str) -> Self:
        """Begin a reproduction in a new or empty folder, or go on with it.

        Args:
            path: the folder.
            config: its size.
            origin: digest of the recording that it learns from.

        Raises:
            RunFolderError: if something else is there, or a reproduction of another
                size or from another recording.
            FolderInUse: if another process works there.
        """
        if path.exists() and not path.is_dir():
            raise RunFolderError(f"{path} is not a folder")
        try:
            path.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise RunFolderError(f"{path} can't be made: {error.strerror}") from error
        folder = cls(path, origin, locking.lock(path))
        try:
            folder._begin_or_check(config)
        except BaseException:
            folder.close()
            raise
        return folder

    def _begin_or_check(self, config: ReproduceConfig) -> None:
        wanted = {
            "prospect_mj_reproduction": _FORMAT,
            "config": asdict(config),
            "recording": self._origin,
        }
        path = self.path / NAME
        if not path.exists():
            unborn = temporary(path)
            if any(file != unborn for file in self.path.iterdir()):
                raise RunFolderError(f"{self.path} is not empty; choose another folder")
            replace_file(path, yaml.safe_dump(wanted, sort_keys=False).encode())
        found = _parsed(path)
        if found != wanted:
            differs = [name for name in wanted if found.get(name) != wanted[name]]
            raise RunFolderError(
                f"{self.path} holds another reproduction: its {', '.join(differs)} "
                "differs; choose another folder"
            )

    def write(self, name: str, content: bytes) -> None:
        """Write a file, all or nothing."""
        replace_file(self.path / name, content)

    def write_table(self, name: str, table: pa.Table) -> None:
        """Write a table as Parquet, all or nothing."""
        self.write(f"{name}.parquet", tables.parquet(table, self._origin))

    def close(self) -> None:
        """Let other processes use the folder."""
        if self._lock >= 0:
            os.close(self._lock)
            self._lock = -1


def _parsed(path: Path) -> dict[str, object]:
    try:
        content = yaml.safe_load(path.read_text(encoding="utf-8"))
    except (OSError, UnicodeDecodeError, yaml.YAMLError) as error:
        raise RunFolderError(f"{path} can't be read: it is damaged") from error
    return content if isinstance(content, dict) else {}
