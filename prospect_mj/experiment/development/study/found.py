"""What each learner has discovered: which grey levels it goes by, and for what.

For every grey level i, of a learner that has ended, in units that can be laid over the
histograms of both orientations:

- discovery: the mean, over runs and the features of a context, of +1 where the level is
  in the range that is added up, -1 where it is in the one that is taken off, signed so
  that to the learner, by its own counts, more of it speaks for the lid on the left;
- linear and replay: how much more it adds to the value of a grasp by the left hand than
  to that of one by the right, w_Li - w_Ri of the histogram itself
  (`portraits.decisive_bins`), the mean over runs, divided by the largest.
"""

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from prospect_mj.agent import Learner, LinearQ
from prospect_mj.agent.discovery import DiscoveryQ
from prospect_mj.agent.discovery.detector import BETTER, WORSE, Detector
from prospect_mj.agent.features import N_BINS
from prospect_mj.agent.haptics import LEFT, NONE, RIGHT
from prospect_mj.agent.learners import DEFAULTS
from prospect_mj.experiment.development.rivals.kept import code
from prospect_mj.experiment.development.study.learning import Laboratory
from prospect_mj.experiment.development.study.looks import histograms
from prospect_mj.experiment.development.study.rows import population
from prospect_mj.experiment.development.study.settings import DOMINANT, StudySettings
from prospect_mj.experiment.populations.store import Look
from prospect_mj.recording.hands import GRASPS, INSERTIONS, NUMBERS, SWAPS

Floats = NDArray[np.float64]

MOST_RUNS = 100
"""Runs that are looked into."""
_HAND = NUMBERS[DOMINANT.dominant]
CONTEXTS: Mapping[str, tuple[int, int]] = {
    "insertion": (_HAND, INSERTIONS[_HAND]),
    "grasp": (NONE, GRASPS[_HAND]),
    "swap": (_HAND, SWAPS[_HAND]),
}
"""Those of the dominant hand: haptic state and action."""
_MEANS: Mapping[str, float] = {
    name: 1.0 if (_HAND == LEFT) == (name != "swap") else -1.0 for name in CONTEXTS
}
"""What comes out better than usual means in each: 1.0, the lid is on the left. Only the
swap is better where it lies on the other hand's side."""
WEIGHED = ("linear", "replay")
CHOICE = "choice of the hand"
"""What the weights of linear learners are of."""

Line = dict[str, Any]

_RANGE = "begin", "end", "less_begin", "less_end"
_SEEN = pa.schema(
    {
        "context": pa.string(),
        **dict.fromkeys(_RANGE, pa.int32()),
        "cut": pa.float64(),
        "says": pa.list_(pa.float64()),
    }
)
"""A feature and what each grey level says in it [1]; or, without a range, what the
weights of a learner say [actions]."""
_CODE = ("experiment/development/study/found.py",)

LEVELS = pa.schema(
    {
        "learner": pa.string(),
        "context": pa.string(),
        "runs": pa.int32(),
        "level": pa.int32(),
        "left": pa.float64(),
        "right": pa.float64(),
        "says": pa.float64(),
    }
)
"""Mean scaled histogram [1] with the lid on each side, and what a level says; see the
module. Runs: those that have a feature in the context."""


class Range(NamedTuple):
    """A feature of a single run."""

    context: str
    begin: int
    end: int
    less_begin: int
    less_end: int
    """Bins [begin, end), less those of [less_begin, less_end)."""
    cut: float
    """[1]"""


class Says(NamedTuple):
    """What grey levels say to a learner in a context."""

    learner: str
    context: str
    runs: int
    """With a feature there."""
    levels: Floats
    """(100,) [1], above 0 for the lid on the left."""


class Discovered(NamedTuple):
    """See the module."""

    v: Mapping[str, Floats]
    """(100,) [1], mean scaled histogram by side of the lid."""
    says: list[Says]
    example: list[Range]
    """Features of the first run of the discovery learner."""

    @property
    def table(self) -> pa.Table:
        """All of it by grey level, under `LEVELS`."""
        columns = [
            {
                "learner": [one.learner] * N_BINS,
                "context": [one.context] * N_BINS,
                "runs": [one.runs] * N_BINS,
                "level": np.arange(N_BINS),
                **self.v,
                "says": one.levels,
            }
            for one in self.says
        ]
        return pa.concat_tables([pa.table(one, schema=LEVELS) for one in columns])


def find(laboratory: Laboratory, study: StudySettings) -> Discovered:
    """Look into some learners, which learn once more where that was not done before.

    Args:
        laboratory: where they learn.
        study: its size.
    """
    by_side = histograms(laboratory.recordings.standard)
    v = {side: rows.mean(axis=0) for side, rows in by_side.items()}
    discovered = _seen(laboratory, study, "discovery", features)
    says = [_said(discovered, context) for context in CONTEXTS]
    for name in WEIGHED:
        says.append(_weighed(name, _seen(laboratory, study, name, weights)))
    example = [Range(*(row[n] for n in Range._fields)) for row in discovered[0]]
    return Discovered(v, says, example)


def features(learner: DiscoveryQ) -> list[Line]:
    """The features of a discovery learner in `CONTEXTS`, under `_SEEN`."""
    return [
        {
            "context": name,
            **dict(zip(_RANGE, one.feature, strict=True)),
            "cut": one.cut,
            "says": _MEANS[name] * _speaks_for_better(one),
        }
        for name, context in CONTEXTS.items()
        for one in learner.contexts.detectors(context)
    ]


def weights(learner: LinearQ) -> list[Line]:
    """What the weights of a linear learner say, a row under `_SEEN`."""
    left, right = (learner.weights[GRASPS[hand], :N_BINS] for hand in (LEFT, RIGHT))
    return [{"context": CHOICE, "says": left - right}]


def _speaks_for_better(one: Detector) -> Floats:
    """How each grey level (100,) makes a picture's class, by its detector, better [1].

    The chances are those of `likelier_class`, after Laplace.
    """
    begin, end, less_begin, less_end = one.feature
    levels = np.zeros(N_BINS)
    levels[begin:end] += 1.0
    levels[less_begin:less_end] -= 1.0
    chance = (one.present + 1) / (one.total + 2)
    return levels * np.sign(chance[BETTER] - chance[WORSE])


def _seen(
    laboratory: Laboratory,
    study: StudySettings,
    name: str,
    see: Callable[[Learner], list[Line]],
) -> list[list[Line]]:
    """Rows of every run."""
    runs = min(study.runs, MOST_RUNS)
    settings = replace(population(study, DEFAULTS[name], size="runs"), runs=runs)
    look = Look(see, _SEEN, code(_CODE))
    seen: list[list[Line]] = [[] for _ in range(runs)]
    for row in laboratory.looked_into(DOMINANT, settings, look).to_pylist():
        seen[row["run"]].append(row)
    return seen


def _said(runs: list[list[Line]], context: str) -> Says:
    """The mean over the features of a run, then over runs with any."""
    found = [[row["says"] for row in run if row["context"] == context] for run in runs]
    there = [np.mean(says, axis=0) for says in found if says]
    levels = np.mean(there, axis=0) if there else np.zeros(N_BINS)
    return Says("discovery", context, len(there), levels)


def _weighed(name: str, runs: list[list[Line]]) -> Says:
    levels = np.mean([row["says"] for run in runs for row in run], axis=0)
    return Says(name, CHOICE, len(runs), levels / np.abs(levels).max())
