"""Tables of the rows of the study."""

from collections.abc import Iterable, Iterator

import pyarrow as pa

from prospect_mj.experiment.development.measures.development import Development
from prospect_mj.experiment.development.measures.sequences import words
from prospect_mj.experiment.development.study.measured import ORDER, Measured, Told
from prospect_mj.experiment.development.study.rows import Row
from prospect_mj.experiment.paper.measures.bootstrap import band
from prospect_mj.experiment.populations.strategies import Strategy
from prospect_mj.experiment.run.learning_curve import BLOCK

_NAMES = {
    "part": pa.string(),
    "name": pa.string(),
    "rule": pa.string(),
    "world": pa.string(),
    "then": pa.string(),
    "touch": pa.string(),
    "categories": pa.int32(),
}
MEASURED_SCHEMA = pa.schema(
    {
        **_NAMES,
        "runs": pa.int32(),
        "measure": pa.string(),
        "estimate": pa.float64(),
        "low": pa.float64(),
        "high": pa.float64(),
        "lacking": pa.float64(),
    }
)
"""Trials or shares [1]; lacking: part of the resamples in which it is not there. The
measure `order` is a share of the resamples, and has no interval; one named after a
sequence of strategies is the share of the runs in which these alone prevail."""
SHARES_SCHEMA = pa.schema(
    {
        **_NAMES,
        "trials": pa.string(),
        "strategy": pa.string(),
        "trial": pa.int32(),
        "share": pa.float64(),
        "low": pa.float64(),
        "high": pa.float64(),
    }
)
"""Share of the easy or the difficult trials [1] in a set of ten that begins with a
trial, counted from the end of the pretraining."""
SEQUENCES_SCHEMA = pa.schema(
    {
        **_NAMES,
        "sequence": pa.string(),
        "share": pa.float64(),
        "low": pa.float64(),
        "high": pa.float64(),
    }
)
"""Share of the runs [1] in which these strategies prevail one after the other."""


def measured_table(rows: Iterable[Measured]) -> pa.Table:
    """All numbers, under `MEASURED_SCHEMA`."""
    lines = [line for row in rows for line in _measured_lines(row)]
    return pa.Table.from_pylist(lines, schema=MEASURED_SCHEMA)


def shares_table(developments: Iterable[tuple[Row, Development]]) -> pa.Table:
    """Curves of the strategies, under `SHARES_SCHEMA`."""
    lines = [line for pair in developments for line in _share_lines(*pair)]
    return pa.Table.from_pylist(lines, schema=SHARES_SCHEMA)


def sequences_table(rows: Iterable[Told]) -> pa.Table:
    """What single runs do, under `SEQUENCES_SCHEMA`."""
    lines = [
        _names(one.row)
        | {"sequence": words(found.sequence), "share": found.share.estimate}
        | {"low": found.share.low, "high": found.share.high}
        for one in rows
        for found in one.findings.sequences
    ]
    return pa.Table.from_pylist(lines, schema=SEQUENCES_SCHEMA)


def _names(row: Row) -> dict[str, str | int | None]:
    return {
        "part": row.part,
        "name": row.name,
        "rule": row.rule,
        "world": row.world,
        "then": row.then,
        "touch": row.touch,
        "categories": row.settings.categories,
    }


def _measured_lines(one: Measured) -> Iterator[dict[str, object]]:
    names = _names(one.row) | {"runs": one.runs}
    for name, found in one.measured.items():
        yield names | {"measure": name} | found._asdict()
    yield names | {"measure": ORDER, "estimate": one.order}


def _share_lines(row: Row, development: Development) -> Iterator[dict[str, object]]:
    switch = development.mean.switch
    for trials in ("easy", "difficult"):
        once, many = (getattr(curves, trials).strategies for curves in development)
        low, high = band(many)
        for strategy in Strategy:
            for number in range(switch, once.shape[2]):
                yield _names(row) | {
                    "trials": trials,
                    "strategy": strategy.name.lower(),
                    "trial": BLOCK * (number - switch),
                    "share": once[0, strategy, number],
                    "low": low[strategy, number],
                    "high": high[strategy, number],
                }
