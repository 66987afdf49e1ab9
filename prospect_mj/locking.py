"""Folders that one process has to itself."""

import fcntl
import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from prospect_mj.closing import Closing
from prospect_mj.errors import FolderInUse


class LockedFolder(Closing):
    """A folder that no other process may work in until this one closes it.

    Args:
        path: the folder; it must exist.

    Attributes:
        path: as given.
    """

    def __init__(self, path: Path) -> None:
        """Lock it.

        Raises:
            FolderInUse: if another process has locked it, or this one has.
            OSError: if it can't be locked at all.
        """
        self.path, self._descriptor = path, _locked(path)

    def check_open(self) -> None:
        """Refuse to go on when the folder is no longer this one's.

        Raises:
            FolderInUse: if it was closed.
        """
        if self._descriptor < 0:
            raise FolderInUse(f"{self.path} was closed, and may be in use elsewhere")

    @contextmanager
    def closed_if_it_fails(self) -> Iterator[None]:
        """What follows opens the folder: it is closed again if that fails."""
        try:
            yield
        except BaseException:
            self.close()
            raise

    def close(self) -> None:
        """Let other processes use the folder."""
        if self._descriptor >= 0:
            os.close(self._descriptor)
            self._descriptor = -1


def _locked(path: Path) -> int:
    """Lock the folder itself, so that no lock file is left behind by a kill.

    Returns:
        The descriptor; closing it unlocks the folder.

    Raises:
        FolderInUse: if it is locked.
        OSError: if it can't be locked at all.
    """
    descriptor = os.open(path, os.O_RDONLY)
    try:
        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError as error:
        os.close(descriptor)
        raise _refusal(path, error) from error
    return descriptor


def _refusal(path: Path, error: OSError) -> FolderInUse | OSError:
    if isinstance(error, BlockingIOError):
        words = "in use by another process, or by something not closed in this one"
        return FolderInUse(f"{path} is {words}")
    return OSError(f"{path} can't be locked: {error.strerror}")
