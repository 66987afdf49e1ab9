"""Files that are either the old or the new version, whatever kills the process."""

import contextlib
import os
from pathlib import Path


def temporary(path: Path) -> Path:
    """The name that the content of `path` has before it is whole."""
    return path.with_name(f".{path.name}.tmp")


def replace_file(path: Path, content: bytes) -> None:
    """Write `content` to `path` in one step that cannot be seen half done.

    The bytes reach the disk under another name before they take the place of the old
    file, so that neither a kill nor a power cut leaves a damaged one. A killed process
    leaves that other file behind; the next write of `path` takes it over.

    Args:
        path: file to create or replace; its folder must exist.
        content: the whole new content [bytes].
    """
    unfinished = temporary(path)
    try:
        with unfinished.open("wb") as stream:
            stream.write(content)
            stream.flush()
            os.fsync(stream.fileno())
        unfinished.replace(path)
    except BaseException:
        with contextlib.suppress(OSError):
            unfinished.unlink()
        raise
