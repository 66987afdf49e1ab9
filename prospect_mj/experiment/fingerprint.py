"""Digests by which a run is known again: of its configuration and its model files."""

import hashlib
import json

from prospect_mj import paths
from prospect_mj.experiment.config import TrainConfig

CONFIGURATION = "configuration"

_MODEL_FILES = {
    "models/torso.xml": paths.torso_xml,
    "assets/jar.obj": paths.jar_obj,
    "assets/jar.png": paths.jar_png,
}


def digests(config: TrainConfig) -> dict[str, str]:
    """SHA-256 of everything that a run must not change while it lasts.

    Args:
        config: the run; `trials` does not count, as a run may be made longer.

    Returns:
        Hexadecimal digest of the configuration and of each model file, by name.

    Raises:
        MissingFile: if a model file is missing.
    """
    settings = config.as_dict()
    del settings["trials"]
    plain = json.dumps(settings, sort_keys=True).encode()
    found = {CONFIGURATION: _sha256(plain)}
    return found | {
        name: _sha256(path().read_bytes()) for name, path in _MODEL_FILES.items()
    }


def origin(config: TrainConfig) -> str:
    """One digest of all of `digests`, which ties the other files to the run."""
    return _sha256(json.dumps(digests(config), sort_keys=True).encode())


def _sha256(content: bytes) -> str:
    return hashlib.sha256(content).hexdigest()
