"""The folder of a recording: what it refuses, and that it then touches nothing."""

import os
import shutil
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import pyarrow as pa
import pyarrow.parquet as pq
import pytest
from ideal_grower import content, grown_tree, key

from prospect_mj import tables
from prospect_mj.errors import FolderInUse, RecordingError
from prospect_mj.recording import files
from prospect_mj.recording.growing import GrowingRecording
from prospect_mj.recording.key import NAME
from prospect_mj.recording.schema import SCHEMA
from prospect_mj.recording.state_codec import state_row

KEY = key()
TESTS = Path(__file__).resolve().parents[1]


@pytest.fixture
def folder(tmp_path):
    """A recording with one tree, complete to three executed actions."""
    with GrowingRecording.open(tmp_path / "recording", KEY) as recording:
        recording.keep(grown_tree(3))
    return tmp_path / "recording"


def test_what_was_kept_is_there_when_it_is_opened_again(folder):
    with GrowingRecording.open(folder, KEY) as recording:
        assert recording.tree("left", 0).n_actions == 12
        assert recording.tree("right", 0) is None
        assert recording.n_trees == 1


def test_what_is_open_here_is_not_opened_twice(folder):
    before = content(folder)
    with (
        GrowingRecording.open(folder, KEY),
        pytest.raises(FolderInUse, match="or by something not closed in this one"),
    ):
        GrowingRecording.open(folder, KEY)
    assert content(folder) == before
    GrowingRecording.open(folder, KEY).close()


def test_a_second_process_is_refused(folder):
    code = (
        "from pathlib import Path\n"
        "from ideal_grower import key\n"
        "from prospect_mj.recording.growing import GrowingRecording\n"
        f"GrowingRecording.open(Path({str(folder)!r}), key())"
    )
    with GrowingRecording.open(folder, KEY):
        path = {"PYTHONPATH": str(TESTS)}
        done = subprocess.run(
            [sys.executable, "-c", code],
            env=os.environ | path,
            capture_output=True,
            text=True,
            check=False,
        )
    assert "FolderInUse" in done.stderr.splitlines()[-1]


def test_closed_it_neither_reads_nor_overwrites(folder):
    """Another process may have made the tree larger since."""
    first = GrowingRecording.open(folder, KEY)
    tree = first.tree("left", 0)
    first.close()
    with GrowingRecording.open(folder, KEY) as second:
        second.keep(grown_tree(4))
    before = content(folder)
    for use in (lambda: first.keep(tree), lambda: first.tree("left", 0)):
        with pytest.raises(FolderInUse, match="was closed"):
            use()
    assert content(folder) == before


def test_where_its_last_presentation_is(folder):
    with GrowingRecording.open(folder, KEY) as recording:
        assert files.n_presentations(folder) == 1
        recording.keep(grown_tree(1, "right", 70))
        assert files.n_presentations(folder) == 71


@pytest.mark.parametrize(
    ("other", "words"),
    [
        (key(seed=1), "made with seed 0, not 1"),
        (replace(KEY, versions={**KEY.versions, "numpy": "9"}), "numpy 2.4.6, not 9"),
        (replace(KEY, sha256={**KEY.sha256, "sources": "x"}), "sources changed since"),
    ],
)
def test_other_physics_are_refused(folder, other, words):
    before = content(folder)
    with pytest.raises(RecordingError, match=f"can't grow on: .*{words}.*don't mix"):
        GrowingRecording.open(folder, other)
    assert content(folder) == before
    GrowingRecording.open(folder, KEY).close()


def test_a_folder_of_something_else_is_refused(tmp_path):
    (tmp_path / "thesis.tex").write_text("...")
    with pytest.raises(RecordingError, match="is not empty, and no recording"):
        GrowingRecording.open(tmp_path, KEY)
    assert list(content(tmp_path)) == ["thesis.tex"]


@pytest.mark.parametrize("path", ["file", "file/below", "file/far/below"])
def test_a_file_in_a_folders_place_is_refused(path, tmp_path):
    (tmp_path / "file").write_text("...")
    with pytest.raises(RecordingError, match="file is not a folder"):
        GrowingRecording.open(tmp_path / path, KEY)


