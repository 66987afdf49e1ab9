"""What is measured of the trials after a world has changed.

A population whose world changes is looked at as one with a longer pretraining, so that
all measures of development count from the change: difficult and easy trials are those
of the dominant hand of before, whatever hand is right now. What is measured of the
difficult trials is measured of the formerly easy ones, too: the change is one in both.
"""

from dataclasses import replace

from prospect_mj.experiment.development.measures.development import (
    Development,
    difficult,
    easy,
)
from prospect_mj.experiment.development.measures.measures import (
    BEGINNING,
    MEASURES,
    easy_worst,
    order,
)
from prospect_mj.experiment.development.study.measured import Measured, MeasuredCurves
from prospect_mj.experiment.paper.measures.bootstrap import Floats
from prospect_mj.experiment.paper.measures.curves import (
    LONG,
    Curves,
    mean_of_sets,
    moving_means,
)
from prospect_mj.experiment.paper.measures.measure import measure
from prospect_mj.experiment.paper.measures.quantity import Kind
from prospect_mj.experiment.populations.population import Population
from prospect_mj.experiment.populations.scenario import Scenario
from prospect_mj.experiment.populations.strategies import Strategy
from prospect_mj.experiment.run.learning_curve import BLOCK, NEAR_OPTIMAL, settled


@measure(
    Kind.TRIAL,
    "Near-optimal again",
    "The first trial after the change from which on every moving mean over five sets "
    "of ten is at most 2.4 actions.",
)
def again(curves: Curves) -> Floats:
    """(b,) [trials]."""
    smooth = moving_means(curves.actions[:, curves.switch :])
    return BLOCK * settled(smooth, NEAR_OPTIMAL)


@measure(
    Kind.SHARE,
    "Formerly easy at first",
    "Mean share, over the first fifty trials after the change, of formerly easy trials "
    "that were not optimal.",
)
def easy_errors(curves: Curves) -> Floats:
    """(b,) [1]."""
    return 1.0 - mean_of_sets(easy(curves, Strategy.OPTIMAL)[:, :BEGINNING])


@measure(
    Kind.SHARE,
    "Formerly difficult at first",
    "The same of the formerly difficult trials.",
)
def difficult_errors(curves: Curves) -> Floats:
    """(b,) [1]."""
    return 1.0 - mean_of_sets(difficult(curves, Strategy.OPTIMAL)[:, :BEGINNING])


@measure(
    Kind.SHARE,
    "Formerly easy at the end",
    "Mean share of the optimal strategy in the formerly easy ones of the last hundred "
    "trials.",
)
def easy_last(curves: Curves) -> Floats:
    """(b,) [1]."""
    return mean_of_sets(easy(curves, Strategy.OPTIMAL)[:, -LONG:])


MEASURES_AFTER = (again, easy_errors, difficult_errors, easy_last, *MEASURES)
"""Of the trials after a change, in the order of tables."""
OF_A_KIND = tuple(one for one in MEASURES if one is not easy_worst)
"""Of trials of one kind."""


def from_the_change(population: Population) -> Population:
    """The same, as if all before the change had been its pretraining."""
    was = population.scenario
    scenario = Scenario(was.all_trials, was.trials, was.dominant)
    return replace(population, scenario=scenario)


def of_formerly_easy(shown: MeasuredCurves) -> Measured:
    """A row after a change, its formerly easy trials in place of the difficult ones."""
    swapped = Development(
        *(replace(c, easy=c.difficult, difficult=c.easy) for c in shown.development)
    )
    return Measured(
        replace(shown.row, name=f"{shown.row.name}, formerly easy trials"),
        shown.measured.runs,
        {one.name: one.estimate(swapped) for one in OF_A_KIND},
        order(swapped),
    )
