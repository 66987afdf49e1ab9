"""The answer, as it follows from the verdicts; the claims; the prediction."""

from collections.abc import Iterator, Mapping

from prospect_mj.experiment.development.claims.claims import (
    AS_PAPER,
    CONJECTURED,
    PREDICTION,
    RESTS_ON,
    Claim,
    Row,
    between_learners,
    claims,
    developing,
)
from prospect_mj.experiment.development.claims.findings import Findings
from prospect_mj.experiment.development.measures.measures import (
    MEASURES,
    other_first,
)
from prospect_mj.experiment.development.report.command import command
from prospect_mj.experiment.development.report.needs import needs
from prospect_mj.experiment.development.study.measured import Told
from prospect_mj.experiment.development.study.results import Results
from prospect_mj.experiment.paper.measures.quantity import with_interval
from prospect_mj.experiment.paper.measures.target import Verdict
from prospect_mj.experiment.paper.report.markdown import table

Rows = Mapping[Row, Findings]

_SHOWS = {
    Verdict.HOLDS: "Yes",
    Verdict.FAILS: "No",
    Verdict.OPEN: "Undecided with so many runs",
}
_SEQUENCE = "late_gone", "early_gone", "dominance", "easy_worst"


def opening(results: Results) -> Iterator[str]:
    """The first sections, a piece at a time."""
    rows = by_row(results.learners)
    if not rows:
        yield "The part `learners`, from which the answer follows, was left out."
        return
    found = claims(rows)
    if results.causal:
        found.append(needs({one.row.name: one for one in results.causal}))
        yield f"{answer(rows)} {_reason(found[-1])}"
    else:
        yield answer(rows)
    spread = {one.row.name: one.findings for one in results.population}
    if CONJECTURED.learner in spread:
        found.append(between_learners(spread))
    yield "## Claims"
    for verdict, title in (
        (Verdict.HOLDS, "What holds"),
        (Verdict.FAILS, "What doesn't hold"),
        (Verdict.OPEN, "What is undecided"),
    ):
        yield from _claims(title, [one for one in found if one.verdict is verdict])
    yield command(results, "learners", "causal", "population")
    yield "## A prediction"
    yield _prediction(found, spread)


def by_row(learners: list[Told]) -> dict[Row, Findings]:
    """What is claimed of, by learner and rule."""
    return {Row(one.row.name, one.row.rule): one.findings for one in learners}


def answer(rows: Rows) -> str:
    """A few sentences, each by the verdict on what it says.

    Args:
        rows: the learners under both rules.
    """
    said = developing(rows)
    parts = [_conjecture(rows, said), _others(said), _paper(rows)]
    return " ".join(part for part in parts if part)


def _conjecture(rows: Rows, said: Mapping[Row, Verdict]) -> str:
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
        f"and the worst block of easy trials is {easy} optimal."
    )


def _others(said: Mapping[Row, Verdict]) -> str:
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


def _reason(needed: Claim) -> str:
    """What development takes in the discovery learner."""
    does = {Verdict.HOLDS: "needs both", Verdict.FAILS: "does not need both"}
    verb = does.get(needed.verdict, "may need both")
    return (
        f"With contexts split by force the order {verb} of what seems to make it: that "
        "insertions split before grasps, and that values are re-estimated at the split."
    )


def _listed(names: list[str]) -> str:
    marked = [f"*{name}*" for name in names]
    if len(marked) == 1:
        return marked[0]
    return f"{'; '.join(marked[:-1])}; and {marked[-1]}"


def _claims(title: str, found: list[Claim]) -> Iterator[str]:
    if found:
        yield f"### {title}"
        yield table(
            ("claim", "what was measured"), [(one.words, one.evidence) for one in found]
        )


def _prediction(found: list[Claim], spread: Mapping[str, Findings]) -> str:
    """It is worth something only as far as the claims hold that it comes from."""
    come = [one for one in found if one.name in RESTS_ON]
    rests = "; ".join(f"*{one.words}* ({one.verdict})" for one in come)
    said = PREDICTION, f"It rests on these claims: {rests}", _apart(spread)
    return "\n\n".join(words for words in said if words)


def _apart(spread: Mapping[str, Findings]) -> str:
    """What tells populations apart that may keep to the prediction alike."""
    first = {
        name: with_interval(one.measured[other_first.name], other_first.kind)
        for name, one in spread.items()
    }
    if set(first) <= {CONJECTURED.learner}:
        return ""
    told = "; ".join(f"*{name}*, {words}" for name, words in first.items())
    return (
        "It does not tell discovery from replay, as far as the last of these claims "
        "holds for both. What comes before the corrections may: neither optimal nor "
        f"corrected are, of the difficult ones of the first fifty trials, {told}."
    )
