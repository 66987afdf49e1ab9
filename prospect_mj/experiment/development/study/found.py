"""What each learner has discovered: which grey levels it goes by, and for what.

For every grey level i, of a learner that has ended, in units that can be laid over the
histograms of both orientations:

- discovery: the mean, over runs and the features of a context, of +1 where the level is
  in the range that is added up, -1 where it is in the one that is taken off, signed so
  that more of it speaks for the lid on the left;
- linear and replay: how much more it adds to the value of a grasp by the left hand than
  to that of one by the right, w_Li - w_Ri of the histogram itself
  (`portraits.decisive_bins`), the mean over runs, divided by the largest.
"""

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from prospect_mj.actions.action import Action
from prospect_mj.agent import LinearQ
from prospect_mj.agent.discovery import DiscoveryQ
from prospect_mj.agent.features import N_BINS
from prospect_mj.experiment.development.study.learners import LEARNERS
from prospect_mj.experiment.development.study.looks import histograms
from prospect_mj.experiment.development.study.rows import population
from prospect_mj.experiment.development.study.settings import DOMINANT, StudySettings
from prospect_mj.experiment.populations.population import learn
from prospect_mj.experiment.populations.programme import Programme
from prospect_mj.recording.hands import GRASPS, INSERTIONS, NONE, NUMBERS, SWAPS
from prospect_mj.recording.recording import Recording

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
WEIGHED = ("linear", "replay")
CHOICE = "choice of the hand"
"""What the weights of linear learners are of."""

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


class Found(NamedTuple):
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


def find(recording: Recording, study: StudySettings) -> Found:
    """Let some learners learn once more, and look into them.

    Args:
        recording: of the standard world.
        study: its size.
    """
    by_side = histograms(recording)
    v = {side: rows.mean(axis=0) for side, rows in by_side.items()}
    runs = min(study.runs, MOST_RUNS)
    discoverers = _learned(recording, study, "discovery", runs)
    says = [_said(discoverers, context, v) for context in CONTEXTS]
    for name in WEIGHED:
        says.append(_weighed(name, _learned(recording, study, name, runs)))
    return Found(v, says, ranges(discoverers[0]))


def ranges(learner: DiscoveryQ) -> list[Range]:
    """The features of one learner in `CONTEXTS`."""
    return [
        Range(name, *detector.feature, detector.cut)
        for name, context in CONTEXTS.items()
        for detector in learner.contexts.detectors(context)
    ]


def signs(learner: DiscoveryQ, context: str, v: Mapping[str, Floats]) -> Floats | None:
    """What each grey level says in a context of one learner, (100,) [1].

    Args:
        learner: that has ended.
        context: one of `CONTEXTS`.
        v: (100,) [1], mean histogram by side of the lid.

    Returns:
        The mean over its features, or None without any.
    """
    found = [one for one in ranges(learner) if one.context == context]
    if not found:
        return None
    return np.mean([_sign(one, v) for one in found], axis=0)


def _sign(one: Range, v: Mapping[str, Floats]) -> Floats:
    weights = np.zeros(N_BINS)
    weights[one.begin : one.end] += 1.0
    weights[one.less_begin : one.less_end] -= 1.0
    return weights * np.sign(weights @ (v["left"] - v["right"]))


def _learned(
    recording: Recording, study: StudySettings, name: str, runs: int
) -> list[DiscoveryQ | LinearQ]:
    settings = population(study, LEARNERS[name], size="runs")
    programme = Programme(recording, DOMINANT, settings)
    return [learn(programme, number).learner for number in range(runs)]


def _said(learners: list[DiscoveryQ], context: str, v: Mapping[str, Floats]) -> Says:
    found = [signs(learner, context, v) for learner in learners]
    there = [one for one in found if one is not None]
    levels = np.mean(there, axis=0) if there else np.zeros(N_BINS)
    return Says("discovery", context, len(there), levels)


def _weighed(name: str, learners: list[LinearQ]) -> Says:
    differing = [
        learner.weights[Action.GRASP_LEFT] - learner.weights[Action.GRASP_RIGHT]
        for learner in learners
    ]
    levels = np.mean(differing, axis=0)[:N_BINS]
    return Says(name, CHOICE, len(learners), levels / np.abs(levels).max())
