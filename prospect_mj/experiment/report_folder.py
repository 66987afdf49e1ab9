"""The folder of a report: it goes on where it was stopped, and mixes nothing.

A YAML file in it says what it is of; `report.md` is what came out. What took time to
make is kept beside them, in files that say themselves what they belong to.
"""

from collections.abc import Mapping
from dataclasses import asdict
from pathlib import Path
from typing import Any, NamedTuple, Self

import pyarrow as pa
import yaml

from prospect_mj import tables
from prospect_mj.errors import RunFolderError
from prospect_mj.locking import LockedFolder
from prospect_mj.storage import make_folder, read_yaml, replace_file, temporary

REPORT = "report.md"

_FORMAT = 1
_END = b"\n...\n"
"""Of a YAML document; a half-written one lacks it."""


class Kind(NamedTuple):
    """What a report is of."""

    word: str
    """Its name, as in `holds another reproduction`."""
    version: int = _FORMAT
    """Of its folder."""

    @property
    def file(self) -> str:
        """The file that says what the report is of."""
        return f"{self.word}.yaml"

    @property
    def mark(self) -> str:
        """By which the file is known."""
        return f"prospect_mj_{self.word}"


class ReportFolder(LockedFolder):
    """An open folder, locked for one process.

    Attributes:
        path: the folder.
    """

    def __init__(self, path: Path, kind: Kind, origin: str) -> None:
        """Use `open` instead."""
        super().__init__(path)
        self._kind, self._origin = kind, origin

    @classmethod
    def open(cls, path: Path, kind: Kind, config: object, origin: str) -> Self:
        """Begin a report in a new or empty folder, or go on with it.

        Args:
            path: the folder.
            kind: of the report.
            config: its size, a dataclass of what YAML has.
            origin: digest of the recording that it learns from.

        Raises:
            RunFolderError: if something else is there, or a report of another size or
                from another recording.
            FolderInUse: if another process works there.
        """
        make_folder(path, RunFolderError)
        folder = cls(path, kind, origin)
        with folder.closed_if_it_fails():
            folder._begin_or_check(config)
        return folder

    def _begin_or_check(self, config: object) -> None:
        wanted = {
            self._kind.mark: self._kind.version,
            "config": asdict(config),
            "recording": self._origin,
        }
        path = self.path / self._kind.file
        if not path.exists():
            unborn = temporary(path)
            if any(file != unborn for file in self.path.iterdir()):
                raise RunFolderError(f"{self.path} is not empty; choose another folder")
            text = yaml.safe_dump(wanted, sort_keys=False, explicit_end=True)
            replace_file(path, text.encode())
        found = _read(path)
        if found != wanted:
            raise RunFolderError(
                f"{self.path} holds another {self._kind.word} "
                f"({_differences(found, wanted)}); choose another folder"
            )

    def write(self, name: str, content: bytes) -> None:
        """Write a file, all or nothing; its name may be that of one in a subfolder."""
        path = self.path / name
        make_folder(path.parent, RunFolderError)
        replace_file(path, content)

    def remove(self, name: str) -> None:
        """Remove a file, if it is there."""
        (self.path / name).unlink(missing_ok=True)

    def write_table(self, name: str, table: pa.Table) -> None:
        """Write a table as Parquet, all or nothing."""
        self.write(f"{name}.parquet", tables.parquet(table, self._origin))


def _differences(found: Mapping[str, Any], wanted: Mapping[str, Any]) -> str:
    """What is not the same, in words."""
    was, now = found.get("config"), wanted["config"]
    was = was if isinstance(was, Mapping) else {}
    words = [
        f"{name.replace('_', ' ')}: {was.get(name)}, not {now.get(name)}"
        for name in {**now, **was}
        if was.get(name) != now.get(name)
    ]
    if found.get("recording") != wanted["recording"]:
        words.append("it learned from another recording")
    return ", ".join(words) or "of another version"


def _read(path: Path) -> dict[str, Any]:
    content = read_yaml(path, RunFolderError)
    if not path.read_bytes().endswith(_END):
        raise RunFolderError(f"{path} can't be read: it is damaged")
    return content
