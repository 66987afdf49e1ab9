"""Rows of tables: measures with their intervals, in words."""

from collections.abc import Iterable, Sequence

from prospect_mj.experiment.development.measures.measures import MEASURES
from prospect_mj.experiment.development.study.measured import Measured
from prospect_mj.experiment.paper.measures.measure import Measure
from prospect_mj.experiment.paper.measures.quantity import Kind, number, with_interval
from prospect_mj.experiment.paper.report.markdown import table

ORDER_TITLE = "Late gone first"
ORDER_DEFINED = (
    f"- *{ORDER_TITLE}*: Share of the resamples that have both kinds of corrections, "
    "and late ones gone before early ones."
)


def measured_table(
    first: Sequence[str],
    rows: Iterable[tuple[Sequence[str], Measured]],
    measures: Sequence[Measure] = MEASURES,
) -> str:
    """Two tables with a row for each population, as one would be too wide to be read.

    The first has what is counted in trials, and the order; the second has shares.

    Args:
        first: heads of the columns that name it.
        rows: what these columns have, and the numbers.
        measures: the other columns, besides the order.
    """
    known = list(rows)
    trials = [one for one in measures if one.kind is Kind.TRIAL]
    shares = [one for one in measures if one.kind is not Kind.TRIAL]
    head = (*first, "runs", *titles(trials), ORDER_TITLE)
    lines = [
        (*names, str(one.runs), *cells(one, trials), order(one.order))
        for names, one in known
    ]
    others = [(*names, *cells(one, shares)) for names, one in known]
    both = table(head, lines), table((*first, *titles(shares)), others)
    return "\n\n".join(both)


def order(share: float) -> str:
    """The share of the resamples in which late corrections are gone first."""
    return number(share, Kind.SHARE)


def titles(measures: Iterable[Measure]) -> list[str]:
    """Heads of columns."""
    return [one.title for one in measures]


def cells(one: Measured, measures: Iterable[Measure]) -> list[str]:
    """What the columns have of a row."""
    return [with_interval(one.measured[each.name], each.kind) for each in measures]
