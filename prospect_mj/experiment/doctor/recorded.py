"""Whether the recording that comes with the package is what physics does here."""

from prospect_mj import paths
from prospect_mj.errors import ProspectError
from prospect_mj.experiment.doctor.check import Check, Level
from prospect_mj.recording.key import RecordingKey
from prospect_mj.recording.recording import Recording

_NAME = "recorded physics"
_ANEW = "prospect record --out runs/recording --pack runs/packed, and put runs/packed"


def look_at_recording() -> list[Check]:
    """The shipped recording: whole, and of the present sources, models and packages."""
    anew = f"{_ANEW} in the place of {paths.RECORDING}"
    try:
        recording = Recording.load(paths.RECORDING)
    except (ProspectError, OSError) as error:
        return [Check(_NAME, Level.FAIL, str(error), f"install it again, or {anew}")]
    present = RecordingKey.present(recording.key.config)
    changed = recording.key.differences(present)
    if not changed:
        n_shown = len(recording.presentations.lid)
        return [Check(_NAME, Level.OK, f"{n_shown} presentations, of these sources")]
    found = f"may differ from live physics: {'; '.join(changed)}"
    return [Check(_NAME, Level.WARN, found, _remedy(recording.key, present, anew))]


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
