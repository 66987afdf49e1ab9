"""What a command is told to write: refused before the work that it takes."""

import contextlib
import os
from collections.abc import Iterator
from pathlib import Path

from prospect_mj.errors import InvalidValue, ProspectError
from prospect_mj.storage import make_folder


def check_new_file(what: str, path: Path, suffix: str) -> None:
    """Refuse a file that can't be written, or is there.

    Args:
        what: the option, for the message.
        path: the file.
        suffix: what its name must end in.

    Raises:
        InvalidValue: with what is wrong.
    """
    if path.suffix != suffix:
        raise InvalidValue(what, str(path), f"a name that ends in {suffix}")
    try:
        taken, has_place = _is_there(path), path.parent.is_dir()
    except OSError as error:
        expected = f"a file that can be made ({error.strerror})"
        raise InvalidValue(what, str(path), expected) from error
    if taken:
        raise InvalidValue(what, str(path), "a file that does not exist")
    if not has_place:
        raise InvalidValue(what, str(path), "a file in a folder that exists")
    if not _may_be_written(path.parent):
        raise InvalidValue(what, str(path), "a file in a folder that may be written")


def _may_be_written(folder: Path) -> bool:
    effective = os.access in os.supports_effective_ids
    return os.access(folder, os.W_OK | os.X_OK, effective_ids=effective)


def _is_there(path: Path) -> bool:
    """Whether anything is, also a link that leads nowhere."""
    try:
        path.lstat()
    except (FileNotFoundError, NotADirectoryError):
        return False
    return True


@contextlib.contextmanager
def new_folder(path: Path) -> Iterator[None]:
    """Make a folder unless it is there; if nothing comes into it, it goes again.

    Args:
        path: the folder; those above it are made, and go, with it.

    Raises:
        ProspectError: if there is a file, or it can't be made or written to.
    """
    made = [one for one in (path, *path.parents) if not os.path.exists(one)]
    try:
        make_folder(path, ProspectError)
        if not _may_be_written(path):
            raise ProspectError(f"{path} can't be written to: Permission denied")
        yield
    finally:
        for one in made:
            # What has something in it stays.
            with contextlib.suppress(OSError):
                one.rmdir()
