"""The report on what the paper states."""

from collections.abc import Iterable, Sequence

from prospect_mj.experiment.paper.measures import statements
from prospect_mj.experiment.paper.measures.quantity import with_interval
from prospect_mj.experiment.paper.measures.sample import Sample
from prospect_mj.experiment.paper.measures.statements import (
    Judgement,
    Statement,
    by_statement,
)
from prospect_mj.experiment.paper.report.markdown import definitions, table


def published(judgements: Sequence[Judgement]) -> Iterable[str]:
    """The paper's statements beside what was measured, a piece at a time."""
    yield "## What the paper states"
    rows = []
    for said, of_it, together in by_statement(judgements):
        verdict = f"**{together}**" + _fitted(said)
        rows.append((said.text, said.target.words, _measured(of_it), verdict))
    yield table(("the paper", "as a number", "measured", "verdict"), rows)
    yield (
        "A measure confirms a statement if all of its interval is in the range, "
        "contradicts it if none of it is, and leaves it undecided otherwise, as most "
        "small studies do. Where the paper doesn't say how it measured, there are "
        "several measures of the same: the statement then holds if it does by all of "
        "them, does not if all contradict it, depends on the measure if one confirms "
        "and one contradicts it, and is undecided otherwise. "
        "*Fitted*: what the paper leaves open, above all the scale of the histogram "
        "and the initial weights, was chosen by this number; that it comes out is no "
        "prediction. No setting of the learner was chosen by the other rows."
    )
    yield definitions(dict.fromkeys(judged.measure for judged in judgements))


def _fitted(said: Statement) -> str:
    if said.follows:
        return ", follows from two fitted ones"
    return ", fitted" if said.fitted else ""


def _measured(judgements: Sequence[Judgement]) -> str:
    """What each measure came to, and its verdict if there are several."""
    several = len(judgements) > 1
    return "<br>".join(
        f"{judged.measure.title}: {with_interval(judged.measured, judged.measure.kind)}"
        + (f", {judged.verdict}" if several else "")
        for judged in judgements
    )


def further(sample: Sample) -> Iterable[str]:
    """What was measured beside."""
    yield "## Measured beside"
    yield table(
        ("what", "measured"),
        [
            (measure.title, with_interval(measure.estimate(sample), measure.kind))
            for measure in statements.FURTHER
        ],
    )
    yield definitions(statements.FURTHER)
