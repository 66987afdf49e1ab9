"""A folder for one process, and what is told when it can't be."""

import errno
import fcntl

import pytest

from prospect_mj.errors import FolderInUse
from prospect_mj.locking import LockedFolder


def test_a_locked_folder_is_not_locked_again_until_it_is_closed(tmp_path):
    with (
        LockedFolder(tmp_path),
        pytest.raises(FolderInUse, match=r"by another process, or by something not"),
    ):
        LockedFolder(tmp_path)
    LockedFolder(tmp_path).close()


def test_closed_it_says_so(tmp_path):
    folder = LockedFolder(tmp_path)
    folder.check_open()
    folder.close()
    with pytest.raises(FolderInUse, match="was closed"):
        folder.check_open()


def test_a_disk_that_knows_no_locks_is_not_called_in_use(tmp_path, monkeypatch):
    def refuse(descriptor, operation):
        raise OSError(errno.ENOLCK, "No locks available")

    monkeypatch.setattr(fcntl, "flock", refuse)
    with pytest.raises(OSError, match="can't be locked: No locks available") as error:
        LockedFolder(tmp_path)
    assert not isinstance(error.value, FolderInUse)
