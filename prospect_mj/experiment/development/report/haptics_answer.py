"""What categories of grasps tell and do, in sentences that follow from the numbers."""

from collections.abc import Iterable, Iterator, Mapping
from itertools import groupby
from typing import Any

import pyarrow as pa

from prospect_mj.experiment.development.claims.criteria import develops
from prospect_mj.experiment.development.haptics import ends
from prospect_mj.experiment.development.haptics.touch import BITS, CATEGORY, END
from prospect_mj.experiment.development.measures.measures import (
    early_gone,
    early_most,
    late_gone,
    late_most,
)
from prospect_mj.experiment.development.report.haptics_claims import CHANCE, percent
from prospect_mj.experiment.development.report.haptics_compared import (
    Telling,
    tellings,
)
from prospect_mj.experiment.development.study.measured import MeasuredCurves
from prospect_mj.experiment.paper.measures.measure import Measure

_CLASSES = {
    "in nine grasps of ten at least": 0.9,
    "in three of four at least": 0.75,
    "better than by chance": CHANCE,
}
"""Each with what all of the interval is above [1]."""
_UNKNOWN = "not better than by chance, as far as so few presentations show"

_TOLD = {BITS: "the hand", CATEGORY: "the category", END: "the very end"}


def answer(told: pa.Table, rows: Iterable[MeasuredCurves]) -> str:
    """The answer to both questions, a list each.

    Args:
        told: under `ends.TOLD`.
        rows: learners that are told more or less, measured.
    """
    of_learner = groupby(tellings(rows), key=lambda one: (one.jar, one.learner))
    effects = (line for _, group in of_learner for line in _effects(list(group)))
    return "\n\n".join(
        [
            "The category of the grasp tells the end that is held:",
            _listed(_separation(told.to_pylist())),
            "In difficult trials, beside a learner that is told the hand only:",
            _listed(effects),
        ]
    )


def _listed(lines: Iterable[str]) -> str:
    return "\n".join(f"- {line}" for line in lines)


def _separation(rows: Iterable[Mapping[str, Any]]) -> Iterator[str]:
    said: dict[str, list[str]] = {words: [] for words in (*_CLASSES, _UNKNOWN)}
    for row in rows:
        if row["by"] == ends.CATEGORY:
            found = f"{row['jar']}, {row['kind']}, {percent(row)} %"
            said[_class(row["low"])].append(found)
    for words, found in said.items():
        if found:
            yield f"{words}: {'; '.join(found)}"


def _class(low: float) -> str:
    """How well an end is told, by the lower bound of its interval."""
    return next((words for words, least in _CLASSES.items() if low > least), _UNKNOWN)


def _effects(told: list[Telling]) -> Iterator[str]:
    """What each thing more does to a learner, and how far it is as infants then."""
    for one in told:
        late, early = (
            _corrections(one, *measures)
            for measures in ((late_gone, late_most), (early_gone, early_most))
        )
        yield (
            f"*{one.learner}*, {one.jar} jar, told {_TOLD[one.touch]}: late "
            f"corrections are {late}; early ones are {early}"
        )
    shown = [told[0].usual, *(one.told for one in told)]
    verdicts = (f"{_TOLD[one.row.touch]}, {develops(one.measured)}" for one in shown)
    yield (
        f"*{told[0].learner}*, {told[0].jar} jar, as infants by all criteria: "
        f"{'; '.join(verdicts)}"
    )


def _corrections(telling: Telling, gone: Measure, most: Measure) -> str:
    """What becomes of one kind of corrections."""
    when = telling.compared(gone)
    if not when.there:
        return when.brief
    return f"{when.brief}, and {telling.compared(most).brief}"
