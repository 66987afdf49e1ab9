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
    """A table with a row for each population.

    Args:
        first: heads of the columns that name it.
        rows: what these columns have, and the numbers.
        measures: the other columns, besides the order.
    """
    head = (*first, "runs", *(one.title for one in measures), ORDER_TITLE)
    return table(head, [(*names, *_cells(one, measures)) for names, one in rows])


def order(share: float) -> str:
    """The share of the resamples in which late corrections are gone first."""
    return number(share, Kind.SHARE)


def _cells(one: Measured, measures: Sequence[Measure]) -> list[str]:
    numbers = [with_interval(one.measured[each.name], each.kind) for each in measures]
    return [str(one.runs), *numbers, order(one.order)]
