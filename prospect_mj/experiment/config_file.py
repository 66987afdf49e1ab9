"""config.yaml: what a run is, and which software and model files made it."""

import json
from dataclasses import asdict
from pathlib import Path

import yaml

from prospect_mj.errors import ProspectError, RunFolderError
from prospect_mj.experiment import fingerprint
from prospect_mj.experiment.config import TrainConfig
from prospect_mj.recording import provenance
from prospect_mj.storage import read_yaml, replace_file

NAME = "config.yaml"

_FORMAT = 1

PACKAGES = ("prospect-mj", *provenance.PACKAGES, "gymnasium")
"""A run is bit-identical only within one version of each of these."""


def write(path: Path, config: TrainConfig) -> None:
    """Write `config`, its digests and the installed versions, all or nothing."""
    content = {
        "prospect_mj_run": _FORMAT,
        # By way of JSON, as YAML knows no number that is only derived from float.
        "config": json.loads(json.dumps(asdict(config))),
        "sha256": fingerprint.digests(config),
        "versions": provenance.installed_versions(PACKAGES),
        "platform": provenance.machine(),
    }
    replace_file(path, yaml.safe_dump(content, sort_keys=False).encode())


def read(path: Path) -> TrainConfig:
    """Read a configuration that this software can continue exactly.

    Raises:
        RunFolderError: if the file is unreadable, foreign, edited, or of other
            versions or model files.
    """
    content = read_yaml(path, RunFolderError)
    if content.get("prospect_mj_run") != _FORMAT:
        raise RunFolderError(f"{path} is not the configuration of a run")
    try:
        config = TrainConfig.from_dict(content["config"])
        stored = dict(content["versions"])
        sha256 = dict(content["sha256"])
    except (ProspectError, KeyError, TypeError, ValueError) as error:
        raise RunFolderError(f"{path} is damaged: {error}") from error
    _check_versions(path, stored)
    _check_digests(path, sha256, config)
    return config


def _check_versions(path: Path, stored: dict[str, str]) -> None:
    for package, installed in provenance.installed_versions(PACKAGES).items():
        if stored.get(package) != installed:
            raise RunFolderError(
                f"{path} was made with {package} {stored.get(package)}, "
                f"{installed} is installed: the run can't be continued exactly"
            )


def _check_digests(path: Path, stored: dict[str, str], config: TrainConfig) -> None:
    for name, present in fingerprint.digests(config).items():
        if stored.get(name) != present:
            changed = (
                "its settings were edited"
                if name == fingerprint.CONFIGURATION
                else f"{name} has changed since the run began"
            )
            raise RunFolderError(f"{path}: {changed}; the run can't be continued")
