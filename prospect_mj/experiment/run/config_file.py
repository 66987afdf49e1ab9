"""config.yaml: what a run is, and which software and model files made it."""

import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

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
    except (KeyError, TypeError, ValueError) as error:
        lacking = "settings, digests or versions are lacking"
        raise RunFolderError(f"{path} is damaged: {lacking}") from error
    stored = StoredConfig(*plain)
    if stored.sha256.get(fingerprint.CONFIGURATION) != configuration:
        raise RunFolderError(f"{path}: its settings were edited")
    return stored


def differences(stored: StoredConfig, config: TrainConfig) -> list[str]:
    """What decides the numbers of a run and is not as it was then.

    Raises:
        ProspectError: if something that decides them is missing.
    """
    installed = provenance.installed_versions(PACKAGES)
    now = fingerprint.digests(config)
    return [
        *(p for p, version in installed.items() if stored.versions.get(p) != version),
        *(name for name, digest in now.items() if stored.sha256.get(name) != digest),
    ]


def check_continuable(path: Path, stored: StoredConfig, config: TrainConfig) -> None:
    """Refuse what other versions or model files would go on with in another way.

    Args:
        path: the file, for the messages.
        stored: what is in it.
        config: the same, understood.

    Raises:
        RunFolderError: with the first difference.
    """
    _check_versions(path, stored.versions)
    _check_digests(path, stored.sha256, config)


def _check_versions(path: Path, stored: Mapping[str, str]) -> None:
    for package, installed in provenance.installed_versions(PACKAGES).items():
        if stored.get(package) != installed:
            raise RunFolderError(
                f"{path} was made with {package} {stored.get(package)}, "
                f"{installed} is installed: the run can't be continued exactly"
            )


def _check_digests(path: Path, stored: Mapping[str, str], config: TrainConfig) -> None:
    for name, present in fingerprint.digests(config).items():
        if name not in stored:
            raise RunFolderError(
                f"{path} does not note its {name}; the run can't be continued"
            )
        if stored[name] != present:
            raise RunFolderError(
                f"{path}: {name} has changed since the run began; "
                "the run can't be continued"
            )
