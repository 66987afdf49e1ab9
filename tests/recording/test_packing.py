"""A packed recording is there as a whole or not at all, and takes nobody's place."""

import numpy as np
import pytest
from ideal_grower import content, grown_tree, key

from prospect_mj.errors import FolderInUse, RecordingError
from prospect_mj.locking import LockedFolder
from prospect_mj.recording import packing
from prospect_mj.recording.config import Extent
from prospect_mj.recording.files import PACKED
from prospect_mj.recording.growing import GrowingRecording
from prospect_mj.recording.key import NAME
from prospect_mj.recording.node_table import tabulated
from prospect_mj.recording.packing import Packing, check_free
from prospect_mj.recording.recording import Recording
from prospect_mj.storage import replace_file

KEY = key()
TABLES = [tabulated(grown_tree(2))]


@pytest.fixture
def target(tmp_path):
    return tmp_path / "packed"


def opened(target):
    return Packing.open(target, target.parent / "growing")


def pack(target, tables=TABLES):
    with opened(target) as folder:
        return folder.write(tables, KEY)


def test_only_complete_trees_of_the_extent_are_packed(target, tmp_path):
    with GrowingRecording.open(tmp_path / "recording", KEY) as recording:
        for depth, *name in ((3, "left", 0), (2, "right", 0), (3, "right", 1)):
            recording.keep(grown_tree(depth, *name))
        recording.keep(grown_tree(4, "left", 2))
        tables = list(recording.complete(Extent(presentations=2, depth=3)))
    assert pack(target, tables) == 2
    packed = Recording.load(target)
    assert packed.key == KEY
    assert packed.presentations.number.tolist() == [0, 1]
    assert packed.presentations.depth.tolist() == [3, 3]
    assert len(packed.nodes.depth) == 2 * 13


def test_only_the_states_are_left_out(target, tmp_path):
    pack(target)
    packed = Recording.load(target)
    whole = Recording.of(KEY, TABLES[0])
    for name, array in vars(whole.nodes).items():
        np.testing.assert_array_equal(getattr(packed.nodes, name), array)


def test_nothing_is_not_packed(target, tmp_path):
    with pytest.raises(RecordingError, match="no complete tree"):
        pack(target, [])
    assert not content(tmp_path)


def test_what_was_packed_cannot_grow_on(target):
    pack(target)
    before = content(target)
    assert set(before) == {NAME, PACKED}
    with pytest.raises(RecordingError, match=r"can't grow on: .*without states"):
        GrowingRecording.open(target, KEY)
    assert content(target) == before


def test_packing_twice_is_refused_and_the_first_stays(target):
    pack(target)
    before = content(target)
    with pytest.raises(RecordingError, match="is not empty"):
        pack(target, [tabulated(grown_tree(3))])
    assert content(target) == before


def test_two_that_pack_into_one_place_are_not_let_begin(target):
    with opened(target) as first:
        with pytest.raises(FolderInUse, match="in use by another process"):
            opened(target)
        assert first.write(TABLES, KEY) == 1
    assert set(content(target)) == {NAME, PACKED}


def test_what_came_into_its_place_meanwhile_stays(target, tmp_path):
    with opened(target) as folder:
        target.mkdir()
        (target / "thesis.tex").write_text("...")
        with pytest.raises(RecordingError, match="is not empty"):
            folder.write(TABLES, KEY)
    assert set(content(tmp_path)) == {"packed", "packed/thesis.tex"}


@pytest.mark.parametrize("file", [PACKED, NAME])
def test_a_kill_leaves_nothing_that_is_half_packed_or_in_the_way(
    file, target, tmp_path, monkeypatch
):
    def killed_at(path, written):
        if path.name == file:
            path.with_name(f".{file}.tmp").write_bytes(written[:9])
            raise KeyboardInterrupt
        replace_file(path, written)

    folder = opened(target)
    with monkeypatch.context() as patched:
        patched.setattr(packing, "replace_file", killed_at)
        with pytest.raises(KeyboardInterrupt):
            folder.write(TABLES, KEY)
    assert not target.exists()
    # A kill unlocks, and tidies nothing up.
    LockedFolder.close(folder)
    assert content(tmp_path)
    assert pack(target) == 1
    assert set(content(tmp_path)) == {"packed", f"packed/{NAME}", f"packed/{PACKED}"}


def test_what_is_not_packed_leaves_nothing(target, tmp_path):
    opened(target).close()
    assert not content(tmp_path)


def test_an_empty_folder_and_a_link_to_one_are_packed_into(tmp_path):
    (tmp_path / "empty").mkdir()
    (tmp_path / "link").symlink_to("empty")
    assert pack(tmp_path / "link") == 1
    assert set(content(tmp_path / "empty")) == {NAME, PACKED}


def test_what_is_not_its_own_stays(target, tmp_path):
    mine = tmp_path / f".{target.name}.tmp" / "thesis.tex"
    mine.parent.mkdir()
    mine.write_text("...")
    with pytest.raises(RecordingError, match="is in the way"):
        opened(target)
    assert mine.exists()


def test_closed_it_packs_no_more(target):
    folder = opened(target)
    folder.close()
    with pytest.raises(FolderInUse, match="was closed"):
        folder.write(TABLES, KEY)


def test_only_a_free_folder_is_packed_into(tmp_path):
    (tmp_path / "full").mkdir()
    (tmp_path / "full" / "thesis.tex").touch()
    (tmp_path / "empty").mkdir()
    growing = tmp_path / "runs" / "recording"
    check_free(tmp_path / "new", growing)
    check_free(tmp_path / "empty", growing)
    for path, words in {
        tmp_path / "full": "is not empty",
        tmp_path / "full" / "thesis.tex": "is not a folder",
        growing: "grows in it",
        tmp_path / "runs": "grows in it",
        growing / "packed" / "new": "grows in it, or around it",
        tmp_path / "x" / ".." / "runs": "grows in it",
    }.items():
        with pytest.raises(RecordingError, match=words):
            check_free(path, growing)
