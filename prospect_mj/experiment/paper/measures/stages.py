"""The agent's stages after its pretraining, to be compared with the ages of infants."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from prospect_mj.experiment.paper.measures.bootstrap import Floats, Interval, interval
from prospect_mj.experiment.paper.measures.curves import (
    LONG,
    Curves,
    mean_of_sets,
    ratio,
)
from prospect_mj.experiment.paper.measures.sample import Sample
from prospect_mj.experiment.populations.strategies import Grip, Strategy
from prospect_mj.experiment.run.learning_curve import BLOCK


class Shares(NamedTuple):
    """Mean shares (b,) over the sets of a stage, b times resampled."""

    nonradial: Floats
    """Of nonradial first grasps in those of difficult trials."""
    easy_nonradial: Floats
    """The same in easy trials."""
    optimal: Floats
    """Of the optimal strategy in difficult trials."""
    early: Floats
    """Of early corrections in difficult trials."""
    late: Floats
    """Of late corrections in difficult trials."""
    other: Floats
    """Of anything else in difficult trials, those cut off among it."""
    preference: Floats
    """Of early corrections in all corrections of difficult trials; NaN without any."""
    easy_optimal: Floats
    """Of the optimal strategy in easy trials."""


@dataclass(frozen=True)
class Stage:
    """Successive sets of ten trials."""

    first: int
    """First trial."""
    last: int
    """Last trial."""
    mean: Shares
    """b = 1."""
    resampled: Shares
    """As many runs, drawn with replacement."""

    def measured(self, name: str) -> Interval:
        """One of the shares, with its interval."""
        return interval(getattr(self.mean, name)[0], getattr(self.resampled, name))


class Stages(NamedTuple):
    """The beginning after pretraining, the height of corrections, and the end."""

    beginning: Stage
    height: Stage
    end: Stage


def stages(sample: Sample) -> Stages:
    """Find the stages.

    Args:
        sample: of which the runs with a dominant hand are looked at. A stage is a
            hundred trials long, and there are three hundred or more.
    """
    mean = sample.mean.dominant
    switch, n_sets = mean.switch, mean.actions.shape[1]
    starts = switch, _height(mean), n_sets - LONG
    return Stages(*(_stage(sample, start, start + LONG) for start in starts))


def _height(mean: Curves) -> int:
    """First of the sets between beginning and end with most corrections."""
    shares = np.nan_to_num(mean.difficult.strategies[0])
    corrections = shares[Strategy.EARLY] + shares[Strategy.LATE]
    sums = np.convolve(corrections, np.ones(LONG), mode="valid")
    first, end = mean.switch + LONG, len(corrections) - 2 * LONG + 1
    return first + int(np.argmax(sums[first:end]))


def _stage(sample: Sample, start: int, end: int) -> Stage:
    """Sets `start` up to but not `end`."""
    once, many = (
        _shares(curves.dominant, start, end)
        for curves in (sample.mean, sample.resampled)
    )
    return Stage(BLOCK * start, BLOCK * end - 1, once, many)


def _shares(curves: Curves, start: int, end: int) -> Shares:
    """What a stage shows."""
    grips, easy_grips, easy, difficult = (
        mean_of_sets(shares[:, :, start:end])
        for shares in (
            curves.difficult.grips,
            curves.easy.grips,
            curves.easy.strategies,
            curves.difficult.strategies,
        )
    )
    early, late = difficult[:, Strategy.EARLY], difficult[:, Strategy.LATE]
    return Shares(
        nonradial=grips[:, Grip.NONRADIAL],
        easy_nonradial=easy_grips[:, Grip.NONRADIAL],
        optimal=difficult[:, Strategy.OPTIMAL],
        early=early,
        late=late,
        other=difficult[:, Strategy.OTHER],
        preference=ratio(early, early + late),
        easy_optimal=easy[:, Strategy.OPTIMAL],
    )
