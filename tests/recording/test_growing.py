"""The folder of a recording: what it refuses, and that it then touches nothing."""

import shutil
from dataclasses import replace

import pyarrow as pa
import pyarrow.parquet as pq
import pytest
from ideal_grower import content, grown_tree, key

from prospect_mj import tables
from prospect_mj.errors import FolderInUse, RecordingError
from prospect_mj.recording.config import Extent
from prospect_mj.recording.files import PACKED, check_free_to_pack
from prospect_mj.recording.growing import GrowingRecording
from prospect_mj.recording.key import NAME
from prospect_mj.recording.packing import pack
from prospect_mj.recording.recording import Recording
from prospect_mj.recording.schema import SCHEMA

KEY = key()


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


def test_a_second_process_is_refused(folder):
    before = content(folder)
    with (
        GrowingRecording.open(folder, KEY),
        pytest.raises(FolderInUse, match="in use by another process"),
    ):
        GrowingRecording.open(folder, KEY)
    assert content(folder) == before
    GrowingRecording.open(folder, KEY).close()


@pytest.mark.parametrize(
    ("other", "words"),
    [
        (key(seed=1), "its seed is 0, not 1"),
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
    without_a_root: "holds no tree",
    with_absurd_words: "holds no tree",
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


def test_only_complete_trees_of_the_extent_are_packed(folder, tmp_path):
    with GrowingRecording.open(folder, KEY) as recording:
        recording.keep(grown_tree(2, "right", 0))
        recording.keep(grown_tree(3, "right", 1))
        recording.keep(grown_tree(4, "left", 2))
        trees = list(recording.complete_trees(Extent(presentations=2, depth=3)))
    assert [tree.name for tree in trees] == [("left", 0), ("right", 1)]
    assert pack(trees, KEY, tmp_path / "packed") == 2
    packed = Recording.load(tmp_path / "packed")
    assert packed.key == KEY
    assert packed.presentations.depth.tolist() == [3, 3]
    assert len(packed.nodes.depth) == 2 * 13


def test_nothing_is_not_packed(tmp_path):
    with pytest.raises(RecordingError, match="no complete tree"):
        pack([], KEY, tmp_path / "packed")
    assert not (tmp_path / "packed").exists()


def test_what_was_packed_cannot_grow_on(tmp_path):
    path = tmp_path / "packed"
    pack([grown_tree(2)], KEY, path)
    before = content(path)
    assert set(before) == {NAME, PACKED}
    with pytest.raises(RecordingError, match=r"can't grow on: .*without states"):
        GrowingRecording.open(path, KEY)
    assert content(path) == before


def test_only_a_free_folder_is_packed_into(tmp_path):
    (tmp_path / "full").mkdir()
    (tmp_path / "full" / "thesis.tex").touch()
    (tmp_path / "empty").mkdir()
    growing = tmp_path / "runs" / "recording"
    check_free_to_pack(tmp_path / "new", growing)
    check_free_to_pack(tmp_path / "empty", growing)
    for path, words in {
        tmp_path / "full": "is not empty",
        tmp_path / "full" / "thesis.tex": "is not a folder",
        growing: "grows in it",
        tmp_path / "runs": "grows in it",
        tmp_path / "x" / ".." / "runs": "grows in it",
    }.items():
        with pytest.raises(RecordingError, match=words):
            check_free_to_pack(path, growing)
