"""The report on what the paper leaves open."""

from collections.abc import Iterable, Sequence
from math import isinf

from prospect_mj.experiment.paper.ablation import choices
from prospect_mj.experiment.paper.ablation.choices import Row
from prospect_mj.experiment.paper.measures.quantity import Kind, number, with_interval
from prospect_mj.experiment.paper.measures.statements import FITTED, Judgement
from prospect_mj.experiment.paper.report.markdown import table


def section(rows: Sequence[Row], runs: int) -> Iterable[str]:
    """The report, a piece at a time, on choices that had `runs` learners each."""
    factors = choices.by_factor(rows)
    yield "## What the published text leaves open"
    yield (
        f"One thing changed at a time, some with the histogram's scale as well, {runs} "
        "runs per scenario and choice, none of them one of the runs above. The "
        "distance is the sum of squared differences from the four published ranges "
        "that are fitted, each in tenths of the number; inside of the range there is "
        "none. Where something is never reached, the end of the study counts, and the "
        "distance is a lower bound (>=). The scale of the histogram was chosen with "
        "the default's other choices; some that fit worse are tried at other scales "
        "too, those that a coarse search found nearest for them. All choices have "
        "runs of the same seeds and the same resamples of them; whether one is "
        "farther from the paper than the default is judged by the interval of the "
        "difference of their distances."
    )
    default = choices.default_of(rows)
    heads = [m.title.lower() for said in FITTED for m in said.measures]
    published = [said.target.words for said in FITTED for _ in said.measures]
    yield table(
        ("left open", "choice", *heads, "distance", "farther than the default"),
        [
            ("", "**the paper**", *published, "0", ""),
            ("", "**the default**", *_cells(default), ""),
            *(_line(row, default) for row in rows if not row.is_default),
        ],
    )
    yield _rule(factors.values())
    yield "\n".join(_fit(factor, of_it) for factor, of_it in factors.items())
    yield from _verdicts(list(factors.values()))


def _line(row: Row, default: Row) -> tuple[str, ...]:
    farther = with_interval(choices.farther(row, default), Kind.RATIO)
    return row.variant.factor, row.variant.choice, *_cells(row), farther


def _cells(row: Row) -> tuple[str, ...]:
    """What is fitted, and the distance."""
    cells = (with_interval(j.measured, j.measure.kind) for j in row.fitted)
    return *cells, _distance(row)


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
        "beyond doubt; as good are those that can't be told from it"
    )
    doubted = [_name(row) for rows in factors for row in choices.nearer(rows)]
    if not doubted:
        return f"{rule}. None is nearer."
    return f"{rule}. Nearer than the default: {'; '.join(doubted)}."


def _fit(factor: str, rows: Sequence[Row]) -> str:
    """Which choices for one thing are as good as the default, in a line."""
    default, nearest = choices.default_of(rows), choices.nearest(rows)
    alike = "; ".join(f"*{row.variant.choice}*" for row in choices.as_good(rows))
    distance = number(nearest.distance.estimate, Kind.RATIO)
    return (
        f"- {factor}: *{default.variant.choice}* is the default; as good: "
        f"{alike or 'no other'}; smallest distance: *{nearest.variant.choice}*, "
        f"{distance}."
    )


def _verdicts(factors: Sequence[Sequence[Row]]) -> Iterable[str]:
    """What the statements come to with the choices that are as good as the default."""
    default = choices.default_of(factors[0])
    alike = [row for rows in factors for row in choices.as_good(rows)]
    yield (
        f"Every measure of a statement with the default, and with the {len(alike)} "
        "choices that are as good:"
    )
    lines = [
        _verdict(judged, [(row, row.judgements[place]) for row in alike])
        for place, judged in enumerate(default.judgements)
    ]
    yield table(("measure", "with the default", "the same with", "but"), lines)


def _verdict(
    judged: Judgement, others: Sequence[tuple[Row, Judgement]]
) -> tuple[str, ...]:
    """What one measure says, and where it says something else."""
    other = [(row, o.verdict) for row, o in others if o.verdict != judged.verdict]
    return (
        judged.measure.title + (" (fitted)" if judged.statement.fitted else ""),
        f"**{judged.verdict}**",
        f"{len(others) - len(other)} of {len(others)}",
        "; ".join(f"{verdict} with {_name(row)}" for row, verdict in other),
    )


def _name(row: Row) -> str:
    return f"{row.variant.factor} *{row.variant.choice}*"
