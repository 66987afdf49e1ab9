"""What is claimed of the learners, and the prediction that comes from it."""

from collections.abc import Mapping, Sequence

from prospect_mj.experiment.development.claims.claim import (
    AS_PAPER,
    CONJECTURED,
    Claim,
    Subject,
)
from prospect_mj.experiment.development.claims.criteria import (
    LIKE_INFANTS,
    UNLIKE_INFANTS,
    Criterion,
    Judged,
    all_of,
    develops,
)
from prospect_mj.experiment.development.claims.findings import Findings
from prospect_mj.experiment.development.claims.single_runs import (
    ABRUPTLY,
    EACH_LATE_ALONE,
    LATE_ALONE,
    LATE_FIRST,
    change_words,
    mixed_in_mean,
    more_mixed,
)
from prospect_mj.experiment.paper.measures.quantity import Kind, with_interval
from prospect_mj.experiment.paper.measures.target import Verdict

Asked = Mapping[Subject, Mapping[str, Judged]]
"""Criteria by their names, of every row."""


def asked(rows: Mapping[Subject, Findings], criteria: Sequence[Criterion]) -> Asked:
    """Ask the same of all."""
    return {
        row: {one.name: one.judge(findings) for one in criteria}
        for row, findings in rows.items()
    }


def developing(rows: Mapping[Subject, Findings]) -> dict[Subject, Verdict]:
    """Whether each row develops as infants do, by all criteria together."""
    return {row: develops(findings) for row, findings in rows.items()}


def claims(rows: Mapping[Subject, Findings]) -> list[Claim]:
    """All claims, of the rows that are there."""
    found = []
    if AS_PAPER in rows:
        found.append(_paper(rows))
    if CONJECTURED in rows:
        found.append(_conjecture(rows))
        found += [_shared(rows, *one) for one in _OF_SINGLE_RUNS]
    if any(row.learner != CONJECTURED.learner for row in rows):
        found.append(_not_necessary(rows))
    return found


def _evidence(criteria: Mapping[str, Judged]) -> str:
    return "; ".join(f"{name}: {judged.words}" for name, judged in criteria.items())


def _paper(rows: Mapping[Subject, Findings]) -> Claim:
    judged = asked({AS_PAPER: rows[AS_PAPER]}, UNLIKE_INFANTS)[AS_PAPER]
    return Claim(
        "The paper's learner, free to repeat a failed action, is unlike infants in the "
        "two ways that the paper admits: corrections don't exceed the optimal strategy "
        "for fifty trials on end, and late ones are not gone before early ones.",
        all_of([one.verdict for one in judged.values()]),
        _evidence(judged),
        AS_PAPER.words,
    )


def _conjecture(rows: Mapping[Subject, Findings]) -> Claim:
    judged = asked({CONJECTURED: rows[CONJECTURED]}, LIKE_INFANTS)[CONJECTURED]
    return Claim(
        "A learner that discovers features as it needs them, and does not repeat what "
        "has just failed, goes through late, then early corrections, then the optimal "
        "strategy, as infants do.",
        all_of([one.verdict for one in judged.values()]),
        _evidence(judged),
        CONJECTURED.words,
    )


def _not_necessary(rows: Mapping[Subject, Findings]) -> Claim:
    others = {
        row: verdict
        for row, verdict in developing(rows).items()
        if row.learner != CONJECTURED.learner
    }
    like = [row.words for row, one in others.items() if one is Verdict.HOLDS]
    undecided = [row.words for row, one in others.items() if one is Verdict.OPEN]
    verdict = Verdict.OPEN if undecided else Verdict.FAILS
    evidence = f"by all criteria as infants: {'; '.join(like) or 'none of the others'}"
    if undecided:
        evidence += f"; undecided: {'; '.join(undecided)}"
    return Claim(
        "Discovery is not necessary to develop as infants do: learners without it meet "
        "all criteria.",
        Verdict.HOLDS if like else verdict,
        evidence,
        "all without discovery",
    )


