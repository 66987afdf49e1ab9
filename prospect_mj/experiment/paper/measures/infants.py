"""Whether the agent's strategies come in the order in which those of infants do.

The numbers of McCarty, Clifton and Collard (1999) are not at hand, so that nothing but
the order told by Wheeler, Fagg and Grupen (2002, sections 2 and 3.2) is compared. The
agent's stages stand for 9, 14 and 19 months.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from math import inf
from typing import NamedTuple

from prospect_mj.experiment.paper.measures.bootstrap import Floats, interval
from prospect_mj.experiment.paper.measures.sample import Sample
from prospect_mj.experiment.paper.measures.stages import Shares, Stages
from prospect_mj.experiment.paper.measures.statements import EARLY_FIRST
from prospect_mj.experiment.paper.measures.target import Target, Verdict, agreed
from prospect_mj.experiment.run.learning_curve import BLOCK


@dataclass(frozen=True)
class Order:
    """An order of strategies in infants, and whether the agent has it."""

    infants: str
    """What the paper tells of them."""
    rule: str
    """What counts as the same."""
    verdict: Verdict
    """Whether it holds of the agent."""


class _Ages(NamedTuple):
    """The shares of the three stages, resampled alike."""

    beginning: Shares
    height: Shares
    end: Shares


_Condition = tuple[Callable[[_Ages], Floats], Target]

_MORE_OR_EQUAL = Target(-0.05, inf)
_MORE = Target(0.0, inf)
_RARE = Target(0.0, 1 / 3)
_HALF = Target(0.4, 0.6)
_STRONG = Target(2 / 3, 1.0)
_UNNECESSARY = Target(0.0, 0.05)
_MOST = Target(0.5, 1.0)
_LATE_FIRST = Target(-inf, -float(BLOCK))

_GRIPS: Sequence[_Condition] = (
    (lambda ages: ages.beginning.nonradial - ages.height.nonradial, _MORE_OR_EQUAL),
    (lambda ages: ages.height.nonradial - ages.end.nonradial, _MORE),
    (lambda ages: ages.end.nonradial, _RARE),
)
_PREFERENCES: Sequence[_Condition] = (
    (lambda ages: ages.beginning.preference, _HALF),
    (lambda ages: ages.height.preference, _STRONG),
    (lambda ages: ages.end.early + ages.end.late, _UNNECESSARY),
)
_EASY: Sequence[_Condition] = (
    (lambda ages: 1 - ages.beginning.easy_nonradial, _MOST),
    (lambda ages: 1 - ages.height.easy_nonradial, _MOST),
    (lambda ages: 1 - ages.end.easy_nonradial, _MOST),
)
_DOMINANCE: Sequence[_Condition] = (
    (lambda ages: ages.height.early + ages.height.late - ages.height.optimal, _MORE),
)


_ORDERS: Mapping[tuple[str, str], Sequence[_Condition]] = {
    (
        "difficult trials: many nonradial grips at 9 and 14 months; radial ones far "
        "more prevalent at 19",
        "not fewer nonradial first grasps at the first stage than at the second (5 "
        "points allowed), fewer at the last, and there a third at most",
    ): _GRIPS,
    (
        "as many early as late corrections at 9 months; early ones strongly preferred "
        "at 14; corrections not necessary at 19",
        "early ones are 40 to 60 % of the corrections at the first stage, and two "
        "thirds or more at the second; at the last 5 % at most of the difficult trials "
        "have a correction",
    ): _PREFERENCES,
    (
        "easy trials: predominantly the dominant hand, and so a radial grip, at all "
        "ages",
        "over a half of the first grasps are radial at each stage",
    ): _EASY,
    (
        "the nonradial, corrective strategies are dominant in young children",
        "more corrections than optimal ones in difficult trials of the second stage",
    ): _DOMINANCE,
}
"""What the paper tells of infants, what counts as the same, and what that takes."""
_DISAPPEARANCE = (
    "late corrections disappear before early ones",
    "the same by all measures of when a correction is gone",
)


def orders(sample: Sample, stages: Stages) -> list[Order]:
    """Hold the five orders against the agent's.

    Args:
        sample: for when corrections are gone.
        stages: of the same sample.
    """
    verdicts = {said: _all(stages, held) for said, held in _ORDERS.items()}
    if sample.is_short:
        verdicts = {said: found.not_denied() for said, found in verdicts.items()}
    compared = [Order(*said, found) for said, found in verdicts.items()]
    return [*compared, Order(*_DISAPPEARANCE, _late_first(sample))]


def _all(stages: Stages, conditions: Sequence[_Condition]) -> Verdict:
    """Whether all conditions hold, or one does not."""
    once = _Ages(*(stage.mean for stage in stages))
    many = _Ages(*(stage.resampled for stage in stages))
    verdicts = {
        target.verdict(interval(measure(once)[0], measure(many)))
        for measure, target in conditions
    }
    if Verdict.FAILS in verdicts:
        return Verdict.FAILS
    return agreed(verdicts)


def _late_first(sample: Sample) -> Verdict:
    """What all measures say."""
    lags = (measure.estimate(sample) for measure in EARLY_FIRST.measures)
    return agreed(map(_LATE_FIRST.verdict, lags))
