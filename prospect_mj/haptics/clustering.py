"""Clustering of trajectories into models, by expectation and maximisation.

A whole trajectory belongs to a model, with a chance r that its samples decide together
(Dempster, Laird and Rubin, Journal of the Royal Statistical Society B 39, 1977). The
first means are drawn far from each other (Arthur and Vassilvitskii, k-means++: The
advantages of careful seeding, 2007); the best of several starts counts.
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from prospect_mj.checks import check_integer, check_number
from prospect_mj.errors import InvalidValue
from prospect_mj.haptics.models import STAGES, TrajectoryModels, nested, stages
from prospect_mj.haptics.phase_portrait import together

_Floats = NDArray[np.float64]
_LEAST_WEIGHT = 1e-6
_LEAST_COUNT = 1e-3
"""Samples of a model in a stage below which it has none there."""
_SMALLEST = 1e-9
"""Deviation of samples that are all equal, in their own unit."""


@dataclass(frozen=True)
class ClusterSettings:
    """How trajectories are clustered."""

    models: int = 6
    """K, number of models: the one at which models of halves of the recorded grasps
    agree best (`agreement`)."""
    starts: int = 10
    """Of which the best counts."""
    floor: float = 0.1
    """Least standard deviation of a model [that of all samples of the stage]. The
    hand-overs of a jar are nearly alike, and a density on them alone would grow without
    bound."""
    tolerance: float = 1e-6
    """Gain of log-likelihood below which it has converged [per trajectory]."""
    steps: int = 500
    """At most, of one start."""

    def __post_init__(self) -> None:
        """Refuse numbers that make no clusters."""
        check_integer("number of haptic models", self.models, 1, 100)
        check_integer("starts", self.starts, 1, 10_000)
        check_number("floor of deviations", self.floor, 0, 1, above=True)
        check_number("tolerance", self.tolerance, 0, 1, above=True)
        check_integer("steps", self.steps, 1, 1_000_000)


class Fit(NamedTuple):
    """What the clustering came to."""

    models: TrajectoryModels
    log_likelihood: float
    """Of all trajectories together [nats]."""
    bic: float
    """Bayesian information criterion, a trajectory counting as one datum: the least is
    best (Schwarz, Annals of Statistics 6, 1978)."""


class _Data(NamedTuple):
    samples: _Floats
    """(n, 3)"""
    stage: NDArray[np.bool_]
    """(2, n): whether each sample belongs to a stage."""
    starts: NDArray[np.intp]
    """(t,): where each trajectory begins."""
    lengths: NDArray[np.intp]
    """(t,) [samples]."""
    middle: _Floats
    """(2, 2): mean residual and rate of all samples of each stage."""
    scale: _Floats
    """(2, 2): their standard deviations."""


def fit(
    trajectories: list[_Floats], settings: ClusterSettings, rng: np.random.Generator
) -> Fit:
    """Cluster trajectories into models.

    Args:
        trajectories: each (k, 3), as `phase_samples` gives them.
        settings: of the clustering.
        rng: draws the starts.

    Raises:
        InvalidValue: if there are fewer trajectories than models, or one is empty.
    """
    samples, starts = together(trajectories)
    n_trajectories, n_models = len(starts), settings.models
    if n_trajectories < n_models:
        raise InvalidValue("number of trajectories", n_trajectories, f">= {n_models}")
    data = _described(samples, starts)
    found = [_climb(data, settings, rng) for _ in range(settings.starts)]
    models, likelihood = max(found, key=lambda one: one[1])
    # Means and deviations on two axes of each stage, and weights that sum to one.
    n_free = n_models * (4 * np.count_nonzero(data.stage.any(axis=1)) + 1) - 1
    bic = n_free * np.log(n_trajectories) - 2 * likelihood
    return Fit(_in_order(models), likelihood, float(bic))


def _described(samples: _Floats, starts: NDArray[np.intp]) -> _Data:
    stage = stages(samples) == np.arange(STAGES)[:, None]
    # A stage that no grasp came to is like all the others together.
    parts = [samples[of_it if of_it.any() else slice(None), :2] for of_it in stage]
    middle = np.stack([part.mean(axis=0) for part in parts])
    scale = np.maximum([part.std(axis=0) for part in parts], _SMALLEST)
    lengths = np.diff([*starts, len(samples)])
    return _Data(samples, stage, starts, lengths, middle, scale)


def _climb(
    data: _Data, settings: ClusterSettings, rng: np.random.Generator
) -> tuple[TrajectoryModels, float]:
    """Models and log-likelihood from one start."""
    models, before = _started(data, settings, rng), -np.inf
    for _ in range(settings.steps):
        joint = _joint(data, models)
        total = _log_sums(joint)
        likelihood = float(total.sum())
        if likelihood - before < settings.tolerance * len(total):
            break
        before = likelihood
        models = _maximised(data, np.exp(joint - total[:, None]), settings)
    return models, float(_log_sums(_joint(data, models)).sum())


def _log_sums(joint: _Floats) -> _Floats:
    """(t,): log chance of each trajectory, given that of each model and it (t, K)."""
    # Only here: settings may hold models, and they are made without it.
    from scipy.special import logsumexp

    return logsumexp(joint, axis=1)


def _started(
    data: _Data, settings: ClusterSettings, rng: np.random.Generator
) -> TrajectoryModels:
    """Means at trajectories that are far from each other, equal deviations."""
    first = data.samples[data.starts, :2] / data.scale[0]
    chosen = [int(rng.integers(len(first)))]
    while len(chosen) < settings.models:
        away = np.min([((first - first[i]) ** 2).sum(axis=1) for i in chosen], axis=0)
        # Where all are equal any will do.
        chance = away / away.sum() if away.any() else None
        chosen.append(int(rng.choice(len(first), p=chance)))
    n_models = settings.models
    mean = np.tile(data.middle, (n_models, 1, 1))
    mean[:, 0] = data.samples[data.starts[chosen], :2]
    wide = np.tile(data.scale / [[n_models], [1]], (n_models, 1, 1))
    return _models(np.full(n_models, 1 / n_models), mean, wide)


def _joint(data: _Data, models: TrajectoryModels) -> _Floats:
    """(t, K): log chance of model and trajectory."""
    densities = models.log_likelihoods(data.samples)
    return np.add.reduceat(densities, data.starts, axis=0) + np.log(models.weight)


def _maximised(
    data: _Data, chances: _Floats, settings: ClusterSettings
) -> TrajectoryModels:
    """The models that fit best, given the chances (t, K) that they are whose."""
    own = np.repeat(chances, data.lengths, axis=0)
    shares = own.T[:, None] * data.stage
    counts = shares.sum(axis=2)[:, :, None]
    # A model whose grasps never come to a stage expects anything there.
    there = counts > _LEAST_COUNT
    counts = np.where(there, counts, 1.0)
    portrait = data.samples[:, :2]
    mean = np.where(there, shares @ portrait / counts, data.middle)
    squares = (portrait - mean[:, :, None]) ** 2
    variance = np.einsum("ksn,ksna->ksa", shares, squares) / counts
    spread = np.where(there, np.sqrt(variance), data.scale)
    deviation = np.maximum(spread, settings.floor * data.scale)
    weight = np.maximum(chances.mean(axis=0), _LEAST_WEIGHT)
    return _models(weight / weight.sum(), mean, deviation)


def _in_order(models: TrajectoryModels) -> TrajectoryModels:
    order = np.argsort([mean[0][0] for mean in models.mean], kind="stable")
    parts = (models.weight, models.mean, models.deviation)
    return _models(*(np.array(part)[order] for part in parts))


def _models(weight: _Floats, mean: _Floats, deviation: _Floats) -> TrajectoryModels:
    paths = (nested(part.tolist()) for part in (mean, deviation))
    return TrajectoryModels(tuple(weight.tolist()), *paths)
