"""What the study of haptic categories comes to, in Markdown."""

from collections.abc import Iterator, Mapping
from typing import Any

import pyarrow.compute as pc

from prospect_mj.experiment.development.claims.criteria import develops
from prospect_mj.experiment.development.haptics import ends
from prospect_mj.experiment.development.haptics.grasp import KINDS
from prospect_mj.experiment.development.haptics.haptics import HapticResults
from prospect_mj.experiment.development.haptics.touch import CATEGORY
from prospect_mj.experiment.development.measures.measures import (
    early_gone,
    early_most,
    late_gone,
    late_most,
    optimal_last,
)
from prospect_mj.experiment.development.report.cells import measured_table
from prospect_mj.experiment.development.report.command import command
from prospect_mj.experiment.development.report.haptics_answer import answer
from prospect_mj.experiment.development.report.haptics_claims import percent
from prospect_mj.experiment.development.study import haptic_rows
from prospect_mj.experiment.development.study.measured import GRASP, INSERTION
from prospect_mj.experiment.development.study.results import Results
from prospect_mj.experiment.development.study.settings import FELT_WORLDS
from prospect_mj.experiment.paper.measures.quantity import Kind, with_interval
from prospect_mj.experiment.paper.report.markdown import table
from prospect_mj.recording.worlds import STANDARD

_MODELS = """\
The paths of the grasp controller through the phase portrait of its residual and the
residual's rate, while all three fingertips touch, were clustered into {models} models,
without a word about what was grasped. {felt}
Ellipses lie at two deviations; dotted: after a correction of the hand.
"""

_TOLD = """\
Which end a hand holds, lid or body, told right [%], on presentations that it was not
learned from. Grasps of one presentation may depend on each other: the 95 % intervals,
Wilson's, are as wide as if each presentation were a single grasp. The *two bits* say
which hand holds the jar, and so nothing of the end. *At first touch*: the category by
the first sample alone. The *closing time* of the fingers is no part of the phase
portrait, and its threshold was learned with the ends told: it shows what the hand's own
posture has to say.
"""

_NUMBERS = """\
Numbers of models, both kinds of grasps together. *Halves*: how far models of two halves
of the presentations agree on all grasps, with its standard error (adjusted Rand index:
1 wholly, 0 as by chance). BIC, the information criterion, would be least at the right
number if grasps were normal densities.
"""

_EFFECT = """\
Learners on the recorded outcomes, told of a grasp only the hand (two bits), its
category as well, or the very end, as a category would that never errs. Failed
actions are suppressed, the right hand was made dominant. With categories an insertion
counts as split when it is for one of them.
"""


_BY_NUMBER = """\
How far that hangs on the number of models: the learner that discovers, told the
category, for each number.
"""
_MEASURES = late_gone, early_gone, late_most, early_most, optimal_last


def haptics(results: Results) -> Iterator[str]:
    """The section, a piece at a time."""
    found = results.haptics
    yield "## Haptic categories"
    yield answer(found.told, results.touches)
    n_models = len(found.models[STANDARD])
    yield _MODELS.format(models=n_models, felt=_felt(found)).rstrip()
    yield "![Phase portraits of grasps](figures/haptics_portraits.png)"
    yield "### What they tell that two bits can't"
    yield _TOLD.rstrip()
    yield "![Which end is held, told right](figures/haptics_separation.png)"
    yield _told(found)
    yield _NUMBERS.rstrip()
    yield _numbers(found)
    yield "### What they do to late and early corrections"
    yield _EFFECT.rstrip()
    for world in dict.fromkeys(one.row.world for one in results.touches):
        picture = f"figures/haptics_strategies_{world}.png"
        yield f"![Strategies of those told more, {world} jar]({picture})"
    yield _effect(results)
    yield _BY_NUMBER.rstrip()
    yield _by_number(results)
    yield command(results, "haptics")


def _felt(found: HapticResults) -> str:
    """Where the grasps are from."""
    live = [jar for jar in found.grasps if jar not in FELT_WORLDS]
    made = f"; live ones: {', '.join(live)}" if live else ""
    return f"Grasps are those of the recordings{made}."


def _told(found: HapticResults) -> str:
    rows: dict[tuple[str, str], dict[str, str]] = {}
    for row in found.told.to_pylist():
        cells = rows.setdefault((row["jar"], row["kind"]), {})
        cells |= {name: str(row[name]) for name in ("presentations", "grasps")}
        cells[row["by"]] = percent(row)
    names = "presentations", "grasps", *ends.BY
    lines = [(*key, *(cells[name] for name in names)) for key, cells in rows.items()]
    order = {kind: place for place, kind in enumerate(KINDS)}
    lines.sort(key=lambda line: order[line[1]])
    return table(("jar", "grasp", *names), lines)


def _numbers(found: HapticResults) -> str:
    jars = pc.unique(found.numbers["jar"]).to_pylist()
    cells: dict[int, list[str]] = {}
    for row in found.numbers.to_pylist():
        halves = f"{row['agreement']:.2f} ± {row['agreement_error']:.2f}"
        words = f"{percent(row)}; {halves}; {row['bic']:.0f}"
        cells.setdefault(row["models"], []).append(words)
    head = "models", *(f"{jar}: told right [%]; halves; BIC" for jar in jars)
    return table(head, [(str(n), *words) for n, words in cells.items()])


def _effect(results: Results) -> str:
    head = "jar", "learner", "told", "as infants", "insertion split", "grasp split"
    rows = [
        (
            (
                one.row.world,
                one.row.name,
                one.row.touch,
                develops(one.measured),
                *(_split(one.measured.measured, name) for name in (INSERTION, GRASP)),
            ),
            one.measured,
        )
        for one in results.touches
    ]
    return measured_table(head, rows)


def _by_number(results: Results) -> str:
    usual = (one for one in results.touches if one.row.touch == CATEGORY)
    shown = [one for one in usual if one.row.name == haptic_rows.COUNTING]
    worlds = [one.row.world for one in shown]
    shown += results.by_number
    shown.sort(key=lambda o: (worlds.index(o.row.world), o.row.settings.categories))
    rows = [
        (
            (
                one.row.world,
                str(one.row.settings.categories),
                develops(one.measured),
            ),
            one.measured,
        )
        for one in shown
    ]
    return measured_table(("jar", "models", "as infants"), rows, _MEASURES)


def _split(found: Mapping[str, Any], name: str) -> str:
    return with_interval(found[name], Kind.TRIAL) if name in found else "-"
