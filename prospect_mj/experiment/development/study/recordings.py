"""The recordings of the worlds that the study learns from."""

from collections.abc import Iterable, Mapping
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Self

from prospect_mj import paths
from prospect_mj.errors import RecordingError
from prospect_mj.experiment.development.study.settings import STANDARD
from prospect_mj.experiment.populations.digests import recording_digest
from prospect_mj.experiment.populations.scenario import PopulationSettings
from prospect_mj.experiment.populations.world import World
from prospect_mj.recording.key import RecordingKey
from prospect_mj.recording.recording import Recording

SHIPPED = paths.ASSETS / "recordings"
"""A folder for each recorded world that comes with the package."""

_LID_FIRST = ("post",)
"""Worlds in which the lid goes down."""


@dataclass(frozen=True)
class Recordings:
    """Recordings by the name of their world."""

    by_world: Mapping[str, Recording]
    """The standard one is among them."""

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
        where = SHIPPED if folder is None else folder
        return cls(
            {
                world: _standard(standard)
                if world == STANDARD
                else _of_world(where, world)
                for world in worlds
            }
        ).checked()

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


def _standard(path: Path | None) -> Recording:
    if path is not None:
        _check_world(path, STANDARD)
    return Recording.load(path)


def _of_world(folder: Path, world: str) -> Recording:
    path = folder / world
    if not path.is_dir():
        raise RecordingError(
            f"{folder} has no recording of world {world}; --parts or --worlds and "
            f"--changes leave it out, and prospect record --world {world} makes it"
        )
    _check_world(path, world)
    return Recording.load(path)


def _check_world(path: Path, world: str) -> None:
    config = asdict(RecordingKey.read(path).config)
    found = config.get("world", STANDARD)
    if found != world:
        raise RecordingError(f"{path} holds a recording of world {found}, not {world}")


def _check_end(world: str, recording: Recording) -> None:
    if World(recording).lid_first != (world in _LID_FIRST):
        end = "lid" if world in _LID_FIRST else "body"
        raise RecordingError(
            f"the recording of world {world} lacks the variation that the study asks "
            f"for: the jar's {end} doesn't go down in it"
        )
