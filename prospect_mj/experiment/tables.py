"""Parquet files of records."""

import io
from pathlib import Path

import pyarrow as pa
import pyarrow.parquet as pq

from prospect_mj.errors import RunFolderError

_ORIGIN = b"prospect_mj_run"


def appended(table: pa.Table, rows: pa.Table) -> pa.Table:
    """Copy `table` with `rows` at its end."""
    return pa.concat_tables([table, rows]).combine_chunks()


def parquet(table: pa.Table, origin: str) -> bytes:
    """Encode `table`, marked with its run; equal tables give equal bytes."""
    stream = io.BytesIO()
    marked = table.replace_schema_metadata({_ORIGIN: origin.encode()})
    pq.write_table(marked, stream)
    return stream.getvalue()


def read(path: Path, schema: pa.Schema, origin: str) -> pa.Table:
    """Read the table at `path`, which must have exactly the columns of `schema`.

    Raises:
        RunFolderError: if it has not, or is marked with another run than `origin`.
    """
    table = pq.read_table(path)
    if table.schema != schema:
        raise RunFolderError(f"{path} has other columns than this version writes")
    if (table.schema.metadata or {}).get(_ORIGIN) != origin.encode():
        raise RunFolderError(f"{path} is from another run")
    return table
