"""Parquet files that say what they belong to."""

import io
from pathlib import Path

import pyarrow as pa
import pyarrow.parquet as pq

from prospect_mj.errors import ForeignTable

_ORIGIN = b"prospect_mj_origin"


def appended(table: pa.Table, rows: pa.Table) -> pa.Table:
    """Copy `table` with `rows` at its end."""
    return pa.concat_tables([table, rows]).combine_chunks()


def parquet(table: pa.Table, origin: str, compression: str = "snappy") -> bytes:
    """Encode `table`, marked with what it belongs to; equal tables give equal bytes."""
    stream = io.BytesIO()
    marked = table.replace_schema_metadata({_ORIGIN: origin.encode()})
    pq.write_table(marked, stream, compression=compression, write_page_checksum=True)
    return stream.getvalue()


def read(path: Path, schema: pa.Schema, origin: str, of: str) -> pa.Table:
    """Read the table at `path`, which must have exactly the columns of `schema`.

    Args:
        path: Parquet file.
        schema: its columns.
        origin: what it must be marked with.
        of: what that is, in a word.

    Raises:
        ForeignTable: if it has other columns or another mark.
    """
    # As a file of its own: in a folder called a=b pyarrow would see a column.
    table = pq.ParquetFile(path, page_checksum_verification=True).read()
    if table.schema != schema:
        raise ForeignTable(f"{path} has other columns than this version writes")
    if (table.schema.metadata or {}).get(_ORIGIN) != origin.encode():
        raise ForeignTable(f"{path} is from another {of}")
    return table
