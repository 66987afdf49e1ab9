"""A number that is taken on the learning curves, with its definition."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Generic, Protocol, TypeVar

from prospect_mj.experiment.paper.measures.bootstrap import Floats, Interval, interval
from prospect_mj.experiment.paper.measures.quantity import Kind

Taken = TypeVar("Taken", contravariant=True)
"""What it is taken on: curves of a scenario, or of both, b times resampled."""
Resampled = TypeVar("Resampled", covariant=True)

Formula = Callable[[Taken], Floats]
"""Gives a value per resample (b,): infinity where it is never reached, NaN where there
is nothing to be measured."""


class Resamples(Protocol[Resampled]):
    """What a measure is estimated on."""

    @property
    def mean(self) -> Resampled:
        """Of all runs, b = 1."""
        ...

    @property
    def resampled(self) -> Resampled:
        """Of as many runs, drawn with replacement."""
        ...


@dataclass(frozen=True)
class Measure(Generic[Taken]):
    """What is measured; the report quotes title and definition."""

    name: str
    """In tables."""
    kind: Kind
    title: str
    definition: str
    """One sentence."""
    formula: Formula[Taken]
    end: Callable[[Taken], float] | None = None
    """The trial at which the study ends for it: what was not reached till then would
    be reached there at the soonest. None: no longer study would reach it."""
    of_end: bool = False
    """Whether it is of the last trials, which in a short study come too soon."""

    def __call__(self, curves: Taken) -> Floats:
        """Its values (b,)."""
        return self.formula(curves)

    def estimate(self, sample: Resamples[Taken]) -> Interval:
        """Its value for all runs, with an interval."""
        return measured(self, sample)


def measured(formula: Formula[Taken], sample: Resamples[Taken]) -> Interval:
    """What a formula gives for all runs, with an interval."""
    return interval(formula(sample.mean)[0], formula(sample.resampled))


def measure(
    kind: Kind,
    title: str,
    definition: str,
    end: Callable[[Taken], float] | None = None,
    of_end: bool = False,
) -> Callable[[Formula[Taken]], Measure[Taken]]:
    """Make a measure of a formula, named as the formula is; see `Measure`."""

    def make(formula: Formula[Taken]) -> Measure[Taken]:
        name = formula.__name__
        return Measure(name, kind, title, definition, formula, end, of_end)

    return make
