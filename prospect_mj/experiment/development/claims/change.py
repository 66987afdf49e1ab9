"""What is claimed of a world that changes after learning."""

from collections.abc import Collection, Mapping
from types import MappingProxyType

from prospect_mj.experiment.development.claims.claim import (
    CONJECTURED,
    STAGED,
    Claim,
    asked_alike,
)
from prospect_mj.experiment.development.claims.criteria import (
    LATE_GONE_FIRST,
    STAGES,
    Figures,
    all_of,
    together,
)
from prospect_mj.experiment.development.measures.measures import other_first
from prospect_mj.experiment.paper.measures.bootstrap import Interval
from prospect_mj.experiment.paper.measures.quantity import Kind, with_interval
from prospect_mj.experiment.paper.measures.target import Verdict

AGAIN, SOONEST = "stages again", "soonest"

_CHANGES: Mapping[str, str] = MappingProxyType(
    {
        "post": "the other end has become the right one to hold (*post*)",
        "lamp-right": "the lamp has moved to the other side, so that each orientation "
        "looks as the other one did (*lamp-right*)",
    }
)

Trials = Mapping[str, Figures]
"""What a learner comes to after the change, by the kind of trials."""


def stages_again(change: str, learners: Mapping[str, Trials]) -> list[Claim]:
    """Whether the stages come once more, in trials of every kind.

    Args:
        change: the world that the usual one changes into.
        learners: by name.
    """
    return [
        _again(change, learner, learners) for learner in STAGED if learner in learners
    ]


def _again(change: str, learner: str, learners: Mapping[str, Trials]) -> Claim:
    verdicts = {
        other: all_of([together(STAGES, one).verdict for one in trials.values()])
        for other, trials in learners.items()
    }
    told = ". ".join(
        f"*{kind}* trials: {_told(one)}" for kind, one in learners[learner].items()
    )
    if learner == CONJECTURED.learner:
        told += asked_alike(verdicts)
    return Claim(
        f"After {_CHANGES[change]}, all stages come again in the trials that were "
        "difficult before and in those that were easy: late, then early corrections, "
        "then the optimal strategy.",
        verdicts[learner],
        told,
        learner,
        f"{AGAIN}, {change}",
    )


def _told(figures: Figures) -> str:
    """The verdict on one kind of trials, the order, and what was before it."""
    before_it = with_interval(figures.measured[other_first.name], other_first.kind)
    return (
        f"{together(STAGES, figures).words}; {LATE_GONE_FIRST.judge(figures).words}; "
        f"in the first fifty trials {before_it} were neither optimal nor corrected"
    )


def soonest(
    change: str, again: Mapping[str, Interval], seeing: Collection[str]
) -> Claim:
    """Whether the learner of the conjecture adapts before the others that see.

    Args:
        change: the world that the usual one changes into.
        again: trials until each learner is near-optimal once more, by its name; that of
            the conjecture is among them.
        seeing: names of those that know a trial by its picture only.
    """
    ranked = sorted(again, key=lambda name: again[name].estimate)
    told = (
        f"*{name}*{'' if name in seeing else ' (is told the orientation)'} "
        f"{with_interval(again[name], Kind.TRIAL)}"
        for name in ranked
    )
    first = [name for name in again if before(again, name, again) is Verdict.HOLDS]
    return Claim(
        f"After {_CHANGES[change]}, the learner that discovers is near-optimal again "
        "sooner than every other that knows a trial by its picture only.",
        before(again, CONJECTURED.learner, seeing),
        f"trials: {'; '.join(told)}. Before all others, by whole intervals: "
        f"{', '.join(first) or 'none'}",
        CONJECTURED.learner,
        f"{SOONEST}, {change}",
    )


def before(again: Mapping[str, Interval], name: str, names: Collection[str]) -> Verdict:
    """Whether one is near-optimal before all others of some, by whole intervals."""
    its = again[name]
    others = [again[other] for other in names if other != name and other in again]
    if all(its.high < other.low for other in others):
        return Verdict.HOLDS
    behind = any(other.high < its.low for other in others)
    return Verdict.FAILS if behind else Verdict.OPEN
