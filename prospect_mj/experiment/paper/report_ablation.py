"""The report on what the paper leaves open."""

from collections.abc import Iterable, Sequence
from math import isinf

from prospect_mj.experiment.paper import ablation
from prospect_mj.experiment.paper.ablation import Row
from prospect_mj.experiment.paper.markdown import table
from prospect_mj.experiment.paper.quantity import Kind, number, with_interval
from prospect_mj.experiment.paper.sample import title
from prospect_mj.experiment.paper.statements import FITTED, Judgement


def section(rows: Sequence[Row], runs: int) -> Iterable[str]:
    """The report, a piece at a time, on choices that had `runs` learners each."""
    factors = ablation.by_factor(rows)
    yield "## What the published text leaves open"
    yield (
        f"One choice at a time round the default, {runs} runs per scenario and choice, "
        "none of them one of the runs above. The distance is the sum of squared "
        "differences from the four published ranges that are fitted, each in tenths of "
        "the number; inside of the range there is none. Where something is never "
        "reached, the end counts, and the distance is a lower bound (>=). All choices "
        "have runs of the same seeds and the same resamples of them; whether one is "
        "farther from the paper than the default is judged by the interval of the "
        "difference of their distances."
    )
    heads = [title(said.measure).lower() for said in FITTED]
    published = [said.target.words for said in FITTED]
    lines = [
        _line(row, ablation.default_of(choices))
        for choices in factors.values()
        for row in choices
    ]
    yield table(
        ("left open", "choice", *heads, "distance", "farther than the default"),
        [("", "**the paper**", *published, "0", ""), *lines],
    )
    yield _rule(factors.values())
    yield "\n".join(_fit(factor, rows) for factor, rows in factors.items())
    yield from _verdicts(list(factors.values()))


def _line(row: Row, default: Row) -> tuple[str, ...]:
    cells = [with_interval(j.measured, j.statement.kind) for j in row.fitted]
    mark = " (default)" if row is default else ""
    farther = with_interval(ablation.farther(row, default), Kind.RATIO)
    return (
        row.variant.factor,
        row.variant.choice + mark,
        *cells,
        _distance(row),
        "" if row is default else farther,
    )


def _distance(row: Row) -> str:
    """With its interval; lower bounds are marked."""
    estimate, low, high = (
        (">= " if any(isinf(judged.measured[part]) for judged in row.fitted) else "")
        + number(value, Kind.RATIO)
        for part, value in enumerate(row.distance[:3])
    )
    return f"{estimate} ({low} to {high})"


def _rule(factors: Iterable[Sequence[Row]]) -> str:
    """Why the defaults are what they are, and whether that still holds."""
    rule = (
        "A choice inside of all ranges is at no distance, and among several such ones "
        "none is the best. So a default is kept as long as no other choice is nearer "
        "beyond doubt; *as good* are those that can't be told from it"
    )
    doubted = [_name(row) for rows in factors for row in ablation.nearer(rows)]
    if not doubted:
        return f"{rule}. None is nearer."
    return f"{rule}. Nearer than the default: {'; '.join(doubted)}."


def _fit(factor: str, rows: Sequence[Row]) -> str:
    """Which choices for one thing are as good as the default, in a line."""
    default = ablation.default_of(rows).variant.choice
    alike = [row.variant.choice for row in ablation.as_good(rows)]
    return f"- {factor}: *{default}* (default); as good: {'; '.join(alike) or 'none'}."


def _verdicts(factors: Sequence[Sequence[Row]]) -> Iterable[str]:
    """What the statements come to with the choices that are as good as the default."""
    default = ablation.default_of(factors[0])
    alike = [row for rows in factors for row in ablation.as_good(rows)]
    yield (
        f"Every statement with the default, and with the {len(alike)} choices that "
        "are as good:"
    )
    lines = [
        _verdict(judged, [(row, row.judgements[number]) for row in alike])
        for number, judged in enumerate(default.judgements)
    ]
    yield table(("statement", "with the default", "the same with", "but"), lines)


def _verdict(
    judged: Judgement, others: Sequence[tuple[Row, Judgement]]
) -> tuple[str, ...]:
    """One statement's verdict, and where it is another."""
    other = [(row, o.verdict) for row, o in others if o.verdict != judged.verdict]
    said = judged.statement
    return (
        title(said.measure) + (" (fitted)" if said.fitted else ""),
        f"**{judged.verdict}**",
        f"{len(others) - len(other)} of {len(others)}",
        "; ".join(f"{verdict} with {_name(row)}" for row, verdict in other),
    )


def _name(row: Row) -> str:
    return f"{row.variant.factor} *{row.variant.choice}*"
