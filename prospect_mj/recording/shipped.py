"""The recordings that come with the package: of each world that was recorded one."""

from pathlib import Path

from prospect_mj import paths
from prospect_mj.errors import RecordingError
from prospect_mj.recording.worlds import STANDARD, WORLDS


def folder(world: str = STANDARD) -> Path:
    """Folder of the recording of a world.

    Args:
        world: its name.

    Raises:
        RecordingError: if none of this world comes with the package.
    """
    if world not in worlds():
        out = f"prospect record --world {world} --out runs/{world}"
        raise RecordingError(
            f"no recording of world {world} comes with the package (there are: "
            f"{', '.join(worlds()) or 'none'}); {out} makes one"
        )
    return paths.RECORDINGS / world


def worlds() -> tuple[str, ...]:
    """Names of the worlds of which a recording comes with the package."""
    return tuple(name for name in WORLDS if (paths.RECORDINGS / name).is_dir())
