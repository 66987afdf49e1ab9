"""Digests by which a run is known again: of its configuration and its model files."""

import json

from prospect_mj.experiment.config import TrainConfig
from prospect_mj.recording.provenance import model_digests, sha256

CONFIGURATION = "configuration"


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
    return {CONFIGURATION: sha256(plain)} | model_digests()


def origin(config: TrainConfig) -> str:
    """One digest of all of `digests`, which ties the other files to the run."""
    return sha256(json.dumps(digests(config), sort_keys=True).encode())
