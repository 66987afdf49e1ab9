"""A number that is taken on the learning curves, with its definition."""

from collections.abc import Callable
from dataclasses import dataclass

from prospect_mj.experiment.paper.measures.bootstrap import Floats, Interval, interval
from prospect_mj.experiment.paper.measures.quantity import Kind
from prospect_mj.experiment.paper.measures.sample import Pair, Sample

Formula = Callable[[Pair], Floats]
"""Takes the curves of both scenarios, b times resampled, and gives a value per resample
(b,): infinity where it is never reached, NaN where there is nothing to be measured."""


@dataclass(frozen=True)
class Measure:
    """What is measured; the report quotes title and definition."""

    name: str
    """In tables."""
    kind: Kind
    title: str
    definition: str
    """One sentence."""
    formula: Formula
    end: Callable[[Pair], float] | None = None
    """The trial at which the study ends for it: what was not reached till then would
    be reached there at the soonest. None: no longer study would reach it."""
    of_end: bool = False
    """Whether it is of the last trials, which in a short study come too soon."""

    def __call__(self, pair: Pair) -> Floats:
        """Its values (b,)."""
        return self.formula(pair)

    def estimate(self, sample: Sample) -> Interval:
        """Its value for all runs, with an interval."""
        return measured(self, sample)


def measured(formula: Callable[[Pair], Floats], sample: Sample) -> Interval:
    """What a formula gives for all runs, with an interval."""
    return interval(formula(sample.mean)[0], formula(sample.resampled))


def measure(
    kind: Kind,
    title: str,
    definition: str,
    end: Callable[[Pair], float] | None = None,
    of_end: bool = False,
) -> Callable[[Formula], Measure]:
    """Make a measure of a formula, named as the formula is; see `Measure`."""

    def make(formula: Formula) -> Measure:
        name = formula.__name__
        return Measure(name, kind, title, definition, formula, end, of_end)

    return make
