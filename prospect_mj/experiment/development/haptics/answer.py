"""What the study found, in words that follow from its numbers."""

from collections.abc import Iterable, Iterator
from math import isnan
from typing import Any

import pyarrow as pa

from prospect_mj.experiment.development.haptics import effect, ends
from prospect_mj.experiment.development.measures.measures import (
    early_gone,
    late_gone,
)
from prospect_mj.experiment.paper.measures.bootstrap import Interval
from prospect_mj.experiment.paper.measures.quantity import Kind, with_interval

_CHANCE = 0.5
"""What the two bits come to: a hand holds either end as often."""
_SURE = 0.9


def answer(told: pa.Table, measures: pa.Table) -> str:
    """The answer to both questions, a paragraph each.

    Args:
        told: under `ends.TOLD`.
        measures: under `effect.MEASURED`.
    """
    effects = (_effect(measures.to_pylist(), learner) for learner in effect.LEARNERS)
    return "\n\n".join([_separation(told.to_pylist()), *effects])


def _separation(rows: list[dict[str, Any]]) -> str:
    rows = [row for row in rows if row["by"] == ends.CATEGORY]
    said = {
        "told nearly always": [r for r in rows if r["told"] >= _SURE],
        "told better than by chance, but not surely": [
            r for r in rows if r["told"] < _SURE and r["low"] > _CHANCE
        ],
        "not told better than by chance, as far as so few grasps show": [
            r for r in rows if r["told"] < _SURE and r["low"] <= _CHANCE
        ],
    }
    parts = [f"{words}: {_list(found)}" for words, found in said.items() if found]
    return f"The end that is held, by the category of the grasp, is {'; '.join(parts)}."


def _list(rows: Iterable[dict[str, Any]]) -> str:
    return ", ".join(f"{r['jar']}, {r['kind']} ({100 * r['told']:.0f} %)" for r in rows)


def _effect(rows: list[dict[str, Any]], learner: str) -> str:
    """When corrections are gone for a learner, by what it is told."""
    found = {
        (row["told"], row["measure"]): Interval(*(row[n] for n in Interval._fields))
        for row in rows
        if row["learner"] == learner
    }
    sentences = [
        f"{kind} corrections are {', '.join(_gone(found, measure.name))}"
        for kind, measure in (("late", late_gone), ("early", early_gone))
    ]
    usual, category = (found[t, late_gone.name] for t in (effect.BITS, effect.CATEGORY))
    verdict = _compared(usual, category)
    return f"*{learner.capitalize()}*: {'; '.join(sentences)}. {verdict}"


def _gone(found: dict[tuple[str, str], Interval], measure: str) -> Iterator[str]:
    """When corrections of a kind are gone, for each thing that is told."""
    for told in effect.TOLD:
        when = found[told, measure]
        words = f"gone after {with_interval(when, Kind.TRIAL)} trials"
        if isnan(when.estimate):
            words = "never more than 10 %"
        yield f"{words} with {_TOLD[told]}"


_TOLD = {
    effect.BITS: "the two bits",
    effect.CATEGORY: "the category",
    effect.END: "the very end told",
}


def _compared(usual: Interval, category: Interval) -> str:
    """Whether categories make late corrections go sooner, by whole intervals."""
    if category.high < usual.low:
        return "So late corrections go sooner with categories than without."
    if category.low > usual.high:
        return "So late corrections go later with categories than without."
    return "So whether late corrections go sooner with categories is undecided."
