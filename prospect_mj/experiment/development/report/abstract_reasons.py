"""Why recorded numbers differ from those of the abstract task.

Told by rows with a thing of the abstract task (`study.abstract_rows`): which of them
brings a number to the abstract one.
"""

from collections.abc import Iterator, Mapping
from typing import NamedTuple

from prospect_mj.experiment.development.report.abstract_numbers import (
    COMPARED,
    Compared,
    Key,
)
from prospect_mj.experiment.development.report.command import command
from prospect_mj.experiment.development.study import abstract_rows, learners
from prospect_mj.experiment.development.study.abstract_rows import (
    BOTH,
    CHANGES,
    NOTHING,
    Change,
)
from prospect_mj.experiment.development.study.measured import Measured
from prospect_mj.experiment.development.study.results import Results
from prospect_mj.experiment.paper.report.markdown import table

_ASKED = """\
The four learners on the recorded task with a thing of the abstract one, {runs} runs a
row. *Made-up pictures*: two prototypes with the cosine and the noise that the abstract
task had for this learner, on recorded outcomes. *The other reading*: linear features
that have the histogram itself only where no hand holds the jar (`one_hot`); the
abstract task's description leaves its reading open. **Bold**: the change brings the
number to the abstract one, so that it differs no more and lies beyond the recorded
interval. *-*: the learner does not know of it.
"""

_ALL = """\
A reason why one number differs should leave the others as they are. Numbers that differ
from the abstract ones, of {n} for each learner:
"""

_COMES = "it comes to the abstract number"
_LEFT = "what is left are the outcomes, and what of the abstract task is not told"


class _Rows(NamedTuple):
    """Rows with changes and without."""

    by_key: Mapping[tuple[str, str, str], Measured]

    @classmethod
    def of(cls, results: Results) -> "_Rows":
        """Those of the part learners."""
        rows = [*(one.measured for one in results.learners), *results.towards_abstract]
        return cls({(one.row.name, one.row.rule, one.row.world): one for one in rows})

    def find(self, key: Key, change: Change) -> Measured:
        """The row of a learner with what it knows of a change."""
        known = change.known_to(key[0])
        return self.by_key[abstract_rows.key(*key, known)]


def reasons(results: Results, compared: Mapping[Key, Measured]) -> Iterator[str]:
    """The section, a piece at a time.

    Args:
        results: of the study.
        compared: recorded rows that have an abstract one.
    """
    differing = [
        (each, key)
        for key, one in compared.items()
        for each in COMPARED
        if each.differs(key, one)
    ]
    if not differing:
        yield "No number differs."
        return
    rows = _Rows.of(results)
    yield "### Why they differ"
    yield _ASKED.format(runs=results.settings.fewer_runs).rstrip()
    yield _table(rows, differing)
    yield "\n".join(f"- {_reason(rows, each, key)}" for each, key in differing)
    yield _ALL.format(n=len(COMPARED)).rstrip()
    yield _counts(rows, compared)
    yield command(results, "learners")


def _table(rows: _Rows, differing: list[tuple[Compared, Key]]) -> str:
    head = ("number", "learner", "rule", "abstract", "recorded", *CHANGES)
    return table(head, [_line(rows, each, key) for each, key in differing])


def _line(rows: _Rows, each: Compared, key: Key) -> tuple[str, ...]:
    cells = [_cell(rows, each, key, change) for change in CHANGES.values()]
    recorded = each.found_words(rows.find(key, NOTHING))
    return each.title, *key, each.said_words(key), recorded, *cells


def _cell(rows: _Rows, each: Compared, key: Key, change: Change) -> str:
    if change.known_to(key[0]) == NOTHING:
        return "-"
    after = rows.find(key, change)
    words = each.found_words(after)
    brought = each.brought(key, rows.find(key, NOTHING), after)
    return f"**{words}**" if brought else words


def _reason(rows: _Rows, each: Compared, key: Key) -> str:
    return f"*{each.title}* of *{', '.join(key)}*: {_because(rows, each, key)}."


def _because(rows: _Rows, each: Compared, key: Key) -> str:
    """Which change is the reason, in words."""
    if key[0] not in learners.LEARNERS:
        return "not asked, as it is a control"
    known = [
        name for name, change in CHANGES.items() if change.known_to(key[0]) == change
    ]
    if not known:
        return f"the learner knows neither of pictures nor of features; {_LEFT}"
    before = rows.find(key, NOTHING)
    brings = [
        name
        for name in known
        if each.brought(key, before, rows.find(key, CHANGES[name]))
    ]
    if not brings:
        return f"none of these changes brings it to the abstract number; {_LEFT}"
    alone = [name for name in brings if name != BOTH]
    if not alone:
        return f"with both changes {_COMES}, with neither alone"
    without = ", though not with both" if BOTH in set(known) - set(brings) else ""
    return f"with {' or with '.join(alone)} {_COMES}{without}"


def _counts(rows: _Rows, compared: Mapping[Key, Measured]) -> str:
    keys = [key for key in compared if key[0] in abstract_rows.LOOKS]
    changes = {"recorded": NOTHING, **CHANGES}
    lines = [
        (*key, *(str(_differing(rows, key, one)) for one in changes.values()))
        for key in keys
    ]
    return table(("learner", "rule", *changes), lines)


def _differing(rows: _Rows, key: Key, change: Change) -> int:
    one = rows.find(key, change)
    return sum(each.differs(key, one) for each in COMPARED)
