"""Where numba keeps the planner's compiled code: one folder per state of its sources.

numba compiles a function again when its own file has changed, but not when a function
that it calls has changed in another file. A folder named for the content of all files
leaves no stale code behind. It is the user's, so that a read-only installation works;
where the user has no folder to write to, the code is compiled anew by every process.
The setting is numba's own: other libraries' compiled code goes to the same folder.

Two processes may compile at the same time. numba numbers the files of a function's
signatures, and two that save different ones can get the same number: a function that is
compiled for more than one signature is therefore not cached itself, only in what calls
it.
"""

import atexit
import hashlib
import os
import shutil
import tempfile
from pathlib import Path

import numba
import platformdirs


def use() -> None:
    """Let numba cache in this folder what is compiled from now on."""
    folder = _root() / f"kernels-{sources()[:16]}"
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=folder):
            pass
    except OSError:
        folder = Path(tempfile.mkdtemp(prefix="prospect_mj-"))
        atexit.register(shutil.rmtree, folder, ignore_errors=True)
    numba.config.CACHE_DIR = str(folder)


def _root() -> Path:
    chosen = os.environ.get("NUMBA_CACHE_DIR")
    return Path(chosen) if chosen else platformdirs.user_cache_path("prospect_mj")


def sources() -> str:
    """SHA-256 of this package's files, as hexadecimal digits."""
    digest = hashlib.sha256()
    for path in sorted(Path(__file__).parent.glob("*.py")):
        digest.update(path.name.encode() + path.read_bytes())
    return digest.hexdigest()
