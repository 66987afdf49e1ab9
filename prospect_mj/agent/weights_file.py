"""The file format of learned weights: a NumPy archive, read without pickle."""

import io
import json
import zipfile
import zlib
from dataclasses import asdict
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from prospect_mj.agent.settings import LearnerSettings
from prospect_mj.errors import InvalidValue, UnfitWeights
from prospect_mj.storage import replace_file

_FORMAT = "prospect_mj linear Q 1"


class StoredWeights(NamedTuple):
    """Everything that a learner remembers."""

    settings: LearnerSettings
    """Its parameters."""
    weights: NDArray[np.float64]
    """theta, (n_actions, n_features)."""
    n_updates: int
    """Transitions learned from so far."""
    origin: str
    """What they were learned in, in the words of whoever saves them."""


def write(path: Path, stored: StoredWeights) -> None:
    """Write `stored` to `path`, all or nothing; equal content gives equal bytes.

    Raises:
        InvalidValue: if `path` is a folder or in none that exists.
    """
    if path.is_dir() or not path.parent.is_dir():
        raise InvalidValue("weights file", str(path), "a file in a folder that exists")
    buffer = io.BytesIO()
    np.savez(
        buffer,
        format=np.array(_FORMAT),
        settings=np.array(json.dumps(asdict(stored.settings))),
        weights=stored.weights,
        n_updates=np.array(stored.n_updates, dtype=np.int64),
        origin=np.array(stored.origin),
    )
    replace_file(path, buffer.getvalue())


def read(path: Path) -> StoredWeights:
    """Read what `write` wrote.

    Raises:
        UnfitWeights: if they are of another version, or not finite.
        InvalidValue: if the file cannot be read, is damaged, or is another's.
    """
    try:
        with path.open("rb") as stream, np.load(stream, allow_pickle=False) as archive:
            return _decoded(path, {name: archive[name] for name in archive.files})
    except UnfitWeights:
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
        raise InvalidValue(
            "weights file", str(path), "a readable file written by LinearQ.save"
        ) from error


def _decoded(path: Path, archive: dict[str, NDArray]) -> StoredWeights:
    """Check the archive's content; any of the errors above says that it is foreign."""
    found = str(archive["format"])
    if found != _FORMAT:
        raise UnfitWeights(
            f"{path} has format {found!r}; this version reads {_FORMAT!r}"
        )
    settings = LearnerSettings(**json.loads(str(archive["settings"])))
    weights = archive["weights"]
    shape = (settings.n_actions, settings.n_features)
    if weights.dtype != np.float64 or weights.shape != shape:
        raise ValueError(weights.shape)
    if not np.isfinite(weights).all():
        raise UnfitWeights(f"{path} has weights that are not finite numbers")
    n_updates, origin = int(archive["n_updates"]), str(archive["origin"])
    return StoredWeights(settings, weights, n_updates, origin)