_NAMED = 3
"""Others that are named, at the most."""

_OF_SINGLE_RUNS = (
    (
        LATE_FIRST,
        "In most single learners, not just in their mean, late corrections come before "
        "early ones: the median one before the median other.",
    ),
    (
        ABRUPTLY,
        "Single learners change from late to early corrections abruptly, as if within "
        "ten difficult trials.",
    ),
    (
        LATE_ALONE,
        "Before the mixture of late and early corrections there is a phase of late "
        "ones alone.",
    ),
    (
        EACH_LATE_ALONE,
        "Nearly every single learner has that phase of late corrections alone.",
    ),
)
"""Each with the words of the claim."""


def _shared(
    rows: Mapping[Subject, Findings], criterion: Criterion, words: str
) -> Claim:
    """A claim on the learner of the conjecture, and of whom else it holds."""
    judged = {row: criterion.judge(findings) for row, findings in rows.items()}
    its = judged.pop(CONJECTURED)
    also = [row.words for row, one in judged.items() if one.verdict is Verdict.HOLDS]
    said = its.words + _others(also, len(judged))
    return Claim(words, its.verdict, said, CONJECTURED.words, criterion.name)


def _others(also: Sequence[str], asked_of: int) -> str:
    """Of which others it holds, or of how many; a table of the report has them all."""
    if not asked_of:
        return ""
    named = len(also) <= _NAMED
    words = "; ".join(also) or "none" if named else f"{len(also)} of {asked_of}"
    return f"; of others it holds for {words}"


def between_learners(
    populations: Mapping[str, Findings], equal: Mapping[str, Findings]
) -> Claim:
    """Whether the mixture of a population of different learners is one of learners.

    It must be so of no population of equal ones: learners differ by chance as well.

    Args:
        populations: with spread parameters, by their learner; that of the conjecture is
            among them.
        equal: populations whose learners have the same parameters; empty where that
            part of the study was left out, and nothing is compared.
    """
    found = {name: _between(one, equal.get(name)) for name, one in populations.items()}
    its = found.pop(CONJECTURED.learner)
    also = [name for name, verdict in found.items() if verdict is Verdict.HOLDS]
    alone = EACH_LATE_ALONE.judge(populations[CONJECTURED.learner]).words
    evidence = f"late ones alone at first, {alone}; "
    evidence += change_words(populations[CONJECTURED.learner].changes)
    if same := equal.get(CONJECTURED.learner):
        common = with_interval(same.changes.common, Kind.RATIO)
        evidence += f", {common} of equal learners"
    if found:
        evidence += _others(also, len(found))
    return Claim(
        "Where learners differ, late and early corrections are mixed in their mean, "
        "more than where they are equal, and not within a learner; nearly each of them "
        "has a phase of late ones alone before.",
        its,
        evidence,
        f"{CONJECTURED.learner}, unlike learners",
        BETWEEN,
    )


def _between(findings: Findings, equal: Findings | None) -> Verdict:
    asked_of_each = ABRUPTLY, EACH_LATE_ALONE
    said = [one.judge(findings).verdict for one in asked_of_each]
    said.append(mixed_in_mean(findings))
    if equal is not None:
        said.append(more_mixed(findings, equal))
    return all_of(said)


BETWEEN = "between learners"
RESTS_ON = EACH_LATE_ALONE.name, ABRUPTLY.name, BETWEEN
"""Names of the claims that the prediction comes from."""
PREDICTION = (
    "A longitudinal study that films the same children every few days, in place of "
    "different children of three ages, will find two things if children learn as this "
    "learner does, which does not repeat what has just failed. Nearly each child has a "
    "phase of late corrections alone before early ones recur. And a child changes from "
    "late to early corrections within about ten difficult trials: the mixture at 9 "
    "months is one of children, not within a child."
)
"""That a study of children could refute."""
