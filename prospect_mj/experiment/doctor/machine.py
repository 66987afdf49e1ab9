"""Whether the machine has cores, memory and places to write to."""

import os
import shutil
import tempfile
from pathlib import Path

import joblib
import platformdirs
import psutil

from prospect_mj.experiment.doctor.check import Check, Level
from prospect_mj.experiment.run.folder_guard import DEFAULT_PARENT

_GB = 1e9
ENOUGH_MEMORY, ENOUGH_DISK = 1.0, 1.0
"""[GB]; a process of a training takes 0.4, a recording that grows as much on disk."""


def look_at_cores() -> list[Check]:
    """Cores that this process may use."""
    cores = joblib.cpu_count()
    if cores > 1:
        return [Check("cores", Level.OK, str(cores))]
    remedy = "give --jobs 1 to the commands that have --jobs"
    return [Check("cores", Level.WARN, "1: everything takes its time", remedy)]


def look_at_memory() -> list[Check]:
    """Memory that is free."""
    memory = psutil.virtual_memory()
    free, whole = memory.available / _GB, memory.total / _GB
    found = f"{free:.1f} of {whole:.1f} GB free"
    if free >= ENOUGH_MEMORY:
        return [Check("memory", Level.OK, found)]
    remedy = "end other programs, or give --jobs 1 to the commands that have --jobs"
    return [Check("memory", Level.WARN, found, remedy)]


def look_at_places() -> list[Check]:
    """The folders that commands write to unless they are told otherwise."""
    cache = "export NUMBA_CACHE_DIR=FOLDER with a folder that you may write to"
    runs = "cd to a folder that you may write to, or give --out FOLDER"
    return [
        _place("cache of compiled code", cache_folder(), cache),
        _place("run folders", DEFAULT_PARENT.absolute(), runs),
    ]


def cache_folder() -> Path:
    """Where `planning.kernel_cache` keeps compiled code."""
    chosen = os.environ.get("NUMBA_CACHE_DIR")
    return Path(chosen) if chosen else platformdirs.user_cache_path("prospect_mj")


def _place(name: str, folder: Path, remedy: str) -> Check:
    """Whether a folder can be written to, or made."""
    above = next(part for part in (folder, *folder.parents) if part.exists())
    try:
        with tempfile.TemporaryFile(dir=above):
            free = shutil.disk_usage(above).free / _GB
    except OSError as error:
        found = f"{folder} can't be written to: {error.strerror}"
        return Check(name, Level.WARN, found, remedy)
    found = f"{folder}, {free:.0f} GB free"
    if free >= ENOUGH_DISK:
        return Check(name, Level.OK, found)
    return Check(name, Level.WARN, found, f"make room, or {remedy}")
