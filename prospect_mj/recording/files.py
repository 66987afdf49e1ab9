"""The files of a recording.

recording.yaml       what the recording is of (`recording.key`)
left-0000.parquet    one tree each, with the states to grow it on
...
trees.parquet        many trees without states, in place of these
"""

import re
from pathlib import Path

import pyarrow as pa
from pyarrow.lib import ArrowException

from prospect_mj import tables
from prospect_mj.errors import ForeignTable, RecordingError
from prospect_mj.recording.key import RecordingKey
from prospect_mj.recording.schema import SCHEMA
from prospect_mj.task.presentation import ORIENTATIONS

PACKED = "trees.parquet"
_TREE_FILE = re.compile(rf"({'|'.join(ORIENTATIONS)})-(\d{{4,}})\.parquet")


def tree_file(orientation: str, number: int) -> str:
    """Name of the file of one tree."""
    return f"{orientation}-{number:04d}.parquet"


def tree_files(folder: Path) -> list[Path]:
    """The tables of a recording, in the order in which trees are counted.

    Raises:
        RecordingError: if the same trees may be there twice.
    """
    found = {path: _TREE_FILE.fullmatch(path.name) for path in folder.iterdir()}
    named = {path: (m[1], int(m[2])) for path, m in found.items() if m is not None}
    single = sorted(named, key=named.__getitem__)
    packed = folder / PACKED
    if not packed.exists():
        return single
    if single:
        raise RecordingError(f"{folder} has both {PACKED} and {single[0].name}")
    return [packed]


def check_folder(path: Path) -> None:
    """Refuse a path on which a file is in a folder's place.

    Raises:
        RecordingError: if there is one.
    """
    for part in (path, *path.absolute().parents):
        if part.exists() and not part.is_dir():
            raise RecordingError(f"{part} is not a folder")


def check_free_to_pack(path: Path, growing: Path) -> None:
    """Refuse a folder that can't be packed into, before anything grows.

    Args:
        path: folder to pack into.
        growing: folder of what is to be packed.

    Raises:
        RecordingError: if something is there, or will be.
    """
    check_folder(path)
    if growing.resolve().is_relative_to(path.resolve()):
        raise RecordingError(f"{path} can't be packed into: the recording grows in it")
    if path.exists() and any(path.iterdir()):
        raise RecordingError(f"{path} is not empty; pack into a new folder")


def all_trees(folder: Path, key: RecordingKey) -> pa.Table:
    """All trees of a recording in one table, without states.

    Raises:
        RecordingError: if a file is damaged or of another recording, or there is none.
    """
    found = tree_files(folder)
    if not found:
        raise RecordingError(f"{folder} is a recording without any tree yet")
    parts = [read(path, key).drop_columns(["state"]) for path in found]
    return pa.concat_tables(parts).combine_chunks()


def read(path: Path, key: RecordingKey) -> pa.Table:
    """Read one of a recording's tables.

    Raises:
        RecordingError: if it is damaged or belongs to another recording.
    """
    try:
        table = tables.read(path, SCHEMA, key.digest, of="recording")
    except ForeignTable as error:
        raise RecordingError(str(error)) from error
    except PermissionError as error:
        raise RecordingError(f"{path} can't be read: {error.strerror}") from error
    except (OSError, ValueError, ArrowException) as error:
        raise RecordingError(f"{path} can't be read: it is damaged") from error
    if not table.num_rows:
        raise RecordingError(f"{path} is damaged: it holds no tree")
    return table
