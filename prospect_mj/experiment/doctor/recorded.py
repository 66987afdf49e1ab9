"""Whether the recordings that come with the package are what physics does here."""

from pathlib import Path

from prospect_mj import paths
from prospect_mj.errors import ProspectError, RecordingError
from prospect_mj.experiment.doctor.check import Check, Level
from prospect_mj.recording import shipped
from prospect_mj.recording.key import RecordingKey
from prospect_mj.recording.recording import Recording
from prospect_mj.recording.worlds import STANDARD

_NAME = "recorded physics"


def look_at_recordings() -> list[Check]:
    """Each shipped recording: whole, and of the present sources, models and packages.

    That of the standard world must be there.
    """
    others = [world for world in shipped.worlds() if world != STANDARD]
    return [_look_at(world) for world in (STANDARD, *others)]


def _look_at(world: str) -> Check:
    folder = paths.RECORDINGS / world
    anew = (
        f"prospect record --world {world} --out runs/{world} --pack runs/packed, and "
        f"put runs/packed in the place of {folder}"
    )
    try:
        recording = _load(folder, world)
    except (ProspectError, OSError) as error:
        return Check(_NAME, Level.FAIL, str(error), f"install it again, or {anew}")
    present = RecordingKey.present(recording.key.config)
    changed = recording.key.differences(present)
    if not changed:
        n_shown = len(recording.presentations.lid)
        found = f"{world}: {n_shown} presentations, of these sources"
        return Check(_NAME, Level.OK, found)
    found = f"{world}: may differ from live physics: {'; '.join(changed)}"
    return Check(_NAME, Level.WARN, found, _remedy(recording.key, present, anew))


def _load(folder: Path, world: str) -> Recording:
    """The recording in a folder that has the name of its world."""
    recording = Recording.load(folder)
    made_in = recording.key.config.world
    if made_in != world:
        raise RecordingError(f"{folder} is of the world {made_in}")
    return recording


def _remedy(key: RecordingKey, present: RecordingKey, anew: str) -> str:
    """Other versions can be had; other sources were meant to be."""
    if dict(key.sha256) != dict(present.sha256):
        return anew
    wanted = [
        f"'{name}=={version}'"
        for name, version in key.versions.items()
        if present.versions.get(name) != version
    ]
    return f"pip install {' '.join(wanted)}"
