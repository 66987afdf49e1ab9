"""Which files are a recording's, and that damage to any of them is noticed."""

import shutil

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest
from ideal_grower import grown_tree, key

from prospect_mj import tables
from prospect_mj.errors import RecordingError
from prospect_mj.recording import files
from prospect_mj.recording.growing import GrowingRecording
from prospect_mj.recording.node_table import tabulated
from prospect_mj.recording.packing import Packing
from prospect_mj.recording.recording import Recording
from prospect_mj.storage import replace_file

TREES = (("left", 0), ("left", 1), ("right", 0))


@pytest.fixture(scope="module")
def grown(tmp_path_factory):
    folder = tmp_path_factory.mktemp("files") / "grown"
    with GrowingRecording.open(folder, key()) as recording:
        for name in TREES:
            recording.keep(grown_tree(3, *name))
    return folder


@pytest.fixture(scope="module")
def packed(tmp_path_factory):
    folder = tmp_path_factory.mktemp("files") / "packed"
    with Packing.open(folder, folder.parent / "grown") as packing:
        packing.write([tabulated(grown_tree(3, *name)) for name in TREES], key())
    return folder


@pytest.fixture
def copied(grown, tmp_path):
    return shutil.copytree(grown, tmp_path / "copied")


def test_trees_are_counted_by_their_numbers(tmp_path):
    names = ["left-10000", "left-9999", "right-0001", "left-0002"]
    for name in names:
        (tmp_path / f"{name}.parquet").touch()
    found = [path.stem for path in files.tree_files(tmp_path)]
    assert found == ["left-0002", "left-9999", "left-10000", "right-0001"]


def test_other_files_are_left_alone(copied):
    for name in ("my-notes.parquet", "left-1.parquet", ".left-0000.parquet.tmp"):
        (copied / name).write_bytes(b"notes")
    assert len(Recording.load(copied).presentations.root) == len(TREES)


def test_trees_are_not_stepped_twice(copied, packed):
    shutil.copy(packed / files.PACKED, copied)
    with pytest.raises(RecordingError, match=r"both trees.parquet and left-0000"):
        Recording.load(copied)


def test_a_copied_tree_under_another_name_is_noticed(copied):
    shutil.copy(copied / "left-0000.parquet", copied / "left-0007.parquet")
    with pytest.raises(RecordingError, match=r"left-0007.*misnamed.*left-0000"):
        Recording.load(copied)


def test_a_table_of_two_trees_under_the_name_of_one_is_noticed(copied, packed):
    """As it would be loaded, and grown on without the second."""
    shutil.copy(packed / files.PACKED, copied / "left-0000.parquet")
    with pytest.raises(RecordingError, match=r"left-0000.* more than one tree"):
        Recording.load(copied)


def test_a_number_with_more_zeros_is_no_other_tree(copied):
    shutil.copy(copied / "left-0001.parquet", copied / "left-00001.parquet")
    with pytest.raises(RecordingError, match=r"left-00001.* misnamed"):
        Recording.load(copied)


def test_a_table_that_makes_no_sense_is_named(copied):
    path = copied / "left-0001.parquet"
    table = pq.read_table(path)
    rows = table.to_pylist()
    rows[0]["executed"] = False
    nonsense = pa.Table.from_pylist(rows, table.schema)
    replace_file(path, tables.parquet(nonsense, key().digest))
    with pytest.raises(RecordingError, match=r"left-0001.parquet is damaged: a root"):
        Recording.load(copied)


@pytest.mark.parametrize("name", ["link", "link/below", "x" * 300])
def test_where_there_can_be_no_folder_is_one_clear_line(name, tmp_path):
    (tmp_path / "link").symlink_to("nowhere")
    with pytest.raises(RecordingError, match=r"not a folder|can't be used"):
        GrowingRecording.open(tmp_path / name, key())


@pytest.mark.parametrize("folder", ["grown", "packed"])
def test_a_flipped_bit_changes_nothing_that_is_read(folder, request, tmp_path):
    """It is noticed, or it is in what nobody reads; another outcome it never makes."""
    source = request.getfixturevalue(folder)
    damaged = shutil.copytree(source, tmp_path / "damaged")
    path = files.tree_files(damaged)[0]
    whole, sound = path.read_bytes(), contents(Recording.load(damaged))
    rng = np.random.default_rng(4)
    noticed = 0
    for _ in range(60):
        flipped = bytearray(whole)
        flipped[rng.integers(len(whole))] ^= 1 << int(rng.integers(8))
        replace_file(path, bytes(flipped))
        try:
            read = Recording.load(damaged)
        except RecordingError:
            noticed += 1
        else:
            assert contents(read) == sound
    assert noticed > 30


def contents(recording):
    """Everything that can be learned from, to be compared."""
    parts = [recording.nodes, recording.presentations]
    arrays = [array for part in parts for array in vars(part).values()]
    # As bytes: no NaN is equal to another one.
    return [(a.shape, a.tobytes()) for a in arrays], recording.predicates.states
