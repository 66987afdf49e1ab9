"""The claims of the study: each with what was measured, and whether it holds."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import inf
from typing import NamedTuple

from prospect_mj.experiment.development.claims.criteria import (
    LIKE_INFANTS,
    UNLIKE_INFANTS,
    Criterion,
    Judged,
    all_of,
    by_share,
)
from prospect_mj.experiment.development.claims.findings import (
    ABRUPT,
    Changes,
    Findings,
)
from prospect_mj.experiment.paper.measures.target import Target, Verdict
from prospect_mj.experiment.populations.strategies import Strategy


class Row(NamedTuple):
    """A learner under a rule for failed actions."""

    learner: str
    """Its name, or that of a control."""
    rule: str
    """`allowed` or `suppressed`."""

    @property
    def words(self) -> str:
        """For tables and sentences."""
        return f"{self.learner}, {self.rule}"


@dataclass(frozen=True)
class Claim:
    """A sentence, and whether it holds."""

    words: str
    verdict: Verdict
    evidence: str
    """What was measured."""


Asked = Mapping[Row, Mapping[str, Judged]]
"""Criteria by their names, of every row."""

AS_PAPER = Row("linear", "allowed")
CONJECTURED = Row("discovery", "suppressed")
PRACTISED = Strategy.LATE, Strategy.EARLY, Strategy.OPTIMAL


def asked(rows: Mapping[Row, Findings], criteria: Sequence[Criterion]) -> Asked:
    """Ask the same of all."""
    return {
        row: {one.name: one.judge(findings) for one in criteria}
        for row, findings in rows.items()
    }


def developing(rows: Mapping[Row, Findings]) -> dict[Row, Verdict]:
    """Whether each row develops as infants do, by all criteria together."""
    judged = asked(rows, LIKE_INFANTS)
    return {
        row: all_of([one.verdict for one in criteria.values()])
        for row, criteria in judged.items()
    }


def claims(rows: Mapping[Row, Findings]) -> list[Claim]:
    """All claims, of the rows that are there."""
    found = []
    if AS_PAPER in rows:
        found.append(_paper(rows))
    if CONJECTURED in rows:
        found += [_conjecture(rows), _single_runs(rows), _abruptness(rows)]
        found.append(_late_only(rows))
    found.append(_not_necessary(rows))
    return found


def _evidence(criteria: Mapping[str, Judged]) -> str:
    return "; ".join(f"{name}: {judged.words}" for name, judged in criteria.items())


def _paper(rows: Mapping[Row, Findings]) -> Claim:
    judged = asked({AS_PAPER: rows[AS_PAPER]}, UNLIKE_INFANTS)[AS_PAPER]
    return Claim(
        "The paper's learner, free to repeat a failed action, shows the two mismatches "
        "that the paper admits: corrections never dominate, and late ones are not gone "
        "before early ones.",
        all_of([one.verdict for one in judged.values()]),
        _evidence(judged),
    )


def _conjecture(rows: Mapping[Row, Findings]) -> Claim:
    judged = asked({CONJECTURED: rows[CONJECTURED]}, LIKE_INFANTS)[CONJECTURED]
    return Claim(
        "A learner that discovers features as it needs them, and does not repeat what "
        "has just failed, goes through late, then early corrections, then the optimal "
        "strategy, as infants do.",
        all_of([one.verdict for one in judged.values()]),
        _evidence(judged),
    )


def _not_necessary(rows: Mapping[Row, Findings]) -> Claim:
    others = {
        row: verdict
        for row, verdict in developing(rows).items()
        if row.learner != CONJECTURED.learner
    }
    like = [row.words for row, one in others.items() if one is Verdict.HOLDS]
    undecided = [row.words for row, one in others.items() if one is Verdict.OPEN]
    verdict = Verdict.OPEN if undecided else Verdict.FAILS
    evidence = f"by all criteria as infants: {', '.join(like) or 'none of the others'}"
    if undecided:
        evidence += f"; undecided: {', '.join(undecided)}"
    return Claim(
        "Discovery is not necessary for that: learners without it meet the same "
        "criteria.",
        Verdict.HOLDS if like else verdict,
        evidence,
    )


def _single_runs(rows: Mapping[Row, Findings]) -> Claim:
    findings = rows[CONJECTURED]
    first = findings.late_first
    shares = {one.sequence: one.share for one in findings.sequences}
    whole = shares.get(PRACTISED)
    exactly = "none" if whole is None else f"{whole.words(0, 100)} %"
    verdict = Verdict.HOLDS if first.low > 0.5 else Verdict.OPEN
    return Claim(
        "Most single learners go the same way, not just their mean: the median late "
        "correction comes before the median early one.",
        Verdict.FAILS if first.high < 0.5 else verdict,
        f"{first.words(0, 100)} % of the runs; late, early, optimal and nothing else "
        f"prevail in {exactly}",
    )


def _abruptness(rows: Mapping[Row, Findings]) -> Claim:
    found = rows[CONJECTURED].changes
    return Claim(
        "Single learners change from late to early corrections abruptly.",
        Target(-inf, ABRUPT).verdict(found.of_runs),
        _overlaps(found),
    )


def between_learners(findings: Findings) -> Claim:
    """Whether the mixture of a population of different learners is one of learners.

    Args:
        findings: of a population with spread parameters.
    """
    found = findings.changes
    single = Target(-inf, ABRUPT).verdict(found.of_runs)
    is_mixed = found.of_all > max(ABRUPT, found.of_runs.high)
    return Claim(
        "Where learners differ, late and early corrections are mixed in their mean, "
        "and not within a learner.",
        single if is_mixed else Verdict.FAILS,
        _overlaps(found),
    )


def _overlaps(found: Changes) -> str:
    runs = found.of_runs
    return (
        f"late and early ones overlap in {runs.estimate:.0f} ({runs.low:.0f} to "
        f"{runs.high:.0f}) difficult trials of a median run, in {found.of_all:.0f} of "
        f"all runs together; in less than {ABRUPT} in {found.abrupt.words(0, 100)} % "
        "of the runs that have both"
    )


def _late_only(rows: Mapping[Row, Findings]) -> Claim:
    curves = rows[CONJECTURED].development
    shares = [one.difficult.strategies[:, :, one.switch] for one in curves]
    is_late = shares[1][:, Strategy.LATE] > 4 * shares[1][:, Strategy.EARLY]
    late, early = (shares[0][0, kind] for kind in PRACTISED[:2])
    return Claim(
        "Before the mixture of late and early corrections there is a phase of late "
        "ones alone.",
        by_share(float(is_late.mean())),
        f"in the first ten trials late ones are {100 * late:.0f} % of the difficult "
        f"ones, early ones {100 * early:.0f} %; four times as many late ones in "
        f"{100 * is_late.mean():.1f} % of the resamples",
    )


PREDICTION = (
    "A longitudinal study that films the same children every few days, in place of "
    "different children of three ages, will find two things if children learn as this "
    "learner does. Each child has a phase of late corrections alone before its first "
    "early ones, earlier than the 9 months at which both are about equally frequent in "
    "the mean. And each child changes from late to early corrections within a few "
    "difficult trials: the mixture at 9 months is one of children, not within a child."
)
"""That a study of children could refute."""
