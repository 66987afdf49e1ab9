"""Files that are either the old or the new version, whatever kills the process."""

import contextlib
import os
from pathlib import Path
from typing import Any

import yaml

from prospect_mj.errors import ProspectError, is_machines_fault


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

    Raises:
        OSError: if it can't be written, with the file's name.
    """
    unfinished = temporary(path)
    try:
        with unfinished.open("wb") as stream:
            stream.write(content)
            stream.flush()
            os.fsync(stream.fileno())
        unfinished.replace(path)
    except BaseException as error:
        with contextlib.suppress(OSError):
            unfinished.unlink()
        if isinstance(error, OSError) and error.strerror:
            # Else the error of a full disk names nothing.
            raise OSError(error.errno, error.strerror, str(path)) from error
        raise


def make_folder(path: Path, refused: type[ProspectError]) -> None:
    """Make a folder, and those above it, unless it is there.

    Args:
        path: the folder.
        refused: the error that is raised if there is a file, or it can't be made.

    Raises:
        OSError: if the machine is at fault, as on a full disk.
    """
    try:
        if path.exists() and not path.is_dir():
            raise refused(f"{path} is not a folder")
        path.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        if is_machines_fault(error):
            raise
        raise refused(f"{path} can't be made: {error.strerror}") from error


def read_yaml(path: Path, damaged: type[ProspectError]) -> dict[str, Any]:
    """The mapping that a YAML file holds; empty if it holds something else.

    Args:
        path: the file.
        damaged: the error that is raised if it can't be read.
    """
    try:
        content = yaml.safe_load(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise damaged(f"{path} can't be read: {error.strerror}") from error
    except (ValueError, RecursionError, yaml.YAMLError) as error:
        # A day that no month has is a ValueError, and deep nesting is the other.
        raise damaged(f"{path} can't be read: it is damaged") from error
    return content if isinstance(content, dict) else {}
