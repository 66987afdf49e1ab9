"""What took time, kept in files that are known by the digest of what decided on it."""

import json
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path

import pyarrow as pa

from prospect_mj import paths, tables
from prospect_mj.errors import RunFolderError
from prospect_mj.recording.provenance import code_digest, sha256, source_digest
from prospect_mj.storage import make_folder, replace_file

FOLDER = "rivals"
"""In that of the study."""


def code(patterns: Iterable[str], package: Path = Path(paths.__file__).parent) -> str:
    """Digest of code: some files of a package, and all that decides an outcome.

    Args:
        patterns: of the files, from the package's folder.
        package: where the code is.
    """
    found = sorted({path for each in patterns for path in package.glob(each)})
    own = code_digest(
        (path.relative_to(package).as_posix(), path.read_text("utf-8"))
        for path in found
    )
    return sha256(f"{own} {source_digest()}".encode())


def digest(decides: Mapping[str, object]) -> str:
    """One digest of all that decides, which JSON can hold."""
    return sha256(json.dumps(decides, sort_keys=True).encode())


def made_once(
    folder: Path,
    name: str,
    decides: Mapping[str, object],
    make: Callable[[], pa.Table],
    schema: pa.Schema,
) -> pa.Table:
    """Read a table, or make it and keep it.

    Args:
        folder: where it is kept; made if it isn't there.
        name: that the name of its file begins with.
        decides: all that decides on it.
        make: makes it.
        schema: that it has.

    Raises:
        RunFolderError: if the folder can't be made, or the file is damaged.
    """
    make_folder(folder, RunFolderError)
    origin = digest(decides)
    path = folder / f"{name}-{origin[:16]}.parquet"
    if not path.exists():
        replace_file(path, tables.parquet(make(), origin, "zstd"))
    return tables.read_kept(path, schema, origin)
