"""Episodes as files: the states in full, all that follows from them left out.

    <name>.npz   states, signals and planned paths as arrays, both images as PNG, and a
                 description in JSON: scene, presentation, look, actions, origin

A file is written as a whole, and carries the digest of the run that it belongs to. What
can be computed from the states (poses, contacts, sensor readings) is not in it.
"""

import io
import json
from pathlib import Path
from typing import Any

import numpy as np

from prospect_mj.agent.features import N_BINS
from prospect_mj.episodes import description
from prospect_mj.episodes.episode import QUANTITIES, Episode, Signals, States
from prospect_mj.episodes.images import as_png, from_png
from prospect_mj.errors import EpisodeError
from prospect_mj.robot import wam
from prospect_mj.robot.names import SIDES
from prospect_mj.sim.camera import StereoPair
from prospect_mj.storage import replace_file

SUFFIX = ".npz"
_FORMAT = 1


class _UnfitArrays(ValueError):
    """Arrays that are no episode's; the message says which."""


def write(path: Path, episode: Episode, origin: str) -> None:
    """Write an episode.

    Args:
        path: the file; its folder must exist.
        episode: what happened.
        origin: digest of the run that it belongs to.
    """
    stream = io.BytesIO()
    np.savez_compressed(stream, **_arrays(episode, origin))
    replace_file(path, stream.getvalue())


def read(path: Path, origin: str | None = None) -> Episode:
    """Read an episode.

    Args:
        path: the file.
        origin: digest of the run that it must belong to; None: of any.

    Raises:
        EpisodeError: if there is none, it is damaged, or belongs to another run.
    """
    try:
        with np.load(path, allow_pickle=False) as stored:
            there = "description" in stored
            told = json.loads(bytes(stored["description"])) if there else None
            _check(path, told, origin)
            return _episode(told, stored)
    except FileNotFoundError as error:
        raise EpisodeError(f"there is no episode {path}") from error
    except EpisodeError:
        raise
    # zipfile, zlib, NumPy, JSON and cattrs each have errors of their own for damage.
    except Exception as error:
        told = f"{path} can't be read as an episode: {_why(error)}"
        raise EpisodeError(told) from error


def _why(error: Exception) -> str:
    """What a user can use: NumPy's words are that it may be loaded unsafely."""
    if isinstance(error, _UnfitArrays):
        return str(error)
    return getattr(error, "strerror", None) or "it is damaged, or none"


def _arrays(episode: Episode, origin: str) -> dict[str, Any]:
    told = {"format": _FORMAT, "origin": origin, **description.of(episode)}
    images = episode.look.images
    return {
        "description": np.frombuffer(json.dumps(told).encode(), np.uint8),
        "histogram": episode.look.histogram,
        "left_image": as_png(images.left),
        "right_image": as_png(images.right),
        "state_times": episode.states.times,
        "states": episode.states.rows,
        "signal_times": episode.signals.times,
        "measured": episode.signals.measured,
        "path_points": description.path_points(episode),
    }


def _episode(told: dict[str, Any], stored: Any) -> Episode:  # noqa: ANN401
    images = StereoPair(*(from_png(stored[f"{s}_image"]) for s in ("left", "right")))
    states = States(
        _numbers(stored, "state_times", (None,)),
        _numbers(stored, "states", (None, None)),
    )
    arms = len(SIDES), len(QUANTITIES)
    signals = Signals(
        _numbers(stored, "signal_times", (None,)),
        _numbers(stored, "measured", (None, *arms)),
    )
    _check_times("state", states.times, states.rows)
    _check_times("signal", signals.times, signals.measured)
    if not len(states.times):
        raise _UnfitArrays("there is no state in it")
    histogram = _numbers(stored, "histogram", (N_BINS,))
    points = _numbers(stored, "path_points", (None, wam.N_JOINTS))
    return description.episode(told, images, histogram, states, signals, points)


def _numbers(stored: Any, name: str, shape: tuple[int | None, ...]) -> Any:  # noqa: ANN401
    """An array of numbers; None in its shape is any length."""
    array = stored[name]
    fits = len(array.shape) == len(shape) and all(
        wanted in (None, found)
        for wanted, found in zip(shape, array.shape, strict=True)
    )
    if not fits or array.dtype.kind not in "fi":
        raise _UnfitArrays(f"its {name} are {array.dtype} of shape {array.shape}")
    return array


def _check_times(what: str, times: np.ndarray, rows: np.ndarray) -> None:
    if len(times) != len(rows) or not (np.diff(times) > 0).all():
        raise _UnfitArrays(f"its {what} times don't fit")


def _check(path: Path, told: object, origin: str | None) -> None:
    if not isinstance(told, dict) or "format" not in told:
        raise EpisodeError(f"{path} is not an episode")
    if told["format"] != _FORMAT:
        raise EpisodeError(
            f"{path} has format {told['format']}; this version reads format {_FORMAT}"
        )
    if origin is not None and told["origin"] != origin:
        raise EpisodeError(f"{path} is from another run")
