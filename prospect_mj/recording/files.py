"""The files of a recording.

recording.yaml       what the recording is of (`recording.key`)
left-0000.parquet    one tree each, with the states to grow it on
...
trees.parquet        many trees without states, in place of these
"""

import os
import re
from collections.abc import Sequence
from pathlib import Path

import pyarrow as pa
import pyarrow.compute as pc
from pyarrow.lib import ArrowException

from prospect_mj import tables
from prospect_mj.errors import ForeignTable, RecordingError
from prospect_mj.recording import soundness
from prospect_mj.recording.key import RecordingKey
from prospect_mj.recording.schema import OUTCOMES, SCHEMA
from prospect_mj.task.presentation import ORIENTATIONS

PACKED = "trees.parquet"
_TREE_FILE = re.compile(rf"({'|'.join(ORIENTATIONS)})-(\d{{4,}})\.parquet")


def tree_file(orientation: str, number: int) -> str:
    """Name of the file of one tree."""
    return f"{orientation}-{number:04d}.parquet"


def number_of(path: Path) -> int:
    """Number of the presentation whose tree is in a file of `tree_file`'s name."""
    return int(_TREE_FILE.fullmatch(path.name)[2])


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


def n_presentations(folder: Path) -> int:
    """Of each orientation, up to the last one that is there as a file of its own."""
    return max((number_of(path) for path in tree_files(folder)), default=-1) + 1


def check_folder(path: Path) -> None:
    """Refuse a path on which something else is in a folder's place.

    Raises:
        RecordingError: if there is, or if no folder can have such a name.
    """
    for part in (path, *path.absolute().parents):
        try:
            # Also a link that leads nowhere.
            taken = os.path.lexists(part) and not part.is_dir()
            part.exists()
        except OSError as error:
            raise RecordingError(f"{part} can't be used: {error.strerror}") from error
        if taken:
            raise RecordingError(f"{part} is not a folder")


def all_trees(folder: Path, key: RecordingKey) -> pa.Table:
    """All trees of a recording in one table, without states.

    Raises:
        RecordingError: if a file is damaged or of another recording, or there is none.
    """
    found = tree_files(folder)
    if not found:
        raise RecordingError(f"{folder} is a recording without any tree yet")
    parts = [read(path, key, OUTCOMES) for path in found]
    return pa.concat_tables(parts).combine_chunks()


def read(
    path: Path, key: RecordingKey, columns: Sequence[str] | None = None
) -> pa.Table:
    """Read one of a recording's tables, and check that it makes sense.

    Args:
        path: the file.
        key: of the recording.
        columns: those that are wanted, at least `schema.OUTCOMES`; None for all.

    Raises:
        RecordingError: if it is damaged, or belongs to another recording or to another
            presentation.
    """
    table = _read(path, key, columns)
    soundness.check(table, path)
    held = tree_file(table["orientation"][0].as_py(), table["presentation"][0].as_py())
    if path.name not in (PACKED, held):
        raise RecordingError(f"{path} is misnamed: it holds what {held} should")
    if path.name != PACKED and pc.sum(pc.equal(table["node"], 0)).as_py() > 1:
        raise RecordingError(f"{path} is damaged: it holds more than one tree")
    return table


def _read(path: Path, key: RecordingKey, columns: Sequence[str] | None) -> pa.Table:
    try:
        return tables.read(path, SCHEMA, key.digest, "recording", columns)
    except ForeignTable as error:
        raise RecordingError(str(error)) from error
    except PermissionError as error:
        raise RecordingError(f"{path} can't be read: {error.strerror}") from error
    except (OSError, ValueError, ArrowException) as error:
        raise RecordingError(f"{path} can't be read: it is damaged") from error
