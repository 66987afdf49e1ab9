"""Parquet files of records."""

import io
from pathlib import Path

import pyarrow as pa
import pyarrow.parquet as pq

from prospect_mj.errors import RunFolderError


def appended(table: pa.Table, rows: pa.Table) -> pa.Table:
    """Copy `table` with `rows` at its end."""
    return pa.concat_tables([table, rows]).combine_chunks()


def parquet(table: pa.Table) -> bytes:
    """Encode `table`; equal tables give equal bytes."""
    stream = io.BytesIO()
    pq.write_table(table, stream)
    return stream.getvalue()


def read(path: Path, schema: pa.Schema) -> pa.Table:
    """Read the table at `path`, which must have exactly the columns of `schema`."""
    table = pq.read_table(path)
    if table.schema != schema:
        raise RunFolderError(f"{path} has other columns than this version writes")
    return table
