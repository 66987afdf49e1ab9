"""The report on what the paper leaves open."""

from collections.abc import Iterable, Sequence
from math import isinf

from prospect_mj.experiment.paper import ablation
from prospect_mj.experiment.paper.ablation import PUBLISHED, Row
from prospect_mj.experiment.paper.markdown import table
from prospect_mj.experiment.paper.quantity import Kind, number, with_interval
from prospect_mj.experiment.paper.sample import title


def section(rows: Sequence[Row], runs: int) -> Iterable[str]:
    """The report, a piece at a time, on choices that had `runs` learners each."""
    yield "## What the published text leaves open"
    yield (
        f"One choice at a time round the default, {runs} runs "
        "per scenario and choice. The distance is the sum of squared differences from "
        "the four published ranges, each in tenths of the number; inside of the "
        "range there is none. Where something is never reached, the end "
        "counts, and the distance is a lower bound (>=). All choices have runs of the "
        "same seeds and the same resamples of them; whether one is better than another "
        "is judged by the interval of the difference of their distances."
    )
    heads = [title(p.measure).lower() for p in PUBLISHED.values()]
    published = [p.target.words for p in PUBLISHED.values()]
    factors = ablation.by_factor(rows)
    lines = [
        _line(row, ablation.best(choices))
        for choices in factors.values()
        for row in choices
    ]
    yield table(
        ("left open", "choice", *heads, "distance", "farther than the best"),
        [("", "**the paper**", *published, "0", ""), *lines],
    )
    yield "\n".join(_fit(factor, rows) for factor, rows in factors.items())


def _line(row: Row, best: Row) -> tuple[str, ...]:
    kinds = [published.kind for published in PUBLISHED.values()]
    measured = row.measured.values()
    cells = [with_interval(m, kind) for m, kind in zip(measured, kinds, strict=True)]
    mark = " (default)" if row.is_default else ""
    farther = with_interval(ablation.farther(row, best), Kind.RATIO)
    return (
        row.variant.factor,
        row.variant.choice + mark,
        *cells,
        _distance(row),
        "best" if row is best else farther,
    )


def _distance(row: Row) -> str:
    """With its interval; lower bounds are marked."""
    bounds = [
        any(isinf(measured[part]) for measured in row.measured.values())
        for part in range(3)
    ]
    estimate, low, high = (
        (">= " if bound else "") + number(value, Kind.RATIO)
        for bound, value in zip(bounds, row.distance, strict=False)
    )
    return f"{estimate} ({low} to {high})"


def _fit(factor: str, rows: list[Row]) -> str:
    """Which choice of a factor fits best, in a line."""
    best = ablation.best(rows)
    also = [r.variant.choice for r in ablation.as_good(rows) if r is not best]
    words = f"- {factor}: *{best.variant.choice}* fits best"
    if also:
        words += f", not to be told from {', '.join(also)}"
    default = next(row.variant.choice for row in rows if row.is_default)
    return f"{words}; the default is *{default}*."
