"""A recording to hand on: complete trees in one file, without their states."""

import contextlib
import errno
from collections.abc import Iterable
from pathlib import Path
from typing import Self

import pyarrow as pa

from prospect_mj import tables
from prospect_mj.errors import RecordingError
from prospect_mj.locking import LockedFolder
from prospect_mj.recording import files
from prospect_mj.recording import key as keys
from prospect_mj.recording.key import RecordingKey
from prospect_mj.recording.schema import OUTCOMES, SCHEMA
from prospect_mj.storage import make_folder, replace_file, temporary

_WHOLE = (Path(files.PACKED), Path(keys.NAME))
_NAMES = (*_WHOLE, *map(temporary, _WHOLE))
"""What there can be in a folder that is packed into, sooner or later."""


class Packing(LockedFolder):
    """A folder that becomes a packed recording, all at once or not at all.

    Until then it has another name, so that nothing can be taken for a whole recording
    that is none. What a kill leaves under that name, the next one takes over.

    Attributes:
        path: what it is called until it is whole.
        target: what it is called then.
    """

    def __init__(self, target: Path) -> None:
        """Use `open` instead."""
        super().__init__(temporary(target))
        self.target = target

    @classmethod
    def open(cls, target: Path, growing: Path) -> Self:
        """Take the place before anything grows, so that hours later it is there.

        Args:
            target: the folder to pack into: new or empty.
            growing: folder of what is to be packed.

        Raises:
            RecordingError: if something is there, or will be, or nothing can be.
            FolderInUse: if another process is to pack there.
        """
        check_free(target, growing)
        # A folder can't take the place of a link.
        target = target.resolve()
        make_folder(temporary(target), RecordingError)
        packing = cls(target)
        with packing.closed_if_it_fails():
            packing._clear()
        return packing

    def _clear(self) -> None:
        """Delete what was left by a kill, and touch nothing else."""
        for name in _NAMES:
            (self.path / name).unlink(missing_ok=True)
        if any(self.path.iterdir()):
            raise RecordingError(f"{self.path} is in the way of packing")

    def write(self, parts: Iterable[pa.Table], key: RecordingKey) -> int:
        """Write trees without their states, to be stepped but not grown.

        Args:
            parts: a table for each of the trees.
            key: what they are of.

        Returns:
            Number of trees.

        Raises:
            RecordingError: if there is no tree, or something came into its place.
        """
        self.check_open()
        stripped = [_without_states(part) for part in parts]
        if not stripped:
            raise RecordingError("there is no complete tree to pack")
        table = pa.concat_tables(stripped).combine_chunks()
        content = tables.parquet(table, key.digest, compression="zstd")
        replace_file(self.path / files.PACKED, content)
        replace_file(self.path / keys.NAME, key.as_yaml())
        self._take_place()
        return len(stripped)

    def _take_place(self) -> None:
        try:
            self.path.rename(self.target)
        except OSError as error:
            if error.errno in (errno.ENOTEMPTY, errno.EEXIST, errno.ENOTDIR):
                raise _occupied(self.target) from error
            raise
        self.path = self.target

    def close(self) -> None:
        """Leave nothing behind that is not whole."""
        if self._descriptor >= 0 and self.path != self.target:
            with contextlib.suppress(OSError, RecordingError):
                self._clear()
                self.path.rmdir()
        super().close()


def check_free(target: Path, growing: Path) -> None:
    """Refuse a folder that can't be packed into.

    Args:
        target: the folder.
        growing: folder of what is to be packed.

    Raises:
        RecordingError: if something is there, or will be, or one is in the other.
    """
    files.check_folder(target)
    place, grown = target.resolve(), growing.resolve()
    if grown.is_relative_to(place) or place.is_relative_to(grown):
        words = "can't be packed into: the recording grows in it, or around it"
        raise RecordingError(f"{target} {words}")
    if target.exists() and any(target.iterdir()):
        raise _occupied(target)


def _occupied(target: Path) -> RecordingError:
    return RecordingError(f"{target} is not empty; pack into a new folder")


def _without_states(part: pa.Table) -> pa.Table:
    states = pa.nulls(part.num_rows, SCHEMA.field("state").type)
    return part.select(OUTCOMES).append_column(SCHEMA.field("state"), states)
