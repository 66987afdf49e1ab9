"""Live physics against recorded: do live runs lie among those of the same size?

As many recorded runs as there are live ones are drawn again and again, and their mean
taken. With m and s the mean and standard deviation of these means in each set of ten
trials, 95 % of them have

    max over sets |mean - m| / s <= c ,

so that m +- c s is a simultaneous 95 % band of the mean (the studentised maximum; for
instance Montiel Olea and Plagborg-Moller, Journal of Applied Econometrics 34, 2019). If
live runs were of the same kind, their mean would leave it anywhere in 5 % of studies.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray
from pyarrow.lib import ArrowException

from prospect_mj import tables
from prospect_mj.errors import ForeignTable, RunFolderError
from prospect_mj.experiment import fingerprint
from prospect_mj.experiment.config import TrainConfig
from prospect_mj.experiment.learning_curve import BLOCK
from prospect_mj.experiment.paper.bands import LEVEL, RESAMPLES, Floats, in_sets
from prospect_mj.experiment.paper.population import Population
from prospect_mj.experiment.paper.scenario import PopulationSettings
from prospect_mj.experiment.records import TRIAL_SCHEMA
from prospect_mj.experiment.run_folder import CONFIG, TRIALS, read_config
from prospect_mj.recording.key import RecordingKey

SCHEMA = pa.schema(
    {
        "trial": pa.int32(),
        "live": pa.float64(),
        "recorded": pa.float64(),
        "low": pa.float64(),
        "high": pa.float64(),
    }
)
"""A set of ten trials: its first trial, mean actions of the live runs, of all recorded
runs, the simultaneous band of means of as many recorded runs."""

_LEARNING = (
    "supervisor",
    "shaping",
    "max_actions",
    "bootstrap_at_truncation",
    "features",
    "learner",
)
"""Settings that training and populations have in common."""
_FIXED = {"image_noise": 0.0, "presentations": None}
"""What in training can't be set."""
_PHYSICS = ("object_pose", "gross_motion", "grid_cells")


@dataclass(frozen=True)
class FoundRuns:
    """What was found of live runs."""

    n_actions: NDArray[np.int64]
    """(runs, trials) [actions] of the complete ones."""
    unfinished: int
    """Runs that have too few trials yet."""


@dataclass(frozen=True)
class LiveCheck:
    """How live runs compare with recorded ones."""

    table: pa.Table
    """Under `SCHEMA`."""
    runs: int
    """Live runs compared."""
    unfinished: int
    """Live runs left out, as they have too few trials yet."""
    inside: float
    """Share of sets in which the live mean is inside of the band."""

    @property
    def agrees(self) -> bool:
        """Whether it is so in all of them."""
        return self.inside == 1.0


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
        RunFolderError: if there is no run, one is damaged, has other settings, sources
            or models, or the same seed as another.
    """
    paths = sorted(path.parent for path in folder.glob(f"*/{CONFIG}"))
    if not paths:
        raise RunFolderError(f"{folder} has no run folder in it")
    configs = {path: read_config(path) for path in paths}
    for path, config in configs.items():
        _check_same(path, config, settings, physics)
    _check_seeds(configs)
    runs = [_n_actions(path, config) for path, config in configs.items()]
    complete = [run[:trials] for run in runs if len(run) >= trials]
    stacked = np.array(complete, np.int64).reshape(-1, trials)
    return FoundRuns(stacked, len(runs) - len(complete))


def check(live: FoundRuns, recorded: Population, rng: np.random.Generator) -> LiveCheck:
    """Hold the mean of live runs against the band of recorded ones.

    Args:
        live: what was found; without a complete run nothing is compared.
        recorded: learners of the same scenario and settings.
        rng: for resampling.
    """
    if not len(live.n_actions):
        return LiveCheck(SCHEMA.empty_table(), 0, live.unfinished, 0.0)
    of_runs = in_sets(recorded.n_actions).mean(axis=2)
    low, high = simultaneous_band(of_runs, len(live.n_actions), rng)
    mean = in_sets(live.n_actions).mean(axis=(0, 2))
    columns = {
        "trial": BLOCK * np.arange(len(mean)),
        "live": mean,
        "recorded": of_runs.mean(axis=0),
        "low": low,
        "high": high,
    }
    inside = float(np.mean((low <= mean) & (mean <= high)))
    made = pa.table(columns, schema=SCHEMA)
    return LiveCheck(made, len(live.n_actions), live.unfinished, inside)


def simultaneous_band(
    curves: Floats, size: int, rng: np.random.Generator, n: int = RESAMPLES
) -> Floats:
    """Band that the mean of some curves stays within as a whole; see the module.

    Args:
        curves: (runs, s).
        size: curves per mean.
        rng: draws them.
        n: number of means.

    Returns:
        (2, s), lower and upper bounds.
    """
    drawn = rng.integers(len(curves), size=(n, size))
    means = np.stack([curves[rows].mean(axis=0) for rows in drawn])
    centre, deviation = means.mean(axis=0), means.std(axis=0)
    # Where all curves agree there is no deviation, and the band has no width.
    scaled = np.abs(means - centre) / np.where(deviation > 0, deviation, 1.0)
    factor = np.quantile(scaled.max(axis=1), LEVEL)
    return centre + np.outer([-factor, factor], deviation)


def _check_same(
    path: Path,
    config: TrainConfig,
    settings: PopulationSettings,
    physics: RecordingKey,
) -> None:
    """Refuse a run that no population is like, or that saw other physics."""
    pairs = [(n, getattr(config, n), getattr(settings, n)) for n in _LEARNING]
    pairs += [(n, value, getattr(settings, n)) for n, value in _FIXED.items()]
    pairs += [(n, getattr(config, n), getattr(physics.config, n)) for n in _PHYSICS]
    pairs += [("physics", config.physics, "live"), ("pretrain", config.pretrain, 0)]
    for name, found, wanted in pairs:
        if found != wanted:
            raise RunFolderError(
                f"{path} can't be compared: its {name.replace('_', ' ')} is {found}, "
                f"not {wanted}"
            )
    digests = fingerprint.digests(config)
    for name, recorded in physics.sha256.items():
        if digests.get(name) != recorded:
            raise RunFolderError(
                f"{path} can't be compared: {name} changed between the recording and it"
            )


def _check_seeds(configs: Mapping[Path, TrainConfig]) -> None:
    """Refuse a run that is there twice, as a copied folder is."""
    first: dict[int, Path] = {}
    for path, config in configs.items():
        if config.seed in first:
            raise RunFolderError(
                f"{path} can't be compared: it has the seed of "
                f"{first[config.seed].name}, {config.seed}"
            )
        first[config.seed] = path


def _n_actions(path: Path, config: TrainConfig) -> NDArray[np.int64]:
    """Actions per trial of a run, as far as it has come."""
    file = path / TRIALS
    if not file.exists():
        return np.empty(0, np.int64)
    try:
        trials = tables.read(file, TRIAL_SCHEMA, fingerprint.origin(config), "run")
    except ForeignTable as error:
        raise RunFolderError(str(error)) from error
    except (OSError, ValueError, ArrowException) as error:
        raise RunFolderError(f"{file} can't be read: it is damaged") from error
    return trials["n_actions"].to_numpy().astype(np.int64)
