"""recording.yaml: what a recording is of, and what made it.

Its digest marks every table of the recording, so that outcomes of different physics
never mix.
"""

import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any, Self

import yaml

from prospect_mj.errors import InvalidValue, ProspectError, RecordingError
from prospect_mj.recording import provenance
from prospect_mj.recording.config import RecordingConfig
from prospect_mj.recording.worlds import WORLDS
from prospect_mj.storage import read_yaml

NAME = "recording.yaml"

_FORMAT = 1


@dataclass(frozen=True)
class RecordingKey:
    """What decides every outcome of a recording."""

    config: RecordingConfig
    sha256: Mapping[str, str]
    """Digest of each model file, of the sources below the learner and of the world."""
    versions: Mapping[str, str]
    """Of each package, by name."""
    machine: Mapping[str, str]
    """What it was made on; for information, not part of `digest`."""

    @classmethod
    def present(cls, config: RecordingConfig, renderer: str = "") -> Self:
        """The key of what would be recorded here and now.

        Args:
            config: what is to be recorded.
            renderer: what makes the images.

        Raises:
            MissingFile: if a model file is missing.
        """
        sources = {"sources": provenance.source_digest()}
        world = {"world": WORLDS[config.world].digest}
        return cls(
            config,
            provenance.model_digests() | sources | world,
            provenance.installed_versions(),
            provenance.machine() | {"renderer": renderer},
        )

    def __hash__(self) -> int:
        """A hash, as the dictionaries have none."""
        return hash(self.digest)

    @property
    def digest(self) -> str:
        """One digest of all that decides an outcome."""
        parts = asdict(self.config), dict(self.sha256), dict(self.versions)
        return provenance.sha256(json.dumps(parts, sort_keys=True).encode())

    def as_yaml(self) -> bytes:
        """The content of the file."""
        content = {
            "prospect_mj_recording": _FORMAT,
            "config": asdict(self.config),
            "sha256": dict(self.sha256),
            "versions": dict(self.versions),
            "machine": dict(self.machine),
        }
        return yaml.safe_dump(content, sort_keys=False).encode()

    @classmethod
    def read(cls, folder: Path) -> Self:
        """Read the key of the recording in a folder.

        Raises:
            RecordingError: if there is none, or it can't be read.
        """
        path = folder / NAME
        if not path.is_file():
            raise RecordingError(f"{folder} is not a recording: it has no {NAME}")
        content = read_yaml(path, RecordingError)
        _check_format(path, content.get("prospect_mj_recording"))
        try:
            config = RecordingConfig.from_dict(content["config"])
            names = "sha256", "versions", "machine"
            return cls(config, *(_words(name, content[name]) for name in names))
        except (ProspectError, KeyError, TypeError) as error:
            raise RecordingError(f"{path} is damaged: {error}") from error

    def differences(self, other: "RecordingKey") -> list[str]:
        """What decides outcomes and is not the same in both, in words.

        Args:
            other: the key that this one, of a recording, is held against.
        """
        made_with = self.config.differences(other.config)
        made_with += [
            f"{name} {was}, not {now}"
            for name, was, now in _changed(self.versions, other.versions)
        ]
        changed = _changed(self.sha256, other.sha256)
        return [f"it was made with {words}" for words in made_with] + [
            f"{name} changed since" for name, _, _ in changed
        ]


def _check_format(path: Path, number: object) -> None:
    """Refuse what is no key, or one of another version of this package."""
    if not isinstance(number, int) or isinstance(number, bool):
        raise RecordingError(f"{path} is not the key of a recording")
    if number != _FORMAT:
        raise RecordingError(
            f"{path} has format {number}; this version reads format {_FORMAT}"
        )


def _words(name: str, found: Any) -> dict[str, str]:  # noqa: ANN401
    """A mapping from words to words; YAML reads some of them as days or numbers."""
    if not isinstance(found, dict):
        raise InvalidValue(name, found, "a mapping")
    for pair in found.items():
        if not all(isinstance(part, str) for part in pair):
            raise InvalidValue(f"an entry of {name}", pair, "words")
    return found


def _changed(
    then: Mapping[str, str], now: Mapping[str, str]
) -> list[tuple[str, str | None, str | None]]:
    names = sorted({*then, *now})
    pairs = [(name, then.get(name), now.get(name)) for name in names]
    return [(name, was, is_now) for name, was, is_now in pairs if was != is_now]
