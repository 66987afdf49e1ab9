"""Files that a command is told to write: refused before the work that they take."""

import os
from pathlib import Path

from prospect_mj.errors import InvalidValue


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
    effective = os.access in os.supports_effective_ids
    if not os.access(path.parent, os.W_OK | os.X_OK, effective_ids=effective):
        raise InvalidValue(what, str(path), "a file in a folder that may be written")


def _is_there(path: Path) -> bool:
    """Whether anything is, also a link that leads nowhere."""
    try:
        path.lstat()
    except (FileNotFoundError, NotADirectoryError):
        return False
    return True
