"""All tables of the study, by the name of their file."""

from collections.abc import Iterator

import pyarrow as pa

from prospect_mj.experiment.development.study.abstract_besides import (
    besides,
    besides_table,
)
from prospect_mj.experiment.development.study.measured import (
    Measured,
    MeasuredCurves,
    Told,
)
from prospect_mj.experiment.development.study.results import Results
from prospect_mj.experiment.development.study.row_tables import (
    measured_table,
    sequences_table,
    shares_table,
)

MEASURED, SHARES, SEQUENCES = "measured", "shares", "sequences"
LOOKS, FOUND, ABSTRACT = "looks", "found", "abstract"


def tables(results: Results) -> dict[str, pa.Table]:
    """Those of the parts that were made."""
    made = {}
    curves = [*results.learners, *results.population]
    curves += [*results.worlds, *results.change]
    curves += [*results.touches, *results.by_number]
    numbers = [*_measured(curves), *results.formerly_easy]
    numbers += [*results.causal, *results.towards_abstract]
    if numbers:
        made[MEASURED] = measured_table(numbers)
    if curves:
        made[SHARES] = shares_table((one.row, one.development) for one in curves)
    if told := [*results.learners, *results.population]:
        made[SEQUENCES] = sequences_table(told)
    if beside := besides(results):
        made[ABSTRACT] = besides_table(beside)
    if results.looks is not None:
        made[LOOKS] = results.looks
    if results.found is not None:
        made[FOUND] = results.found.table
    for others in (results.haptics, results.rivals):
        made |= {} if others is None else others.tables
    return made


def _measured(rows: list[Told | MeasuredCurves]) -> Iterator[Measured]:
    for row in rows:
        yield row.measured
