"""The static part of planning: computed once, then read from a cache on disk."""

import contextlib
import hashlib
import os
import tempfile
from pathlib import Path

import numpy as np
import platformdirs

from prospect_mj.planning.arm_body import ArmBody
from prospect_mj.planning.clearance import arrays
from prospect_mj.planning.joint_grid import JointGrid
from prospect_mj.planning.occupancy import room_among

MOST_ROOM = 0.60
"""Larger distances are not told apart: no hand with a jar reaches further [m]."""

_FORMAT = "room-1"
"""Changes with the meaning of what is stored."""


def static_room(
    body: ArmBody, fixed: np.ndarray, grid: JointGrid, margin: float
) -> np.ndarray:
    """Room among fixtures for every cell, see `occupancy.room_among`.

    Args:
        body: the arm.
        fixed: solids that never move (n, 18).
        grid: of the gross joints.
        margin: that the links must keep [m].

    Returns:
        Distances [m] of the grid's shape, float32.
    """
    path = _folder() / f"{_content_hash(body, fixed, grid, margin)}.npy"
    with contextlib.suppress(OSError, ValueError):
        stored = np.load(path)
        if stored.shape == grid.shape and stored.dtype == np.float32:
            return stored
    axes = tuple(grid.centres(j) for j in range(grid.n_joints))
    room = room_among(arrays(body), axes, fixed, margin, MOST_ROOM)
    room = room.astype(np.float32)
    # Without a writable cache it is computed again next time.
    with contextlib.suppress(OSError):
        _store(path, room)
    return room


def _folder() -> Path:
    return platformdirs.user_cache_path("prospect_mj") / "static_maps"


def _content_hash(
    body: ArmBody, fixed: np.ndarray, grid: JointGrid, margin: float
) -> str:
    """SHA-256 of all that the result depends on."""
    digest = hashlib.sha256(_FORMAT.encode())
    for part in (*arrays(body), fixed, grid.low, grid.high, grid.cells, margin):
        content = np.ascontiguousarray(part)
        digest.update(f"{content.dtype}{content.shape}".encode())
        digest.update(content.tobytes())
    return digest.hexdigest()


def _store(path: Path, room: np.ndarray) -> None:
    """Write a file that is whole whenever it is there."""
    path.parent.mkdir(parents=True, exist_ok=True)
    handle, name = tempfile.mkstemp(dir=path.parent, suffix=".tmp")
    try:
        with os.fdopen(handle, "wb") as file:
            np.save(file, room)
        Path(name).replace(path)
    except OSError:
        Path(name).unlink(missing_ok=True)
        raise
