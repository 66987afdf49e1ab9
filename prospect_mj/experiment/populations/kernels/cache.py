"""Where numba keeps the learners' compiled code: one folder per state of the sources.

numba compiles a function again when its own file has changed, but not when a function
that it calls has changed in another file; a folder named for the content of all files
leaves no stale code behind, as with the planner's (`planning.kernel_cache`, which tells
where folders are and what is done where none can be written).

Only what is called from Python is kept. It must have one signature: numba numbers the
files of a function's signatures, and two processes that save different ones at the same
time can get the same number.
"""

import atexit
import hashlib
import os
import shutil
import tempfile
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import numba
import platformdirs

from prospect_mj.agent import discovery, features, haptics

_ALSO = (
    Path(features.__file__),
    Path(haptics.__file__),
    *sorted(Path(discovery.__file__).parent.glob("*.py")),
)
"""Other files of which constants and tuples are compiled in."""

uncounted = numba.njit(
    nogil=True, _nrt=False, forceinline=True, no_cpython_wrapper=True
)
"""Compiles what other compiled code calls for every action. It has no reference counts,
which would take as long as all the rest, and so can't make arrays, nor assign to slices
of them."""

called = numba.njit(nogil=True, _nrt=False, no_cpython_wrapper=True)
"""As `uncounted`, for larger functions, which are compiled once."""


def kept(function: Callable[..., Any]) -> Callable[..., Any]:
    """Compile a function without the interpreter's lock, and keep it on disk."""
    before = numba.config.CACHE_DIR
    numba.config.CACHE_DIR = str(folder())
    try:
        return numba.njit(nogil=True, cache=True)(function)
    finally:
        numba.config.CACHE_DIR = before


@cache
def folder() -> Path:
    """The folder for the sources as they are; gone with the process if need be."""
    chosen = os.environ.get("NUMBA_CACHE_DIR")
    root = Path(chosen) if chosen else platformdirs.user_cache_path("prospect_mj")
    path = root / f"learners-{sources()[:16]}"
    try:
        path.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=path):
            pass
    except OSError:
        path = Path(tempfile.mkdtemp(prefix="prospect_mj-"))
        atexit.register(shutil.rmtree, path, ignore_errors=True)
    return path


def sources() -> str:
    """SHA-256 of all files that are compiled, as hexadecimal digits."""
    digest = hashlib.sha256()
    for path in [*sorted(Path(__file__).parent.glob("*.py")), *_ALSO]:
        digest.update(path.name.encode() + path.read_bytes())
    return digest.hexdigest()
