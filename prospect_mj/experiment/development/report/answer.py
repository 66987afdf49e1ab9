"""The answer, in sentences that follow from the verdicts."""

from collections.abc import Iterable, Iterator, Mapping

from prospect_mj.experiment.development.claims.change import AGAIN
from prospect_mj.experiment.development.claims.claim import (
    AS_PAPER,
    CONJECTURED,
    Claim,
    Subject,
)
from prospect_mj.experiment.development.claims.claims import claims, developing
from prospect_mj.experiment.development.claims.findings import Findings
from prospect_mj.experiment.development.claims.worlds import ORDER_EVERYWHERE
from prospect_mj.experiment.development.measures.measures import MEASURES
from prospect_mj.experiment.development.report.needs import NEEDS
from prospect_mj.experiment.paper.measures.quantity import with_interval
from prospect_mj.experiment.paper.measures.target import Verdict

Rows = Mapping[Subject, Findings]

_SHOWS = {
    Verdict.HOLDS: "Yes",
    Verdict.FAILS: "No",
    Verdict.OPEN: "Undecided with so many runs",
}
_SEQUENCE = "late_gone", "early_gone", "dominance", "easy_worst"

_OTHER_PARTS = {
    NEEDS: (
        "With contexts split by force, and values that follow as in the discovery "
        "learner as it is, development by all criteria {} that insertions split before "
        "grasps and that values are re-estimated at the split.",
        {
            Verdict.HOLDS: "needs both",
            Verdict.FAILS: "does not need both",
            Verdict.OPEN: "may need both",
        },
    ),
    ORDER_EVERYWHERE: (
        "With discovery late corrections {} before early ones in every world of "
        "pictures that was tried.",
        {
            Verdict.HOLDS: "are gone",
            Verdict.FAILS: "are not gone",
            Verdict.OPEN: "may or may not be gone",
        },
    ),
    f"{AGAIN}, post": (
        "When, after learning, the other end becomes the right one to hold, the "
        "learner that discovers {} through all stages again.",
        {
            Verdict.HOLDS: "goes",
            Verdict.FAILS: "does not go",
            Verdict.OPEN: "may or may not go",
        },
    ),
}
"""By name of a claim, what it comes to."""


def answer(rows: Rows, found: Iterable[Claim] = ()) -> str:
    """A few sentences, each by the verdict on what it says.

    Args:
        rows: the learners under both rules.
        found: claims of other parts.
    """
    said = developing(rows)
    parts = [_conjecture(rows, said), _others(said), _paper(rows), *_further(found)]
    return " ".join(part for part in parts if part)


def _conjecture(rows: Rows, said: Mapping[Subject, Verdict]) -> str:
    if CONJECTURED not in rows:
        return ""
    kinds = {one.name: one.kind for one in MEASURES}
    found = rows[CONJECTURED].measured
    late, early, led, easy = (
        with_interval(found[name], kinds[name]) for name in _SEQUENCE
    )
    return (
        "Does a learner that discovers features as it needs them, and doesn't repeat "
        "what has just failed, develop as infants do? "
        f"**{_SHOWS[said[CONJECTURED]]}**, by all criteria together: in difficult "
        f"trials late corrections are gone after {late} trials, early ones after "
        f"{early}; corrections exceed the optimal strategy for {led} trials on end, "
        f"and the worst block of easy trials is {easy} optimal. The criteria don't ask "
        "for an age at which both corrections are as frequent, as at nine months: that "
        "is looked for below, beside the stages of infants."
    )


def _others(said: Mapping[Subject, Verdict]) -> str:
    """Which of the learners without discovery do the same."""
    like = [
        row.words
        for row, verdict in said.items()
        if verdict is Verdict.HOLDS and row.learner != CONJECTURED.learner
    ]
    if like:
        return (
            "Discovery is not necessary for it: the same criteria are met by "
            f"{_listed(like)}, without any discovery."
        )
    return "No learner without discovery is shown to meet the same criteria."


def _paper(rows: Rows) -> str:
    if AS_PAPER not in rows:
        return ""
    (claim,) = claims({AS_PAPER: rows[AS_PAPER]})[:1]
    shows = {
        Verdict.HOLDS: "is unlike infants in both ways that the paper admits",
        Verdict.FAILS: "is not unlike infants in both ways that the paper admits",
    }
    words = shows.get(claim.verdict, "may or may not be unlike infants as it admits")
    return f"The paper's own learner, free to repeat a failed action, {words}."


def _further(found: Iterable[Claim]) -> Iterator[str]:
    """What the other parts say of the learner of the conjecture, a sentence each."""
    for one in found:
        if one.name in _OTHER_PARTS and one.of.startswith(CONJECTURED.learner):
            words, by_verdict = _OTHER_PARTS[one.name]
            yield words.format(by_verdict[one.verdict])


def _listed(names: list[str]) -> str:
    marked = [f"*{name}*" for name in names]
    if len(marked) == 1:
        return marked[0]
    return f"{'; '.join(marked[:-1])}; and {marked[-1]}"
