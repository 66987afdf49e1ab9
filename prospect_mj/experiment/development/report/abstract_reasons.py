"""Why recorded numbers differ from those of the abstract task.

Told by rows with a thing of the abstract task (`study.abstract_rows`): which of them
brings a number to the abstract one.
"""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from prospect_mj.experiment.development.report.abstract_words import (
    found_words,
    told_words,
)
from prospect_mj.experiment.development.report.command import command
from prospect_mj.experiment.development.study.abstract_besides import Beside
from prospect_mj.experiment.development.study.abstract_compared import Compared
from prospect_mj.experiment.development.study.abstract_rows import (
    BOTH,
    CHANGES,
    PICTURES,
)
from prospect_mj.experiment.development.study.ideal_outcomes import IdealOutcomes
from prospect_mj.experiment.development.study.made_up import MadeUp
from prospect_mj.experiment.development.study.results import Results
from prospect_mj.experiment.paper.report.markdown import table

_OUTCOMES = """\
The outcomes: of {recorded} in the recording {unlike} differ from the abstract task's in
who holds the jar, or in whether it is inserted{so}.
"""

_ASKED = """\
Pictures, features and replays: rows on recorded outcomes with a thing of the abstract
task, {runs} runs each. *Made-up pictures*: two prototypes with the cosine and the noise
that the abstract task had for this learner. *The other reading*: linear features that
have the histogram itself only where no hand holds the jar (`one_hot`); which reading
the abstract task had is not told. *Replays that forget*: what is replayed counts all
actions in its target, those too that had failed; whether the abstract task's did is not
told. **Bold**: with this the number differs no more from the abstract one, and lies
beyond the recorded interval. *-*: the row does not know of it.
"""

_ALL = (
    "A reason why one number differs should leave those alone that agree. How many "
    "differ:"
)


class _Number(NamedTuple):
    """One that differs."""

    each: Compared
    of: Beside

    def brings(self, change: str) -> bool:
        """Whether a change of the row brings it to the abstract one."""
        of = self.of
        return self.each.brought(of.told, of.recorded, of.changed[change])

    def nears(self, change: str) -> bool:
        """Whether a change brings it nearer, but not there."""
        of = self.of
        return self.each.nearer(of.told, of.recorded, of.changed[change])


def reasons(results: Results, rows: Sequence[Beside]) -> Iterator[str]:
    """The section, a piece at a time.

    Args:
        results: of the study.
        rows: that have an abstract one.
    """
    differing = [_Number(each, one) for one in rows for each in one.differing()]
    if not differing:
        yield "No number differs."
        return
    yield "### Why they differ"
    yield _settled(differing)
    if results.outcomes is not None:
        yield _outcomes(results.outcomes)
    yield _ASKED.format(runs=results.settings.fewer_runs).rstrip()
    yield table(
        ("number", "row", "abstract", "recorded", *CHANGES), map(_line, differing)
    )
    yield _grouped(rows, differing)
    yield _ALL
    yield _counts(rows)
    yield command(results, "learners", "causal", "population")


def _settled(differing: Sequence[_Number]) -> str:
    settled = sum(any(map(one.brings, one.of.changed)) for one in differing)
    return (
        f"Of {len(differing)} numbers that differ, {settled} come to the abstract one "
        "with something that the abstract task had, or may have had; what is left is "
        "not settled, as the code of the abstract task is gone."
    )


def _line(number: _Number) -> tuple[str, ...]:
    each, of = number
    recorded = told_words(each, of.told), found_words(each, of.recorded)
    return each.title, of.title, *recorded, *(_cell(number, name) for name in CHANGES)


def _cell(number: _Number, change: str) -> str:
    if change not in number.of.changed:
        return "-"
    words = found_words(number.each, number.of.changed[change])
    return f"**{words}**" if number.brings(change) else words


def _grouped(rows: Sequence[Beside], differing: Sequence[_Number]) -> str:
    """Numbers by their reason, in words."""
    by_reason: dict[str, list[str]] = {}
    for one in differing:
        title = f"*{one.each.title}* of *{one.of.title}*"
        by_reason.setdefault(_because(rows, one), []).append(title)
    return "\n".join(
        f"- {reason}: {'; '.join(titles)}." for reason, titles in by_reason.items()
    )


def _because(rows: Sequence[Beside], number: _Number) -> str:
    """Which change is the reason, in words."""
    known = number.of.changed
    if not known:
        return "Not settled, as the row knows of no change"
    brings = [name for name in known if number.brings(name)]
    if brings:
        alone = [name for name in brings if name != BOTH] or brings
        half = BOTH in known and any(not CHANGES[name].forgets for name in brings)
        without = ", though not with both" if half and BOTH not in brings else ""
        upset = "".join(_upset(rows, number.of, name) for name in alone)
        return f"It comes with {' or with '.join(alone)}{without}{upset}"
    near = [name for name in known if number.nears(name)]
    if near:
        return f"Not settled, nearer with {' or with '.join(near)}"
    return f"Not settled, not with {' nor with '.join(known)}"


def _upset(rows: Sequence[Beside], of: Beside, name: str) -> str:
    """Which learners with the same change it takes away from the abstract numbers."""
    others = [
        f"*{one.title}*"
        for one in _learners(rows)
        if name in one.changed
        and _pictures(one) == _pictures(of)
        and any(each not in one.differing() for each in one.differing(name))
    ]
    if not others:
        return ""
    return (
        f" (against {name} speaks that numbers of {' and '.join(others)} then differ "
        "which agree as recorded)"
    )


def _outcomes(found: IdealOutcomes) -> str:
    so = "" if found.unlike else ", so that they are no reason"
    unlike = found.unlike or "none"
    return _OUTCOMES.format(recorded=found.recorded, unlike=unlike, so=so).rstrip()


def _counts(rows: Sequence[Beside]) -> str:
    lines = [(one.title, *_differing([one])) for one in _learners(rows) if one.changed]
    causal = [one for one in rows if one.row.part == "causal"]
    if causal:
        lines.append((f"{len(causal)} causal rows together", *_differing(causal)))
    return table(("row", "recorded", *CHANGES), lines)


def _differing(rows: Sequence[Beside]) -> Iterator[str]:
    """How many numbers of some rows differ, as recorded and with each change."""
    yield str(sum(len(one.differing()) for one in rows))
    for name in CHANGES:
        known = [one for one in rows if name in one.changed]
        yield str(sum(len(one.differing(name)) for one in known)) if known else "-"


def _pictures(one: Beside) -> MadeUp | None:
    """What a row's made-up pictures are, which learners share or not."""
    return PICTURES.get(one.row.settings.learner.name)


def _learners(rows: Sequence[Beside]) -> list[Beside]:
    return [one for one in rows if one.row.part == "learners"]