def test_a_recording_that_was_killed_at_its_birth_begins_again(tmp_path):
    (tmp_path / f".{NAME}.tmp").write_text("prospect_")
    with GrowingRecording.open(tmp_path, KEY) as recording:
        assert recording.key == KEY


def columns_missing(path):
    table = pq.read_table(path).drop_columns(["result"])
    path.write_bytes(tables.parquet(table, KEY.digest))


def of_another_recording(path):
    table = pq.read_table(path)
    path.write_bytes(tables.parquet(table, key(seed=8).digest))


def without_rows(path):
    path.write_bytes(tables.parquet(SCHEMA.empty_table(), KEY.digest))


def with_absurd_words(path):
    table = pq.read_table(path)
    column = SCHEMA.get_field_index("left_place")
    words = pa.array(["nowhere"] * table.num_rows)
    table = table.set_column(column, SCHEMA.field("left_place"), words)
    path.write_bytes(tables.parquet(table, KEY.digest))


def without_a_root(path):
    path.write_bytes(tables.parquet(pq.read_table(path).slice(1), KEY.digest))


def changed(row, **values):
    """Harm that a checksum knows nothing of."""

    def harm(path):
        table = pq.read_table(path)
        rows = table.to_pylist()
        rows[row] |= values
        nonsense = pa.Table.from_pylist(rows, table.schema)
        path.write_bytes(tables.parquet(nonsense, KEY.digest))

    return harm


def with_an_edge_twice(path):
    table = pq.read_table(path)
    rows = table.to_pylist()
    rows.append({**rows[-1], "node": len(rows)})
    nonsense = pa.Table.from_pylist(rows, table.schema)
    path.write_bytes(tables.parquet(nonsense, KEY.digest))


STATE = grown_tree(3).nodes[-1].state
SHOWN = vars(grown_tree(3).shown)


def half_written(path):
    path.write_bytes(path.read_bytes()[: path.stat().st_size // 2])


def tail_lost(path):
    path.write_bytes(path.read_bytes()[:-1])


def overwritten(path):
    whole = path.read_bytes()
    path.write_bytes(whole[:200] + bytes(400) + whole[600:])


HARM = {
    half_written: "damaged",
    tail_lost: "damaged",
    overwritten: "damaged",
    lambda path: path.write_bytes(b""): "damaged",
    lambda path: path.write_text("left,0\n"): "damaged",
    without_rows: "holds no tree",
    without_a_root: "its first node is no root",
    with_absurd_words: "left_place is 'nowhere'",
    with_an_edge_twice: "leads from a node to two others",
    changed(2, parent=99): "a tree is not whole",
    changed(2, parent=-1): "parent is out of its range",
    changed(0, shown={**SHOWN, "histogram": [7]}): "a histogram is not whole",
    changed(2, left_holds=True, right_holds=True): "can't end in",
    changed(12, state={**state_row(STATE), "physics": [1.0]}): "physics of a state",
    changed(12, state={**state_row(STATE), "physics": []}): "physics of a state",
    changed(12, state={**state_row(STATE), "seen": [1.0]}): "seen of a state",
    changed(12, state={**state_row(STATE), "held_left": [1.0]}): "held_left of a state",
    columns_missing: "has other columns",
    of_another_recording: "is from another recording",
}


@pytest.mark.parametrize(
    ("harm", "words"), HARM.items(), ids=lambda value: getattr(value, "__name__", "")
)
def test_a_damaged_tree_is_one_clear_line_and_stays_as_it_is(folder, harm, words):
    path = folder / "left-0000.parquet"
    harm(path)
    before = content(folder)
    with (
        GrowingRecording.open(folder, KEY) as recording,
        pytest.raises(RecordingError, match=words) as refused,
    ):
        recording.tree("left", 0)
    assert str(path) in str(refused.value)
    assert content(folder) == before


def test_a_tree_under_anothers_name_is_refused(folder):
    shutil.copy(folder / "left-0000.parquet", folder / "right-0003.parquet")
    with (
        GrowingRecording.open(folder, KEY) as recording,
        pytest.raises(RecordingError, match=r"misnamed: it holds what left-0000"),
    ):
        recording.tree("right", 3)
