"""What the study of haptic categories comes to, in Markdown."""

from collections.abc import Iterator
from typing import Any

import pyarrow.compute as pc

from prospect_mj.experiment.development.haptics import effect, ends
from prospect_mj.experiment.development.haptics.answer import answer
from prospect_mj.experiment.development.haptics.grasp import KINDS
from prospect_mj.experiment.development.haptics.haptics import RECORDED, HapticResults
from prospect_mj.experiment.development.measures.measures import MEASURES
from prospect_mj.experiment.estimate import Estimate
from prospect_mj.experiment.paper.measures.bootstrap import Interval
from prospect_mj.experiment.paper.measures.quantity import Kind, number, with_interval
from prospect_mj.experiment.paper.report.markdown import table

PORTRAITS, SEPARATION, STRATEGIES = (
    "figures/haptics_portraits.png",
    "figures/haptics_separation.png",
    "figures/haptics_strategies.png",
)
"""The pictures, beside the report."""

_MODELS = """\
The paths of the grasp controller through the phase portrait of its residual and the
residual's rate, while all three fingertips touch, were clustered into {models} models,
without a word about what was grasped. Ellipses lie at two deviations; dotted: after a
correction of the hand.
"""

_TOLD = """\
Which end a hand holds, lid or body, told right [%], with Wilson's intervals, on
presentations that it was not learned from. The *two bits* say which hand holds the jar,
and so nothing of the end. *At first touch*: the category by the first sample alone. The
*closing time* of the fingers is no part of the phase portrait, and its threshold was
learned with the ends told: it shows what the hand's own posture has to say.
"""

_EFFECT = """\
Learners on the recorded outcomes, told of a grasp only the hand (two bits), its
category as well, or, as a bound on what any category could do, the very end. Failed
actions are suppressed, the right hand was made dominant; {runs} runs each. *Order*:
share of the resamples in which late corrections are gone before early ones.
"""


def section(results: HapticResults) -> str:
    """The section of the study's report.

    Args:
        results: what came out.
    """
    parts = [
        "## Haptic categories",
        answer(results.told, results.effect.measures),
        _MODELS.format(models=len(results.models[RECORDED])).rstrip(),
        f"![Phase portraits of grasps]({PORTRAITS})",
        "### What they tell that two bits can't",
        _TOLD.rstrip(),
        f"![Which end is held, told right]({SEPARATION})",
        _told(results),
        "Other numbers of models, both kinds of grasps together:",
        _numbers(results),
        "### What they do to late and early corrections",
        _EFFECT.format(runs=results.settings.runs).rstrip(),
        f"![Strategies with and without categories]({STRATEGIES})",
        _effect(results),
    ]
    return "\n\n".join(parts) + "\n"


def _told(results: HapticResults) -> str:
    rows: dict[tuple[str, str], dict[str, str]] = {}
    for row in results.told.to_pylist():
        cells = rows.setdefault((row["jar"], row["kind"]), {})
        cells["grasps"] = str(row["grasps"])
        cells[row["by"]] = _percent(row)
    names = "grasps", *ends.BY
    lines = [(*key, *(cells[name] for name in names)) for key, cells in rows.items()]
    order = {kind: place for place, kind in enumerate(KINDS)}
    lines.sort(key=lambda line: order[line[1]])
    return table(("jar", "grasp", *names), lines)


def _numbers(results: HapticResults) -> str:
    rows = results.numbers.to_pylist()
    jars = pc.unique(results.numbers["jar"]).to_pylist()
    cells: dict[int, list[str]] = {}
    for row in rows:
        words = f"{_percent(row)}; {row['bic']:.0f}"
        cells.setdefault(row["models"], []).append(words)
    head = "models", *(f"{jar}: told right [%]; BIC" for jar in jars)
    return table(head, [(str(n), *words) for n, words in cells.items()])


def _effect(results: HapticResults) -> str:
    found: dict[tuple[str, str], dict[str, Any]] = {}
    for row in results.effect.measures.to_pylist():
        key = row["learner"], row["told"]
        found.setdefault(key, {})[row["measure"]] = row
    lines = [
        (learner, told, *_measured(found[learner, told]))
        for learner in effect.LEARNERS
        for told in effect.TOLD
    ]
    titles = (measure.title for measure in MEASURES)
    return table(("learner", "told", *titles, "Order"), lines)


def _measured(rows: dict[str, Any]) -> Iterator[str]:
    for measure in MEASURES:
        row = rows[measure.name]
        parts = (row[name] for name in Interval._fields)
        yield with_interval(Interval(*parts), measure.kind)
    yield number(rows[effect.ORDER]["estimate"], Kind.SHARE)


def _percent(row: dict[str, float]) -> str:
    return Estimate(row["told"], row["low"], row["high"]).words(0, scale=100)
