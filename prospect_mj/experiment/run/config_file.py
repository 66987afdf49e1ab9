"""config.yaml: what a run is, and which software and model files made it."""

import json
from collections.abc import Iterator, Mapping
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any, NamedTuple

import yaml

from prospect_mj.errors import ProspectError, RunFolderError
from prospect_mj.experiment.run import fingerprint
from prospect_mj.experiment.run.config import TrainConfig
from prospect_mj.recording import provenance
from prospect_mj.storage import read_yaml, replace_file

NAME = "config.yaml"

_FORMAT = 1

PACKAGES = ("prospect-mj", *provenance.PACKAGES, "gymnasium")
"""A run is bit-identical only within one version of each of these."""


@dataclass(frozen=True)
class StoredConfig:
    """What a configuration says, as it was written."""

    settings: Mapping[str, Any]
    """Of a `TrainConfig`, as plain numbers, words, lists and mappings."""
    sha256: Mapping[str, str]
    """`fingerprint.digests` of then."""
    versions: Mapping[str, str]
    """Of each package, by name."""


def write(path: Path, config: TrainConfig) -> None:
    """Write `config`, its digests and the installed versions, all or nothing."""
    content = {"prospect_mj_run": _FORMAT, **as_content(present(config))}
    replace_file(path, yaml.safe_dump(content, sort_keys=False).encode())


def present(config: TrainConfig) -> StoredConfig:
    """What would be written of a configuration now.

    Raises:
        ProspectError: if something that decides the numbers is missing.
    """
    # By way of JSON, as YAML knows no number that is only derived from float.
    settings = json.loads(json.dumps(asdict(config)))
    versions = provenance.installed_versions(PACKAGES)
    return StoredConfig(settings, fingerprint.digests(config), versions)


def as_content(stored: StoredConfig) -> dict[str, Any]:
    """What a file has of a configuration, and of the machine that it is made on."""
    return {
        "config": dict(stored.settings),
        "sha256": dict(stored.sha256),
        "versions": dict(stored.versions),
        "platform": provenance.machine(),
    }


def read(path: Path) -> TrainConfig:
    """Read a configuration that this software can continue exactly.

    Raises:
        RunFolderError: if the file is unreadable, foreign, edited, or of other
            versions or model files.
    """
    stored = read_stored(path)
    try:
        config = TrainConfig.from_dict(stored.settings)
    except (ProspectError, KeyError, TypeError, ValueError) as error:
        raise RunFolderError(f"{path} is damaged: {error}") from error
    check_continuable(path, stored, config)
    return config


def read_stored(path: Path) -> StoredConfig:
    """Read what a run was, whether this software can continue it or not.

    Raises:
        RunFolderError: if the file is unreadable, foreign or edited.
    """
    content = read_yaml(path, RunFolderError)
    if content.get("prospect_mj_run") != _FORMAT:
        raise RunFolderError(f"{path} is not the configuration of a run")
    return stored_in(path, content)


def stored_in(path: Path, content: Mapping[str, Any]) -> StoredConfig:
    """The configuration in what a file holds, which `as_content` made.

    Raises:
        RunFolderError: if something is lacking or was edited.
    """
    try:
        plain = [dict(content[name]) for name in ("config", "sha256", "versions")]
        configuration = fingerprint.of_settings(plain[0])
        # What is no word can't be digested with the others.
        fingerprint.origin_of(plain[1])
    except (KeyError, TypeError, ValueError) as error:
        lacking = "settings, digests or versions are lacking"
        raise RunFolderError(f"{path} is damaged: {lacking}") from error
    stored = StoredConfig(*plain)
    if stored.sha256.get(fingerprint.CONFIGURATION) != configuration:
        raise RunFolderError(f"{path}: its settings were edited")
    return stored


class Difference(NamedTuple):
    """Something that decides the numbers of a run and is not as it was then."""

    name: str
    refusal: str
    """Why the run can't be continued, in words that follow the file's path."""


def differences(stored: StoredConfig, config: TrainConfig) -> Iterator[Difference]:
    """What decides the numbers of a run and is not as it was then.

    Args:
        stored: what its file says.
        config: the same, understood.

    Raises:
        ProspectError: if something that decides them is missing.
    """
    for package, now in provenance.installed_versions(PACKAGES).items():
        had = stored.versions.get(package)
        if had != now:
            refusal = (
                f" was made with {package} {had}, {now} is installed: the run can't be "
                "continued exactly"
            )
            yield Difference(package, refusal)
    for name, digest in fingerprint.digests(config).items():
        if name not in stored.sha256:
            refusal = f" does not note its {name}; the run can't be continued"
            yield Difference(name, refusal)
        elif stored.sha256[name] != digest:
            refusal = (
                f": {name} has changed since the run began; the run can't be continued"
            )
            yield Difference(name, refusal)


def check_continuable(path: Path, stored: StoredConfig, config: TrainConfig) -> None:
    """Refuse what other versions or model files would go on with in another way.

    Args:
        path: the file, for the messages.
        stored: what is in it.
        config: the same, understood.

    Raises:
        RunFolderError: with the first difference.
    """
    for first in differences(stored, config):
        raise RunFolderError(f"{path}{first.refusal}")
