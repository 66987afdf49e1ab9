"""Parquet files that say what they belong to."""

import io
from collections.abc import Mapping, Sequence
from pathlib import Path
from types import MappingProxyType

import pyarrow as pa
import pyarrow.parquet as pq
from pyarrow.lib import ArrowException

from prospect_mj.errors import ForeignTable, RunFolderError

_ORIGIN = b"prospect_mj_origin"


def appended(table: pa.Table, rows: pa.Table) -> pa.Table:
    """Copy `table` with `rows` at its end."""
    return pa.concat_tables([table, rows]).combine_chunks()


def parquet(
    table: pa.Table,
    origin: str,
    compression: str = "snappy",
    notes: Mapping[str, str] = MappingProxyType({}),
) -> bytes:
    """Encode `table`, marked with what it belongs to; equal tables give equal bytes.

    Args:
        table: what to encode.
        origin: digest of what it belongs to.
        compression: Parquet's name of it.
        notes: what else is to be found in the metadata of its schema.
    """
    stream = io.BytesIO()
    marked = table.replace_schema_metadata({**notes, _ORIGIN: origin.encode()})
    pq.write_table(marked, stream, compression=compression, write_page_checksum=True)
    return stream.getvalue()


def read(
    path: Path,
    schema: pa.Schema,
    origin: str,
    of: str,
    columns: Sequence[str] | None = None,
) -> pa.Table:
    """Read the table at `path`, which must have exactly the columns of `schema`.

    Args:
        path: Parquet file.
        schema: its columns.
        origin: what it must be marked with.
        of: what that is, in a word.
        columns: those that are wanted; None for all.

    Raises:
        ForeignTable: if it has other columns or another mark.
    """
    # Opened here: pyarrow would see a column in a folder called a=b, and an address in
    # one called s3:b.
    with (
        path.open("rb") as stream,
        pq.ParquetFile(stream, page_checksum_verification=True) as file,
    ):
        found = file.schema_arrow
        if found != schema:
            raise ForeignTable(f"{path} has other columns than this version writes")
        if (found.metadata or {}).get(_ORIGIN) != origin.encode():
            raise ForeignTable(f"{path} is from another {of}")
        return file.read(columns)


def read_kept(path: Path, schema: pa.Schema, origin: str) -> pa.Table:
    """Read a table that a study has kept, as `read` does.

    Raises:
        RunFolderError: if it is damaged, or another one; it is left as it is.
    """
    try:
        return read(path, schema, origin, of="study")
    except ForeignTable as error:
        raise RunFolderError(str(error)) from error
    except (OSError, ValueError, ArrowException) as error:
        raise RunFolderError(
            f"{path} can't be read: it is damaged; move it away and run again"
        ) from error
