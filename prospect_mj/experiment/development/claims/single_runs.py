"""What is asked of the way from late to early corrections, and of single runs.

Like all criteria they are asked of every learner under every rule.
"""

from math import inf

from prospect_mj.experiment.development.claims.criteria import Criterion, Judged
from prospect_mj.experiment.development.claims.findings import Findings
from prospect_mj.experiment.development.measures.changes import ABRUPT, Changes
from prospect_mj.experiment.development.measures.measures import late_alone
from prospect_mj.experiment.paper.measures.bootstrap import Interval
from prospect_mj.experiment.paper.measures.quantity import Kind, with_interval
from prospect_mj.experiment.paper.measures.target import Target, Verdict
from prospect_mj.experiment.populations.strategies import Strategy

NEARLY_ALL = 0.9
"""Share of the runs [1]."""
PRACTISED = Strategy.LATE, Strategy.EARLY, Strategy.OPTIMAL
"""In the order of infants."""


def _late_first(findings: Findings) -> Judged:
    first = findings.late_first
    shares = {one.sequence: one.share for one in findings.sequences}
    whole = shares.get(PRACTISED)
    exactly = "none" if whole is None else f"{whole.words(0, 100)} %"
    of_runs = Interval(first.estimate, first.low, first.high)
    return Judged(
        Target(0.5, 1.0).verdict(of_runs),
        f"{first.words(0, 100)} % of the runs; late, early, optimal and nothing else "
        f"prevail in {exactly}",
    )


def _late_alone(findings: Findings) -> Judged:
    found = late_alone.estimate(findings.development)
    words = f"{with_interval(found, Kind.TRIAL)} trials"
    return Judged(Target(10, inf).verdict(found), words)


def _each_late_alone(findings: Findings) -> Judged:
    found = findings.late_alone
    of_runs = Interval(found.estimate, found.low, found.high)
    words = f"{found.words(0, 100)} % of the runs"
    return Judged(Target(NEARLY_ALL, 1.0).verdict(of_runs), words)


def _abrupt(findings: Findings) -> Judged:
    found = findings.changes
    return Judged(Target(0, ABRUPT).verdict(found.own), change_words(found))


def change_words(found: Changes) -> str:
    """What was measured of changes."""
    if not found.n_runs:
        return "no run has ten corrections of both kinds"
    own, common = (with_interval(one, Kind.RATIO) for one in (found.own, found.common))
    return (
        f"of {found.n_runs} runs with ten of both kinds each, {own} corrections a run "
        "are on the wrong side of its own change, at most one in "
        f"{found.abrupt.words(0, 100)} %; {common} are on that of one change for all"
    )


LATE_FIRST = Criterion(
    "late first, run by run",
    "in more than a half of the runs the median late correction comes before the "
    "median early one",
    _late_first,
)
LATE_ALONE = Criterion(
    "late alone first",
    "late corrections are more than a half of the difficult trials in a block before "
    "early ones first are more than 10 %",
    _late_alone,
)
EACH_LATE_ALONE = Criterion(
    "late alone first, run by run",
    f"{100 * NEARLY_ALL:.0f} % of the runs have ten difficult trials of which more "
    "than a half are corrected late, before the first ten with more than one early "
    "correction",
    _each_late_alone,
)
ABRUPTLY = Criterion(
    "abrupt, run by run",
    f"a run has at most {ABRUPT} corrections, in the mean, on the wrong side of its "
    "own change from late to early ones, as if that took ten difficult trials",
    _abrupt,
)
OF_SINGLE_RUNS = (LATE_FIRST, ABRUPTLY, LATE_ALONE, EACH_LATE_ALONE)
"""What is asked beside the criteria."""


def mixed_in_mean(findings: Findings) -> Verdict:
    """Whether late and early corrections are mixed where all runs are taken together.

    The whole interval must be above what an abrupt change leaves.
    """
    common = findings.changes.common
    verdict = Target(0, ABRUPT).verdict(common)
    opposite = {Verdict.HOLDS: Verdict.FAILS, Verdict.FAILS: Verdict.HOLDS}
    return opposite.get(verdict, verdict)


def more_mixed(findings: Findings, equal: Findings) -> Verdict:
    """Whether they are more so, by whole intervals, than in learners that are equal."""
    bounds = equal.changes.common
    return Target(bounds.high, inf).verdict(findings.changes.common)
