"""Models of trajectories: what the categories are, and how well a grasp fits them.

A model is a short path through the phase portrait: a normal density for the first
probe of a grasp and another one for those after a correction, the portrait's two axes
independent. The samples of a grasp are taken as independent, too, so that

    log P(k, x_1 .. x_n) = log w_k + sum_t log N(x_t; mean_kp, deviation_kp)

with p = p(t), the stage that sample t belongs to.
Successive samples are nearly equal in truth: the chances are surer than they should be,
but the most likely model is the same.
"""

import json
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from prospect_mj.errors import InvalidValue
from prospect_mj.haptics.phase_portrait import together
from prospect_mj.storage import replace_file

STAGES = 2
"""Of a path: the first probe, and all later ones."""

_HALF_LOG_2_PI = np.log(2 * np.pi) / 2
_ROUNDED = 1e-3
"""How far from 1 the sum of weights may be, that someone wrote by hand."""

_Pairs = tuple[tuple[float, float], ...]


@dataclass(frozen=True)
class TrajectoryModels:
    """K models, by their mean residual at the first probe from the least."""

    weight: tuple[float, ...]
    """(K,): share of all grasps."""
    mean: tuple[_Pairs, ...]
    """(K, 2, 2): of each stage, residual [1] and rate [1/s]."""
    deviation: tuple[_Pairs, ...]
    """(K, 2, 2): standard deviations [1] and [1/s]."""

    def __post_init__(self) -> None:
        """Refuse numbers that make no densities."""
        shapes = [np.shape(a) for a in (self.weight, self.mean, self.deviation)]
        n_models = len(self.weight)
        path = n_models, STAGES, 2
        if shapes != [(n_models,), path, path] or not n_models:
            expected = "(K,), (K, 2, 2), (K, 2, 2)"
            raise InvalidValue("shapes of models", shapes, expected)
        positive = np.concatenate([self.weight, np.ravel(self.deviation)])
        numbers = np.concatenate([positive, np.ravel(self.mean)])
        if not np.isfinite(numbers).all() or positive.min() <= 0:
            expected = "finite, weights and deviations above 0"
            raise InvalidValue("numbers of models", numbers.tolist(), expected)
        if not np.isclose(np.sum(self.weight), 1.0, atol=_ROUNDED, rtol=0):
            raise InvalidValue("weights of models", self.weight, "a sum of 1")

    def __len__(self) -> int:
        """K."""
        return len(self.weight)

    def log_likelihoods(self, samples: NDArray[np.float64]) -> NDArray[np.float64]:
        """(n, K): log density of each sample (n, 3) in each model."""
        stage = stages(samples)
        mean, deviation = (
            np.moveaxis(np.array(part)[:, stage], 0, 1)
            for part in (self.mean, self.deviation)
        )
        away = (samples[:, None, :2] - mean) / deviation
        return -(away**2 / 2 + np.log(deviation) + _HALF_LOG_2_PI).sum(axis=2)

    def write(self, path: Path) -> None:
        """Write them to a JSON file."""
        replace_file(path, f"{json.dumps(asdict(self), indent=2)}\n".encode())

    @classmethod
    def read(cls, path: Path) -> Self:
        """Read them from a JSON file.

        Raises:
            InvalidValue: if it holds none.
        """
        try:
            return cls.from_dict(json.loads(path.read_text(encoding="utf-8")))
        except (OSError, ValueError, TypeError, KeyError, RecursionError) as error:
            expected = f"a file of haptic models: {_reason(error)}"
            raise InvalidValue("haptic models", str(path), expected) from error

    @classmethod
    def from_dict(cls, plain: Mapping[str, Any]) -> Self:
        """The models that `dataclasses.asdict` made plain, by way of JSON or not.

        Raises:
            InvalidValue: if their numbers make no densities.
            TypeError, KeyError: if they are something else.
        """
        paths = (plain[name] for name in ("mean", "deviation"))
        return cls(tuple(plain["weight"]), *map(nested, paths))


def _reason(error: Exception) -> str:
    """Why a file has no models, for people."""
    if isinstance(error, OSError):
        return error.strerror or "it can't be read"
    if isinstance(error, KeyError):
        return f"it has no {error.args[0]!r}"
    if isinstance(error, json.JSONDecodeError | UnicodeDecodeError):
        return "it is not JSON"
    if isinstance(error, InvalidValue):
        return str(error)
    return "its fields are no numbers of models"


def stages(samples: NDArray[np.float64]) -> NDArray[np.intp]:
    """(n,): the stage of each sample (n, 3)."""
    return np.minimum(samples[:, 2], STAGES - 1).astype(np.intp)


def nested(paths: Sequence[Sequence[Sequence[float]]]) -> tuple[_Pairs, ...]:
    """Numbers (K, 2, 2) as tuples."""
    return tuple(tuple(map(tuple, path)) for path in paths)


def categories(
    trajectories: list[NDArray[np.float64]], models: TrajectoryModels
) -> NDArray[np.int64]:
    """(t,): the most likely model of each trajectory, by all its samples (k, 3)."""
    samples, starts = together(trajectories)
    evidence = np.add.reduceat(models.log_likelihoods(samples), starts, axis=0)
    return np.argmax(evidence + np.log(models.weight), axis=1)
