"""The file of a learner, whichever it is: a NumPy archive, read without pickle.

It has the learner's settings, with its name, and the arrays of its state. Learning goes
on from it bit for bit.
"""

import io
import json
import zipfile
import zlib
from dataclasses import asdict
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from prospect_mj.agent.learner import Learner
from prospect_mj.agent.learners import new_learner, settings_of
from prospect_mj.errors import InvalidValue, ProspectError, UnfitCheckpoint
from prospect_mj.storage import replace_file

_FORMAT = "prospect_mj learner 1"
_ARRAY = "state."
"""What the names of the state's arrays begin with."""


class Checkpoint(NamedTuple):
    """What a file holds."""

    learner: Learner
    origin: str
    """What it learned in, in the words of whoever wrote it; never interpreted."""


def write(path: str | Path, learner: Learner, origin: str = "") -> None:
    """Write all that a learner has learned, all or nothing.

    Equal content gives equal bytes.

    Args:
        path: the file.
        learner: what to write.
        origin: what it learned in.

    Raises:
        InvalidValue: if `path` is a folder or in none that exists.
    """
    path = Path(path)
    if path.is_dir() or not path.parent.is_dir():
        raise InvalidValue("learner file", str(path), "a file in a folder that exists")
    buffer = io.BytesIO()
    np.savez(
        buffer,
        format=np.array(_FORMAT),
        settings=np.array(json.dumps(asdict(learner.settings))),
        origin=np.array(origin),
        **{f"{_ARRAY}{name}": array for name, array in learner.state().items()},
    )
    replace_file(path, buffer.getvalue())


def read(path: str | Path, wanted: str | None = None) -> Checkpoint:
    """Read what `write` wrote.

    Args:
        path: the file.
        wanted: name of the learner that it must hold; None: any.

    Raises:
        UnfitCheckpoint: if it is of another version or another learner, or holds what
            no learner has learned.
        InvalidValue: if the file cannot be read, is damaged, or is another's.
    """
    path = Path(path)
    try:
        with path.open("rb") as stream, np.load(stream, allow_pickle=False) as archive:
            content = {name: archive[name] for name in archive.files}
        return _decoded(path, content, wanted)
    except UnfitCheckpoint:
        raise
    except (
        OSError,
        EOFError,
        ValueError,
        KeyError,
        TypeError,
        AttributeError,
        zipfile.BadZipFile,
        zlib.error,
    ) as error:
        expected = "a readable file that a learner was written to"
        raise InvalidValue("learner file", str(path), expected) from error


def _decoded(path: Path, content: dict[str, NDArray], wanted: str | None) -> Checkpoint:
    """Make the learner; any of the errors above says that the file is foreign."""
    found = str(content["format"])
    if found != _FORMAT:
        raise UnfitCheckpoint(
            f"{path} has format {found!r}; this version reads {_FORMAT!r}"
        )
    plain = json.loads(str(content["settings"]))
    if wanted is not None and plain["name"] != wanted:
        raise UnfitCheckpoint(f"{path} holds a {plain['name']} learner, not {wanted}")
    learner = new_learner(settings_of(plain))
    state = {
        name.removeprefix(_ARRAY): array
        for name, array in content.items()
        if name.startswith(_ARRAY)
    }
    try:
        learner.restore(state)
    except ProspectError as error:
        raise UnfitCheckpoint(f"{path} has no sound learner: {error}") from error
    return Checkpoint(learner, str(content["origin"]))
