"""The report on what the paper leaves open."""

from collections.abc import Iterable, Sequence
from math import isinf

from prospect_mj.experiment.paper import ablation
from prospect_mj.experiment.paper.ablation import PUBLISHED, Row
from prospect_mj.experiment.paper.markdown import table
from prospect_mj.experiment.paper.sample import title
from prospect_mj.experiment.paper.statements import Kind, with_interval


def section(rows: Sequence[Row], runs: int) -> Iterable[str]:
    """The report, a piece at a time, on choices that had `runs` learners each."""
    yield "## What the published text leaves open"
    yield (
        f"One choice at a time round the default, {runs} runs "
        "per scenario and choice. The distance is the sum of squared differences from "
        "the four published numbers, each in tenths of the number; inside of the "
        "published range there is none. Where something is never reached, the end "
        "counts, and the distance is a lower bound (>=)."
    )
    heads = [title(p.measure).lower() for p in PUBLISHED.values()]
    published = [p.target.words for p in PUBLISHED.values()]
    yield table(
        ("left open", "choice", *heads, "distance"),
        [("", "**the paper**", *published, "0"), *map(_row, rows)],
    )
    by_factor: dict[str, list[Row]] = {}
    for row in rows:
        by_factor.setdefault(row.variant.factor, []).append(row)
    yield "\n".join(_fit(factor, rows) for factor, rows in by_factor.items())


def _row(row: Row) -> tuple[str, ...]:
    kinds = [published.kind for published in PUBLISHED.values()]
    measured = row.measured.values()
    cells = [with_interval(m, kind) for m, kind in zip(measured, kinds, strict=True)]
    bound = ">= " if any(isinf(m.estimate) for m in measured) else ""
    mark = " (default)" if row.is_default else ""
    distance = bound + with_interval(row.distance, Kind.RATIO)
    return (row.variant.factor, row.variant.choice + mark, *cells, distance)


def _fit(factor: str, rows: list[Row]) -> str:
    """Which choice of a factor fits best, in a line."""
    best = ablation.best(rows)
    also = [r.variant.choice for r in ablation.as_good(rows) if r is not best]
    words = f"- {factor}: *{best.variant.choice}* fits best"
    if also:
        words += f", no better by its interval than {', '.join(also)}"
    default = next(row.variant.choice for row in rows if row.is_default)
    return f"{words}; the default is *{default}*."
