"""Digests by which a run is known again: of its configuration, models and recording."""

import json
from collections.abc import Mapping
from dataclasses import asdict
from pathlib import Path
from typing import Any

from prospect_mj import paths
from prospect_mj.experiment.run.config import TrainConfig
from prospect_mj.recording import files
from prospect_mj.recording.key import RecordingKey
from prospect_mj.recording.presenter import GrowingPresenter
from prospect_mj.recording.provenance import (
    code_digest,
    model_digests,
    sha256,
    source_digest,
)
from prospect_mj.recording.worlds import WORLDS

_PACKAGE = Path(paths.__file__).parent

CONFIGURATION = "configuration"
LEARNER = "learner"
RECORDING = "recording"
WORLD = "world"
PRESENTATIONS = "number of presentations to draw from"
_SHARED_CODE = (
    "agent/choice.py",
    "agent/experience.py",
    "agent/failed_actions.py",
    "agent/features.py",
    "agent/haptics.py",
    "agent/observation.py",
)
_OWN_CODE = {
    "linear": ("agent/linear_q.py",),
    "replay": ("agent/linear_q.py", "agent/replay_q.py"),
    "table": ("agent/action_numbers.py", "agent/table_q.py"),
    "discovery": ("agent/action_numbers.py", "agent/discovery/*.py"),
}


def digests(config: TrainConfig) -> dict[str, str]:
    """SHA-256 of everything that a run must not change while it lasts.

    Args:
        config: the run; `trials` does not count, as a run may be made longer.

    Returns:
        Hexadecimal digest of the configuration, of each model file, of the learner's
        code, and of recorded physics or of the sources and the world of live physics,
        by name.

    Raises:
        MissingFile: if a model file is missing.
        RecordingError: if there is no recording where there should be one.
    """
    learner = learner_digest(config.learner.name)
    found = {CONFIGURATION: of_settings(asdict(config)), LEARNER: learner}
    found |= model_digests()
    if config.physics == "recorded":
        return found | _recording_digests(config)
    world = {WORLD: WORLDS[config.world].digest}
    return found | {"sources": source_digest()} | world


def learner_code(name: str) -> tuple[str, ...]:
    """What decides how a learner learns: files of the package, in order.

    Args:
        name: of the learner.
    """
    patterns = _SHARED_CODE + _OWN_CODE[name]
    found = (path for pattern in patterns for path in sorted(_PACKAGE.glob(pattern)))
    return tuple(path.relative_to(_PACKAGE).as_posix() for path in found)


def learner_digest(name: str) -> str:
    """SHA-256 of a learner's code; comments, docstrings and layout don't count."""
    files_of_it = learner_code(name)
    return code_digest((n, (_PACKAGE / n).read_text("utf-8")) for n in files_of_it)


def of_settings(settings: Mapping[str, Any]) -> str:
    """SHA-256 of a run's settings as plain numbers, words and mappings of them."""
    lasting = {name: value for name, value in settings.items() if name != "trials"}
    return sha256(json.dumps(lasting, sort_keys=True).encode())


def origin(config: TrainConfig) -> str:
    """One digest of all of `digests`, which ties the other files to the run."""
    return origin_of(digests(config))


def origin_of(found: Mapping[str, str]) -> str:
    """The same of digests that are there already."""
    return sha256(json.dumps(dict(found), sort_keys=True).encode())


def _recording_digests(config: TrainConfig) -> dict[str, str]:
    """Of the outcomes; where they may become more, of what decides and draws them."""
    folder = config.recording_folder
    key = RecordingKey.read(folder)
    if config.grow:
        drawn_from = GrowingPresenter(folder).presentations
        digest = sha256(str(drawn_from).encode())
        return {RECORDING: key.digest, PRESENTATIONS: digest}
    trees = (path.read_bytes() for path in files.tree_files(folder))
    return {RECORDING: sha256(b"".join([key.digest.encode(), *trees]))}
