"""The report on what the paper states, and on infants."""

from collections.abc import Iterable, Sequence

from prospect_mj.experiment.paper import stages, statements
from prospect_mj.experiment.paper.markdown import definitions, table
from prospect_mj.experiment.paper.sample import Sample, estimate, title
from prospect_mj.experiment.paper.statements import (
    Judgement,
    Kind,
    Verdict,
    with_interval,
)

_INFANTS = (
    (
        "optimal in difficult trials",
        "wrong grips frequent at 9 and 14 months, rare at 19",
        "optimal",
    ),
    (
        "early corrections in difficult trials",
        "as many as late ones at 9 months, strongly preferred at 14, not needed at 19",
        "early",
    ),
    ("late corrections in difficult trials", "gone before the early ones", "late"),
    (
        "early ones in all corrections",
        "about a half at 9 months, most at 14",
        "preference",
    ),
    ("optimal in easy trials", "mostly, at all ages", "easy_optimal"),
)


def published(judgements: Sequence[Judgement]) -> Iterable[str]:
    """The paper's statements beside what was measured, a piece at a time."""
    yield "## What the paper states"
    rows = []
    for judged in judgements:
        said = judged.statement
        measured = with_interval(judged.measured, said.kind)
        what = f"{title(said.measure)}: {measured}"
        rows.append((said.text, said.target.words, what, f"**{judged.verdict}**"))
    yield table(("the paper", "as a number", "measured", "verdict"), rows)
    yield (
        "A statement with a number of its own holds if the interval overlaps a tenth "
        "of it to either side. A comparison holds if all of the interval fulfils it, "
        "does not hold if none does, and is undecided otherwise."
    )
    measures = dict.fromkeys(judged.statement.measure for judged in judgements)
    yield definitions(measures)


def further(sample: Sample) -> Iterable[str]:
    """What was measured beside."""
    yield "## Measured beside"
    rows = [
        (title(measure), with_interval(estimate(measure, sample), kind))
        for measure, kind in statements.FURTHER
    ]
    yield table(("what", "measured"), rows)
    yield definitions([measure for measure, _ in statements.FURTHER])


def infants(sample: Sample) -> Iterable[str]:
    """The order of strategies in infants and in the agent."""
    yield "## Infants"
    yield (
        "Order only: the percentages of McCarty, Clifton and Collard (1999) were not "
        "at hand, and none is made up here. What is said of infants is what the paper "
        "tells of them (sections 2 and 3.2)."
    )
    found = stages.stages(sample)
    heads = [f"trials {stage.first} to {stage.last}" for stage in found]
    yield table(
        ("", "infants", *(f"agent, {head}" for head in heads)),
        [
            (
                what,
                of_infants,
                *(with_interval(getattr(s, name), Kind.SHARE) for s in found),
            )
            for what, of_infants, name in _INFANTS
        ],
    )
    gone = statements.judge(sample, [statements.EARLY_FIRST])[0]
    first = {
        Verdict.HOLDS: "the early one",
        Verdict.FAILS: "not the early one",
        Verdict.OPEN: "undecided",
    }[gone.verdict]
    yield (
        "Which correction disappears first: in infants the late one; in the agent: "
        f"{first}. In the paper's agent it was the early one."
    )
