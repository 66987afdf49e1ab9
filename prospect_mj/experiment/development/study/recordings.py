"""The recordings of the worlds that the study learns from."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Self

from prospect_mj.errors import RecordingError
from prospect_mj.experiment.populations.digests import recording_digest
from prospect_mj.experiment.populations.recorded_world import RecordedWorld
from prospect_mj.experiment.populations.scenario import PopulationSettings
from prospect_mj.recording import shipped
from prospect_mj.recording.key import RecordingKey
from prospect_mj.recording.recording import Recording
from prospect_mj.recording.worlds import STANDARD, WORLDS


@dataclass(frozen=True)
class Recordings:
    """Recordings by the name of their world."""

    by_world: Mapping[str, Recording]
    """The standard one is among them."""
    path: Path | None = None
    """Folder of the standard one; None: that comes with the package."""
    folder: Path | None = None
    """Where the others are, by their names; None: in the package."""

    @classmethod
    def load(
        cls, worlds: Iterable[str], standard: Path | None, folder: Path | None
    ) -> Self:
        """Read the recordings of some worlds, and refuse those that aren't.

        Args:
            worlds: their names.
            standard: folder of the standard world's recording; None for the one that
                comes with the package.
            folder: where the others are, each in a folder with its world's name; None
                for those that come with the package.

        Raises:
            RecordingError: if one is missing, damaged, incomplete, of another world,
                or lacks what its world is there for.
        """
        given = {STANDARD: standard} if standard is not None else {}
        read = {world: _read(world, given.get(world), folder) for world in worlds}
        return cls(read, standard, folder).checked()

    def checked(self) -> Self:
        """The same, if every recording is fit for the study.

        Raises:
            RecordingError: as `load`.
        """
        digests: dict[str, str] = {}
        for world, recording in self.by_world.items():
            recording.complete(PopulationSettings.max_actions)
            _check_end(world, recording)
            digest = recording_digest(recording)
            if digest in digests:
                raise RecordingError(
                    f"the recordings of worlds {digests[digest]} and {world} are the "
                    "same: the variation that the study asks for is not in them"
                )
            digests[digest] = world
        return self

    @property
    def standard(self) -> Recording:
        """That of the standard world."""
        return self.by_world[STANDARD]


def _read(world: str, path: Path | None, folder: Path | None) -> Recording:
    """The recording of a world: the one given, one of a folder, or the shipped one."""
    if path is None and (folder is None or world == STANDARD):
        return Recording.load(shipped.folder(world))
    path = _in(folder, world) if path is None else path
    found = RecordingKey.read(path).config.world
    if found != world:
        raise RecordingError(f"{path} holds a recording of world {found}, not {world}")
    return Recording.load(path)


def _in(folder: Path, world: str) -> Path:
    if not (folder / world).is_dir():
        raise RecordingError(
            f"{folder} has no recording of world {world}; --parts or --worlds and "
            f"--changes leave it out, and prospect record --world {world} makes it"
        )
    return folder / world


def _check_end(world: str, recording: Recording) -> None:
    lid_first = WORLDS[world].lid_first
    if RecordedWorld(recording).lid_first != lid_first:
        end = "lid" if lid_first else "body"
        raise RecordingError(
            f"the recording of world {world} lacks the variation that the study asks "
            f"for: the jar's {end} doesn't go down in it"
        )
