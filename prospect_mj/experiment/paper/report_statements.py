"""The report on what the paper states."""

from collections.abc import Iterable, Sequence

from prospect_mj.experiment.paper import statements
from prospect_mj.experiment.paper.markdown import definitions, table
from prospect_mj.experiment.paper.quantity import with_interval
from prospect_mj.experiment.paper.sample import Sample, estimate, title
from prospect_mj.experiment.paper.statements import Judgement
from prospect_mj.experiment.paper.target import Verdict, agreed


def published(judgements: Sequence[Judgement]) -> Iterable[str]:
    """The paper's statements beside what was measured, a piece at a time."""
    yield "## What the paper states"
    rows = []
    for judged in judgements:
        said = judged.statement
        measured = with_interval(judged.measured, said.kind)
        what = f"{title(said.measure)}: {measured}"
        verdict = f"**{judged.verdict}**" + (", fitted" if said.fitted else "")
        rows.append((said.text, said.target.words, what, verdict))
    yield table(("the paper", "as a number", "measured", "verdict"), rows)
    yield (
        "A statement holds if all of the interval is in the range, does not hold if "
        "none of it is, and is undecided otherwise, as most are in a small study. "
        "*Fitted*: what the paper leaves open, above all the scale of the histogram "
        "and the initial weights, was chosen by this number; that it comes out is no "
        "prediction. The other rows had no part in any choice."
    )
    measures = dict.fromkeys(judged.statement.measure for judged in judgements)
    yield definitions(measures)
    yield _order_of_corrections(judgements)


def _order_of_corrections(judgements: Sequence[Judgement]) -> str:
    """Whether it can be told which correction disappears first."""
    said = agreed(
        j.verdict for j in judgements if j.statement in statements.EARLY_FIRST
    )
    match said:
        case Verdict.HOLDS:
            words = (
                "By both measures early corrections disappear first, as in the paper."
            )
        case Verdict.FAILS:
            words = "By neither measure do early corrections disappear first."
        case Verdict.OPEN:
            words = (
                "Which correction disappears first can't be told: the two measures of "
                "it don't agree, or leave it open."
            )
    return (
        f"{words} There are two, as the paper doesn't say what it calls disappeared, "
        "and a rarer correction is nearer to any fixed share."
    )


def further(sample: Sample) -> Iterable[str]:
    """What was measured beside."""
    yield "## Measured beside"
    rows = [
        (title(measure), with_interval(estimate(measure, sample), kind))
        for measure, kind in statements.FURTHER
    ]
    yield table(("what", "measured"), rows)
    yield definitions([measure for measure, _ in statements.FURTHER])
