"""The folder of a reproduction: it goes on where it was stopped, and mixes nothing.

reproduction.yaml   what it is of
populations/        what the learners did (`store`), to go on from and to look into
figure_5a.png ...   with the numbers of each in figure_5a.parquet ...
report.md           what came out
"""

import os
from dataclasses import asdict
from pathlib import Path
from typing import Self

import pyarrow as pa
import yaml

from prospect_mj import locking, tables
from prospect_mj.closing import Closing
from prospect_mj.errors import RunFolderError
from prospect_mj.experiment.paper.reproduce_config import ReproduceConfig
from prospect_mj.storage import replace_file, temporary

NAME = "reproduction.yaml"
REPORT = "report.md"

_FORMAT = 1
_END = "\n...\n"
"""Of a YAML document; a half-written one lacks it."""


class ReportFolder(Closing):
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
            text = yaml.safe_dump(wanted, sort_keys=False, explicit_end=True)
            replace_file(path, text.encode())
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
        text = path.read_text(encoding="utf-8")
        content = yaml.safe_load(text) if text.endswith(_END) else None
    except (OSError, UnicodeDecodeError, yaml.YAMLError):
        content = None
    if not isinstance(content, dict):
        raise RunFolderError(f"{path} can't be read: it is damaged")
    return content
