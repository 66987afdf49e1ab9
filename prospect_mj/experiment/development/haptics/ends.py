"""Which end is held, lid or body: how often it is told right, and by what.

What tells is learned on five sixths of the presentations and tried on the others, six
times in turn: never on a grasp that it has learned from.
Categories are found without knowing the ends: only their names, lid or body, come from
the ends that are more frequent in them. What they are compared with:

- the two bits, h_L and h_R, which say what hand holds the jar;
- the time that the fingers close until they touch, with a threshold halfway between the
  means of both ends. It is no part of the phase portrait, and told the ends to begin
  with: it shows what the hand's own posture has to say.

Grasps of one presentation share where the jar lies and what the eyes saw. So intervals
are as wide as if each presentation were a single grasp.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from prospect_mj.errors import RecordingError
from prospect_mj.experiment.development.haptics.grasp import (
    BODY,
    KINDS,
    LID,
    Grasp,
)
from prospect_mj.experiment.development.haptics.touch import BITS, CATEGORY
from prospect_mj.experiment.estimate import clustered_share
from prospect_mj.haptics import ClusterSettings, Fit, agreement, categories, fit

TOLD = pa.schema(
    {
        "jar": pa.string(),
        "kind": pa.string(),
        "by": pa.string(),
        "grasps": pa.int32(),
        "presentations": pa.int32(),
        "told": pa.float64(),
        "low": pa.float64(),
        "high": pa.float64(),
    }
)
"""Share of grasps [1] whose end is told right, with its 95 % interval."""
NUMBERS = pa.schema(
    {
        "jar": pa.string(),
        "models": pa.int32(),
        "bic": pa.float64(),
        "agreement": pa.float64(),
        "agreement_error": pa.float64(),
        "grasps": pa.int32(),
        "presentations": pa.int32(),
        "told": pa.float64(),
        "low": pa.float64(),
        "high": pa.float64(),
    }
)
"""For each number of models: the criterion on all grasps, how far the models of halves
agree with its standard error, and the share told right."""

FIRST_TOUCH, TIME = "category at first touch", "closing time"
BY = BITS, FIRST_TOUCH, CATEGORY, TIME
"""What tells the end."""
_FOLDS = 6
_SPLITS = 6
"""Into halves, whose models are compared."""
_OF_EACH = 4
"""Grasps for each model at least."""

_Ends = NDArray[np.int64]
_Predictor = Callable[[Sequence[Grasp]], _Ends]


class _Rule(NamedTuple):
    """What says the end: by a number of each grasp, the end that it stands for."""

    number: _Predictor
    end: _Ends

    def tell(self, grasps: Sequence[Grasp]) -> _Ends:
        return self.end[self.number(grasps)]


def told(
    jar: str,
    grasps: Sequence[Grasp],
    settings: ClusterSettings,
    rng: np.random.Generator,
) -> pa.Table:
    """How often each of the four tells the end, by kind of grasp; under `TOLD`."""
    right = _right(grasps, settings, rng)
    kinds = np.array([grasp.kind for grasp in grasps])
    rows = [
        {"jar": jar, "kind": kind, "by": by, **_share(hits, grasps, kinds == kind)}
        for by, hits in right.items()
        for kind in KINDS
        if (kinds == kind).any()
    ]
    return pa.Table.from_pylist(rows, schema=TOLD)


def numbers(
    jar: str,
    grasps: Sequence[Grasp],
    fits: Mapping[int, Fit],
    settings: ClusterSettings,
    rng: np.random.Generator,
) -> pa.Table:
    """What each number of models comes to that has grasps enough; under `NUMBERS`.

    Args:
        jar: its name.
        grasps: of both kinds.
        fits: to all of them, by the number of models.
        settings: of clusterings of some of them, but for the number of models.
        rng: draws the starts.
    """
    rows, all_of_them = [], np.ones(len(grasps), np.bool_)
    for n_models, whole in fits.items():
        if n_models * _OF_EACH > len(grasps):
            continue
        size = replace(settings, models=n_models)
        hits = _right(grasps, size, rng)[CATEGORY]
        rows.append(
            {
                "jar": jar,
                "models": n_models,
                "bic": whole.bic,
                **_agreement(grasps, size, rng),
                **_share(hits, grasps, all_of_them),
            }
        )
    return pa.Table.from_pylist(rows, schema=NUMBERS)


def clustered(
    grasps: Sequence[Grasp], settings: ClusterSettings, rng: np.random.Generator
) -> Fit:
    """The models of some grasps."""
    return fit([grasp.samples for grasp in grasps], settings, rng)


def _agreement(
    grasps: Sequence[Grasp], settings: ClusterSettings, rng: np.random.Generator
) -> dict[str, float]:
    """How far the models of two halves of the presentations agree."""
    presented = [f"{grasp.orientation} {grasp.presentation}" for grasp in grasps]
    _, group = np.unique(presented, return_inverse=True)
    samples = [grasp.samples for grasp in grasps]
    mean, error = agreement(samples, group, settings, _SPLITS, rng)
    return {"agreement": mean, "agreement_error": error}


def _right(
    grasps: Sequence[Grasp], settings: ClusterSettings, rng: np.random.Generator
) -> dict[str, NDArray[np.bool_]]:
    """By what tells: (g,), whether it says which end each grasp is at."""
    fold = np.array([grasp.presentation % _FOLDS for grasp in grasps])
    end = _ends(grasps)
    right = {by: np.zeros(len(grasps), np.bool_) for by in BY}
    for tried in np.unique(fold):
        learned = [g for g, part in zip(grasps, fold, strict=True) if part != tried]
        others = [g for g, part in zip(grasps, fold, strict=True) if part == tried]
        for by, rule in _rules(learned, settings, rng).items():
            right[by][fold == tried] = rule.tell(others) == end[fold == tried]
    return right


def _rules(
    grasps: Sequence[Grasp], settings: ClusterSettings, rng: np.random.Generator
) -> dict[str, _Rule]:
    """What tells, learned from some grasps."""
    models = clustered(grasps, settings, rng).models
    times, end = _times(grasps), _ends(grasps)
    if len(np.unique(end)) < len((BODY, LID)):
        raise RecordingError("too few grasps: one of the ends was never held")
    limit = (times[end == BODY].mean() + times[end == LID].mean()) / 2
    by: dict[str, _Predictor] = {
        BITS: lambda some: np.array([int(g.hand == "right") for g in some]),
        FIRST_TOUCH: lambda some: categories([g.samples[:1] for g in some], models),
        CATEGORY: lambda some: categories([g.samples for g in some], models),
        TIME: lambda some: (_times(some) > limit).astype(np.int64),
    }
    return {
        name: _Rule(number, _more_frequent(number(grasps), end, settings.models))
        for name, number in by.items()
    }


def _more_frequent(number: _Ends, end: _Ends, n_models: int) -> _Ends:
    """The end that is more frequent among the grasps of each number; BODY in a tie."""
    counts = np.zeros((max(n_models, 2), 2), np.int64)
    np.add.at(counts, (number, end), 1)
    return counts.argmax(axis=1)


def _ends(grasps: Sequence[Grasp]) -> _Ends:
    return np.array([grasp.end for grasp in grasps])


def _times(grasps: Sequence[Grasp]) -> NDArray[np.float64]:
    """(g,): when all three fingers touch [s]."""
    return np.array([grasp.felt[0, 0] for grasp in grasps], np.float64)


def _share(
    hits: NDArray[np.bool_], grasps: Sequence[Grasp], chosen: NDArray[np.bool_]
) -> dict[str, float]:
    """How often some of the grasps are told right.

    Args:
        hits: (g,), whether each is.
        grasps: all of them.
        chosen: (g,), those that are counted.
    """
    presented = {
        (grasp.orientation, grasp.presentation)
        for grasp, counts in zip(grasps, chosen, strict=True)
        if counts
    }
    n, clusters = int(chosen.sum()), len(presented)
    found = clustered_share(int(hits[chosen].sum()), n, clusters)
    bounds = {"told": found.estimate, "low": found.low, "high": found.high}
    return {"grasps": n, "presentations": clusters, **bounds}
