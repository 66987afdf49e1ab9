"""Tables in files, whatever their folder is called."""

from pathlib import Path

import pyarrow as pa
import pytest

from prospect_mj import tables
from prospect_mj.errors import ForeignTable, RunFolderError

TABLE = pa.table({"number": pa.array([1, 2, 3], pa.int32())})


@pytest.mark.parametrize("name", ["s3:run", "file:run", "~", "a=b", b"\xff\xfe"])
def test_the_name_of_a_folder_is_no_address_and_no_column(name, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    folder = Path(
        name if isinstance(name, str) else name.decode(errors="surrogateescape")
    )
    folder.mkdir()
    path = folder / "table.parquet"
    path.write_bytes(tables.parquet(TABLE, "mine"))
    assert tables.read(path, TABLE.schema, "mine", "run").equals(TABLE)
    with pytest.raises(ForeignTable, match="is from another run"):
        tables.read(path, TABLE.schema, "another", "run")


def test_a_kept_table_that_is_no_longer_itself_is_told_in_one_line(tmp_path):
    path = tmp_path / "table.parquet"
    whole = tables.parquet(TABLE, "mine")
    path.write_bytes(whole)
    assert tables.read_kept(path, TABLE.schema, "mine").equals(TABLE)
    with pytest.raises(RunFolderError, match="is from another study"):
        tables.read_kept(path, TABLE.schema, "another")
    path.write_bytes(whole[:-20])
    with pytest.raises(RunFolderError, match="is damaged; move it away"):
        tables.read_kept(path, TABLE.schema, "mine")
    assert path.read_bytes() == whole[:-20]
