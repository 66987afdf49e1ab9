"""The static part of planning: computed once, then read from a cache on disk."""

import contextlib
import hashlib
import os
import tempfile
from pathlib import Path
from tokenize import TokenError

import numba
import numpy as np
import platformdirs

from prospect_mj.planning import kernel_cache
from prospect_mj.planning.arm_body import ArmBody
from prospect_mj.planning.joint_grid import JointGrid
from prospect_mj.planning.occupancy import room_among
from prospect_mj.planning.settings import GROSS_JOINTS

MOST_ROOM = 0.60
"""Larger distances are not told apart: no hand with a jar reaches further [m]."""

_DAMAGED = (ValueError, EOFError, TokenError)
"""What numpy answers a file with that is empty, cut off or not an array."""


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
        Distances (m, n) [m], float32, a row for each of the shoulder's cells.
    """
    path = _folder() / f"{_content_hash(body, fixed, grid, margin)}.npy"
    with contextlib.suppress(OSError, *_DAMAGED):
        stored = np.load(path)
        if stored.size == grid.size and stored.dtype == np.float32:
            return stored
    shoulders, elbows = shoulders_and_elbows(grid)
    room = room_among(body.arrays, shoulders, elbows, fixed, margin, MOST_ROOM)
    room = room.astype(np.float32)
    # Without a writable cache it is computed again next time.
    with contextlib.suppress(OSError):
        _store(path, room)
    return room


def shoulders_and_elbows(grid: JointGrid) -> tuple[np.ndarray, np.ndarray]:
    """Angles of joints 1 to 3 (m, 3) and of joint 4 (n,) [rad] at a grid's centres."""
    axes = [grid.centres(j) for j in range(GROSS_JOINTS - 1)]
    mesh = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1)
    return mesh.reshape(-1, GROSS_JOINTS - 1), grid.centres(GROSS_JOINTS - 1)


def _folder() -> Path:
    return platformdirs.user_cache_path("prospect_mj") / "static_maps"


def _content_hash(
    body: ArmBody, fixed: np.ndarray, grid: JointGrid, margin: float
) -> str:
    """SHA-256 of all that the result depends on."""
    # What one version compiles may round otherwise than what another one does.
    compiled = kernel_cache.sources(), numba.__version__, np.__version__
    digest = hashlib.sha256(" ".join(compiled).encode())
    for part in (*body.arrays, fixed, grid.low, grid.high, grid.cells, margin):
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
