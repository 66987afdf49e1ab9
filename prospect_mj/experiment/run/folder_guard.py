"""Which folder a run may have, and that it has it alone."""

import os
from collections.abc import Callable
from pathlib import Path

from prospect_mj import storage
from prospect_mj.errors import RunFolderError
from prospect_mj.experiment.run import config_file

DEFAULT_PARENT = Path("runs")


def check_free(path: Path) -> None:
    """Refuse a folder that a new run can't have, without touching it.

    Raises:
        RunFolderError: if `path` is a file, or a folder with something in it.
    """
    # No more than a run that was killed at its birth.
    unborn = storage.temporary(path / config_file.NAME).name
    remedy = f"choose another folder, or --resume {path}"
    check_vacant(path, remedy, lambda name: name == unborn)


def check_vacant(
    path: Path, remedy: str, is_own: Callable[[str], bool] = lambda name: False
) -> None:
    """Refuse a folder that can't be taken, without touching it.

    Args:
        path: the folder.
        remedy: what to do where there is anything else in it than what is its own.
        is_own: whether something of a name may be in it; by default nothing may.

    Raises:
        RunFolderError: if `path` is a file, has something else in it, or can't be made.
    """
    check_holds_only(path, remedy, is_own)
    ancestry = (path.absolute(), *path.absolute().parents)
    nearest = next(folder for folder in ancestry if os.path.exists(folder))
    if not nearest.is_dir() or not os.access(nearest, os.W_OK):
        raise RunFolderError(f"{path} can't be made: {nearest} can't be written to")


def check_holds_only(path: Path, remedy: str, is_own: Callable[[str], bool]) -> None:
    """Refuse a folder with something in it that is not its own.

    Args:
        path: the folder, if it is there.
        remedy: what to do then.
        is_own: whether something of a name may be in it.

    Raises:
        RunFolderError: if there is, or `path` is a file, or can't be read.
    """
    try:
        if path.exists() and not path.is_dir():
            raise RunFolderError(f"{path} is not a folder")
        if path.exists() and not all(is_own(file.name) for file in path.iterdir()):
            raise RunFolderError(f"{path} is not empty; {remedy}")
    except OSError as error:
        raise RunFolderError(f"{path} can't be read: {error.strerror}") from error


def new_default() -> Path:
    """Make the first of runs/train-0001, runs/train-0002, ... that does not exist."""
    DEFAULT_PARENT.mkdir(exist_ok=True)
    number = 1
    while True:
        path = DEFAULT_PARENT / f"train-{number:04d}"
        try:
            path.mkdir()
        except FileExistsError:
            number += 1
        else:
            return path
