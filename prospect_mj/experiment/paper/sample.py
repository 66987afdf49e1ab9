"""The curves a measure is taken on, and its estimate with an interval."""

import inspect
from collections.abc import Callable
from typing import NamedTuple, Self

import numpy as np

from prospect_mj.experiment.paper.bands import (
    Curves,
    Floats,
    Interval,
    RunCounts,
    interval,
)
from prospect_mj.experiment.paper.population import Population


class Pair(NamedTuple):
    """The curves of both scenarios."""

    baseline: Curves
    """Without a dominant hand."""
    dominant: Curves
    """With one: after pretraining."""


class Sample(NamedTuple):
    """Curves as they are, and resampled."""

    mean: Pair
    """b = 1."""
    resampled: Pair
    """As many runs, drawn with replacement."""

    @classmethod
    def of(
        cls, baseline: Population, dominant: Population, rng: np.random.Generator
    ) -> Self:
        """Count and resample the runs of both scenarios."""
        counts = RunCounts.of(baseline), RunCounts.of(dominant)
        mean = Pair(*(count.mean() for count in counts))
        return cls(mean, Pair(*(count.resampled(rng) for count in counts)))


Measure = Callable[[Pair], Floats]


def estimate(measure: Measure, sample: Sample) -> Interval:
    """A measure of all runs, with its interval."""
    return interval(measure(sample.mean)[0], measure(sample.resampled))


def title(measure: Measure) -> str:
    """A measure's name."""
    return _paragraphs(measure)[0].rstrip(".")


def definition(measure: Measure) -> str:
    """A measure's definition, one sentence."""
    return _paragraphs(measure)[1]


def _paragraphs(measure: Measure) -> list[str]:
    text = inspect.getdoc(measure) or ""
    return [" ".join(part.split()) for part in text.split("\n\n")]
