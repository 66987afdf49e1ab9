"""The folder of a recording that grows: it survives being killed at any moment.

Every file is replaced as a whole; a damaged one is never replaced.
"""

import os
from collections.abc import Iterator
from pathlib import Path
from typing import Self

import pyarrow as pa

from prospect_mj import tables
from prospect_mj.errors import RecordingError
from prospect_mj.locking import LockedFolder
from prospect_mj.recording import files
from prospect_mj.recording import key as keys
from prospect_mj.recording.arrays import complete_depth
from prospect_mj.recording.config import Extent
from prospect_mj.recording.key import RecordingKey
from prospect_mj.recording.node_table import tabulated, tree_of
from prospect_mj.recording.tree import OutcomeTree
from prospect_mj.storage import make_folder, replace_file
from prospect_mj.task.presentation import ORIENTATIONS, Orientation


class GrowingRecording(LockedFolder):
    """A recording that is open for growth, locked for one process.

    Attributes:
        path: the folder.
        key: what the recording is of.
    """

    def __init__(self, path: Path, key: RecordingKey) -> None:
        """Use `open` instead."""
        super().__init__(path)
        self.key = key

    @classmethod
    def open(cls, path: Path, key: RecordingKey) -> Self:
        """Open a recording where its last finished work left it, or begin one.

        Args:
            path: its folder; a new or empty one begins a recording.
            key: what is to be recorded.

        Raises:
            RecordingError: if something else is there, or a recording of other physics,
                or one without states.
            FolderInUse: if another process works there.
        """
        files.check_folder(path)
        make_folder(path, RecordingError)
        folder = cls(path, key)
        with folder.closed_if_it_fails():
            folder._begin_or_check()
        return folder

    def _begin_or_check(self) -> None:
        if not (self.path / keys.NAME).exists():
            if any(not file.name.startswith(".") for file in self.path.iterdir()):
                raise RecordingError(f"{self.path} is not empty, and no recording")
            replace_file(self.path / keys.NAME, self.key.as_yaml())
        stored = RecordingKey.read(self.path)
        if (self.path / files.PACKED).exists():
            raise RecordingError(
                f"{self.path} can't grow on: it was packed without states"
            )
        changed = stored.differences(self.key)
        if changed:
            raise RecordingError(
                f"{self.path} can't grow on: {'; '.join(changed)}. Outcomes of "
                "different physics don't mix; choose another folder"
            )
        # The machine that it was begun on is not that of the present key.
        self.key = stored

    def table(self, orientation: Orientation, number: int) -> pa.Table | None:
        """The nodes of a presentation as far as its tree has grown, or None.

        Raises:
            RecordingError: if its file is damaged or belongs to another recording, or
                to another presentation.
            FolderInUse: if the folder was closed.
        """
        self.check_open()
        path = self.path / files.tree_file(orientation, number)
        return files.read(path, self.key) if os.path.lexists(path) else None

    def tree(self, orientation: Orientation, number: int) -> OutcomeTree | None:
        """The tree of a presentation as far as it has grown, or None.

        Raises:
            RecordingError, FolderInUse: as `table`.
        """
        table = self.table(orientation, number)
        return None if table is None else tree_of(table)

    def keep(self, tree: OutcomeTree) -> None:
        """Make a tree, as far as it has grown, permanent.

        Raises:
            FolderInUse: if the folder was closed.
        """
        self.check_open()
        content = tables.parquet(tabulated(tree), self.key.digest)
        replace_file(self.path / files.tree_file(*tree.name), content)

    @property
    def n_trees(self) -> int:
        """Trees that are there, complete or not."""
        return len(files.tree_files(self.path))

    def complete(self, extent: Extent) -> Iterator[pa.Table]:
        """The nodes of each tree of an extent that is complete."""
        for orientation in ORIENTATIONS:
            for number in range(extent.presentations):
                table = self.table(orientation, number)
                if table is not None and complete_depth(table) >= extent.depth:
                    yield table
