"""Run folders of live physics, read to be compared with recorded runs.

They are read only, which later software can do as well. What must be the recording's is
what a run was made with, not what is there now: a run counts by the settings, digests
and versions in its folder.
"""

import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from pyarrow.lib import ArrowException

from prospect_mj import tables
from prospect_mj.errors import ForeignTable, RunFolderError
from prospect_mj.experiment.populations.scenario import PopulationSettings
from prospect_mj.experiment.run import config_file, fingerprint
from prospect_mj.experiment.run.config_file import StoredConfig
from prospect_mj.experiment.run.records import TRIAL_SCHEMA
from prospect_mj.experiment.run.run_files import CONFIG, TRIALS
from prospect_mj.recording.key import RecordingKey

_LEARNING = (
    "supervisor",
    "shaping",
    "max_actions",
    "bootstrap_at_truncation",
    "features",
    "learner",
)
"""Settings that training and populations have in common."""
_PHYSICS = ("object_pose", "gross_motion", "grid_cells")


@dataclass(frozen=True)
class FoundRuns:
    """What was found of live runs."""

    n_actions: NDArray[np.int64]
    """(runs, trials) [actions] of the complete ones."""
    unfinished: int
    """Runs that have too few trials yet."""


def read_live(
    folder: Path, trials: int, settings: PopulationSettings, physics: RecordingKey
) -> FoundRuns:
    """Read what there is of live runs.

    Args:
        folder: of run folders; others in it are left alone.
        trials: what a run must have to count, the first so many are used.
        settings: of the recorded population; live runs must have the same.
        physics: what was recorded; the same.

    Raises:
        RunFolderError: if there is no run, one is damaged, has other settings, sources,
            models or versions, or the same seed as another.
    """
    stored = {path: config_file.read_stored(path / CONFIG) for path in _paths(folder)}
    wanted = _wanted(settings, physics)
    for path, config in stored.items():
        _check_same(path, config, wanted, physics)
    _check_seeds(stored)
    runs = [_n_actions(path, config) for path, config in stored.items()]
    complete = [run[:trials] for run in runs if len(run) >= trials]
    stacked = np.array(complete, np.int64).reshape(-1, trials)
    return FoundRuns(stacked, len(runs) - len(complete))


def _paths(folder: Path) -> list[Path]:
    if not folder.is_dir():
        state = "not a folder" if folder.exists() else "not there"
        raise RunFolderError(f"{folder}, where live runs should be, is {state}")
    paths = sorted(path.parent for path in folder.glob(f"*/{CONFIG}"))
    if not paths:
        raise RunFolderError(f"{folder} has no run folder in it")
    return paths


def _wanted(settings: PopulationSettings, physics: RecordingKey) -> dict[str, Any]:
    """What a run's settings must be, as its folder would have them."""
    learning, recorded = asdict(settings), asdict(physics.config)
    wanted = {name: learning[name] for name in _LEARNING}
    wanted |= {name: recorded[name] for name in _PHYSICS}
    return json.loads(json.dumps(wanted | {"physics": "live", "pretrain": 0}))


def _check_same(
    path: Path,
    stored: StoredConfig,
    wanted: Mapping[str, Any],
    physics: RecordingKey,
) -> None:
    """Refuse a run that no population is like, or that saw other physics."""
    refused = f"{path} can't be compared:"
    for name, value in wanted.items():
        if (found := stored.settings.get(name)) != value:
            words = name.replace("_", " ")
            raise RunFolderError(f"{refused} its {words} is {found}, not {value}")
    for name, recorded in physics.sha256.items():
        if stored.sha256.get(name) != recorded:
            raise RunFolderError(
                f"{refused} {name} changed between the recording and it"
            )
    # Older runs did not note it.
    learner = fingerprint.learner_digest("linear")
    if stored.sha256.get(fingerprint.LEARNER, learner) != learner:
        raise RunFolderError(f"{refused} the learner's code changed since")
    for package, recorded in physics.versions.items():
        if (found := stored.versions.get(package)) != recorded:
            raise RunFolderError(
                f"{refused} it was made with {package} {found}, the recording with "
                f"{recorded}"
            )


def _check_seeds(stored: Mapping[Path, StoredConfig]) -> None:
    """Refuse a run that is there twice, as a copied folder is."""
    first: dict[int, Path] = {}
    for path, config in stored.items():
        seed = config.settings.get("seed")
        if seed in first:
            raise RunFolderError(
                f"{path} can't be compared: it has the seed of {first[seed].name}, "
                f"{seed}"
            )
        first[seed] = path


def _n_actions(path: Path, stored: StoredConfig) -> NDArray[np.int64]:
    """Actions per trial of a run, as far as it has come."""
    file = path / TRIALS
    if not file.exists():
        return np.empty(0, np.int64)
    origin = fingerprint.origin_of(stored.sha256)
    try:
        trials = tables.read(file, TRIAL_SCHEMA, origin, "run")
    except ForeignTable as error:
        raise RunFolderError(str(error)) from error
    except (OSError, ValueError, ArrowException) as error:
        raise RunFolderError(f"{file} can't be read: it is damaged") from error
    return trials["n_actions"].to_numpy().astype(np.int64)
