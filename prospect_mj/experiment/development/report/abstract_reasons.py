"""Why recorded numbers differ from those of the abstract task.

Told by rows with a thing of the abstract task (`study.abstract_rows`): which of them
brings a number to the abstract one.
"""

from collections.abc import Iterator, Mapping
from typing import NamedTuple

from prospect_mj.agent.learners import DEFAULTS
from prospect_mj.experiment.development.report.abstract_numbers import (
    ABSTRACT,
    COMPARED,
    Compared,
    Key,
)
from prospect_mj.experiment.development.report.command import command
from prospect_mj.experiment.development.study import abstract_rows
from prospect_mj.experiment.development.study.abstract_rows import (
    BOTH,
    CHANGES,
    NOTHING,
    PICTURES,
    Change,
)
from prospect_mj.experiment.development.study.ideal_outcomes import IdealOutcomes
from prospect_mj.experiment.development.study.measured import Measured
from prospect_mj.experiment.development.study.results import Results
from prospect_mj.experiment.paper.report.markdown import table

_OUTCOMES = """\
The outcomes: of {recorded} in the recording {unlike} differ from the abstract task's in
who holds the jar, or in whether it is inserted{so}.
"""

_ASKED = """\
Pictures and features: the four learners on recorded outcomes with a thing of the
abstract task, {runs} runs a row. *Made-up pictures*: two prototypes with the cosine and
the noise that the abstract task had for this learner. *The other reading*: linear
features that have the histogram itself only where no hand holds the jar (`one_hot`);
which reading the abstract task had is not told. **Bold**: with this the number differs
no more from the abstract one, and lies beyond the recorded interval. *-*: the learner
does not know of it.
"""

_ALL = """\
A reason why one number differs should leave those alone that agree. Numbers that differ
from the abstract ones, of {n} for each learner:
"""

_COMES = "it comes to the abstract number"


class _Rows(NamedTuple):
    """Rows with changes and without."""

    by_key: Mapping[tuple[str, str, str], Measured]

    @classmethod
    def of(cls, results: Results) -> "_Rows":
        """Those of the part learners."""
        rows = [*(one.measured for one in results.learners), *results.towards_abstract]
        return cls({(one.row.name, one.row.rule, one.row.world): one for one in rows})

    @property
    def asked(self) -> list[Key]:
        """Rows without changes that have an abstract one, of who knows of a change."""
        kept = {(name, rule) for name, rule, _ in self.by_key}
        return [key for key in ABSTRACT if key in kept and key[0] in PICTURES]

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
    yield _outcomes(results.outcomes)
    yield _ASKED.format(runs=results.settings.fewer_runs).rstrip()
    yield _table(rows, differing)
    left = _left(results.outcomes)
    yield "\n".join(
        f"- *{each.title}* of *{', '.join(key)}*: {_because(rows, each, key, left)}."
        for each, key in differing
    )
    yield _ALL.format(n=len(COMPARED)).rstrip()
    yield _counts(rows)
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


def _because(rows: _Rows, each: Compared, key: Key, left: str) -> str:
    """Which change is the reason, in words."""
    if key[0] not in DEFAULTS:
        return "not asked, as it is a control"
    known = [name for name, one in CHANGES.items() if one.known_to(key[0]) == one]
    if not known:
        return f"the learner knows neither of pictures nor of features; {left}"
    before = rows.find(key, NOTHING)
    brings = [
        name
        for name in known
        if each.brought(key, before, rows.find(key, CHANGES[name]))
    ]
    if not brings:
        return f"with none of these {_COMES}; {left}"
    alone = [name for name in brings if name != BOTH] or brings
    without = ", though not with both" if BOTH in set(known) - set(brings) else ""
    upset = "".join(_upset(rows, name) for name in alone)
    return f"with {' or with '.join(alone)} {_COMES}{without}{upset}"


def _upset(rows: _Rows, name: str) -> str:
    """Which learners a change takes away from the abstract numbers, in words."""
    change = CHANGES[name]
    others = [
        f"*{', '.join(key)}*"
        for key in rows.asked
        if any(
            each.differs(key, rows.find(key, change))
            and not each.differs(key, rows.find(key, NOTHING))
            for each in COMPARED
        )
    ]
    if not others:
        return ""
    return (
        f"; against {name} speaks that numbers of {' and '.join(others)} then differ "
        "which agree as recorded"
    )


def _outcomes(found: IdealOutcomes) -> str:
    so = "" if found.unlike else ", so that they are no reason"
    unlike = found.unlike or "none"
    return _OUTCOMES.format(recorded=found.recorded, unlike=unlike, so=so).rstrip()


def _left(found: IdealOutcomes) -> str:
    outcomes = "the outcomes, and " if found.unlike else ""
    return f"what is left is {outcomes}what of the abstract task is not told"


def _counts(rows: _Rows) -> str:
    changes = {"recorded": NOTHING, **CHANGES}
    lines = [
        (*key, *(str(_differing(rows, key, one)) for one in changes.values()))
        for key in rows.asked
    ]
    return table(("learner", "rule", *changes), lines)


def _differing(rows: _Rows, key: Key, change: Change) -> int:
    one = rows.find(key, change)
    return sum(each.differs(key, one) for each in COMPARED)
