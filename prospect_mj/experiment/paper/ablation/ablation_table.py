"""All choices for what the paper leaves open as one table."""

from collections.abc import Sequence

import pyarrow as pa

from prospect_mj.experiment.paper.ablation.choices import (
    Row,
    by_factor,
    default_of,
    farther,
)


def table(rows: Sequence[Row]) -> pa.Table:
    """A row per choice: its distance, and every measure with its verdict.

    A number has three columns, its own and those of its interval's bounds; what
    follows from a statement is named for its measure.
    """
    return pa.Table.from_pylist(
        [
            _columns(row, default_of(choices))
            for choices in by_factor(rows).values()
            for row in choices
        ]
    )


def _columns(row: Row, default: Row) -> dict[str, object]:
    """A row of the table; `default` is the choice of the same thing that is kept."""
    columns: dict[str, object] = {
        "factor": row.variant.factor,
        "choice": row.variant.choice,
        "default": row.is_default,
    }
    numbers = {judged.measure.name: judged.measured for judged in row.judgements}
    beside = {"distance": row.distance, "farther": farther(row, default)}
    for name, measured in {**numbers, **beside}.items():
        names = (name, f"{name}_low", f"{name}_high")
        columns |= dict(zip(names, measured[:3], strict=True))
    for judged in row.judgements:
        columns[f"{judged.measure.name}_verdict"] = str(judged.verdict)
    return columns
