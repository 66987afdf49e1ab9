"""Folders that one process has to itself."""

import fcntl
import os
from pathlib import Path

from prospect_mj.errors import FolderInUse


def lock(path: Path) -> int:
    """Lock the folder itself, so that no lock file is left behind by a kill.

    Returns:
        The descriptor; closing it unlocks the folder.

    Raises:
        FolderInUse: if another process has locked it.
    """
    descriptor = os.open(path, os.O_RDONLY)
    try:
        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError as error:
        os.close(descriptor)
        raise FolderInUse(f"{path} is in use by another process") from error
    return descriptor
