"""What the report begins and ends with: the answer; the claims and the prediction."""

from collections.abc import Iterable, Iterator, Mapping

from prospect_mj.experiment.development.claims.claim import CONJECTURED, Claim
from prospect_mj.experiment.development.claims.claims import PREDICTION, RESTS_ON
from prospect_mj.experiment.development.claims.findings import Findings
from prospect_mj.experiment.development.measures.measures import other_first
from prospect_mj.experiment.development.report.all_claims import (
    all_claims,
    by_row,
    spread,
)
from prospect_mj.experiment.development.report.answer import answer
from prospect_mj.experiment.development.report.command import command
from prospect_mj.experiment.development.study.results import Results
from prospect_mj.experiment.development.study.settings import Part
from prospect_mj.experiment.estimate import Estimate
from prospect_mj.experiment.paper.measures.bootstrap import Interval
from prospect_mj.experiment.paper.measures.quantity import with_interval
from prospect_mj.experiment.paper.measures.target import Verdict
from prospect_mj.experiment.paper.report.markdown import table

_TITLES = {
    Verdict.HOLDS: "What holds",
    Verdict.FAILS: "What doesn't hold",
    Verdict.OPEN: "What is undecided",
}
_JUDGED = """\
Verdicts are by intervals: what lies in the range that is asked for with all of its
interval holds, what lies outside with all of it does not, all else is undecided. Failed
actions are suppressed where no rule is named. The sections above have the criteria, and
all numbers.
"""


def opening(results: Results) -> str:
    """The answer."""
    rows = by_row(results.learners)
    if not rows:
        return "The part `learners`, from which the answer follows, was left out."
    return answer(rows, _all(all_claims(results)))


def closing(results: Results) -> Iterator[str]:
    """Claims that hold and those that don't, and the prediction, a piece at a time."""
    by_part = all_claims(results)
    found = _all(by_part)
    if found:
        yield "## Claims"
        yield _JUDGED.rstrip()
        yield from claims_tables(found)
        yield command(results, *by_part)
    if results.learners:
        yield "## A prediction"
        yield _prediction(found, spread(results))


def _all(by_part: Mapping[Part, list[Claim]]) -> list[Claim]:
    return [one for claims in by_part.values() for one in claims]


def claims_tables(found: list[Claim]) -> Iterator[str]:
    """A table for each verdict, claims with the same words side by side."""
    for verdict, title in _TITLES.items():
        alike: dict[str, list[Claim]] = {}
        for one in found:
            if one.verdict is verdict:
                alike.setdefault(one.words, []).append(one)
        if alike:
            yield f"### {title}"
            lines = [line for claims in alike.values() for line in _lines(claims)]
            yield table(("claim", "of", "what was measured"), lines)


def _lines(claims: list[Claim]) -> Iterator[tuple[str, str, str]]:
    """Of claims with the same words, which only the first line has."""
    for number, one in enumerate(claims):
        yield "the same" if number else one.words, one.of, one.evidence


def _prediction(found: list[Claim], spread: Mapping[str, Findings]) -> str:
    """It is worth something only as far as the claims hold that it comes from."""
    come = [one for one in found if one.name in RESTS_ON]
    rests = "; ".join(f"*{one.words}* ({one.verdict})" for one in come)
    said = PREDICTION, f"It rests on these claims: {rests}", _apart(spread)
    return "\n\n".join(words for words in said if words)


def _apart(spread: Mapping[str, Findings]) -> str:
    """Whether what comes first tells populations apart, that may keep to it alike."""
    if set(spread) <= {CONJECTURED.learner}:
        return ""
    alone = {name: one.late_alone for name, one in spread.items()}
    others = {name: one.measured[other_first.name] for name, one in spread.items()}
    told = any(map(_is_disjoint, (alone.values(), others.values())))
    late = _each({name: f"{one.words(0, 100)} %" for name, one in alone.items()})
    first = _each(
        {name: with_interval(one, other_first.kind) for name, one in others.items()}
    )
    return (
        f"What learners that differ do at first {'tells' if told else 'does not tell'} "
        "discovery from replay. A phase of late corrections alone have, of all runs, "
        f"{late}. Neither optimal nor corrected are, of the difficult ones of the "
        f"first fifty trials, {first}."
    )


def _is_disjoint(found: Iterable[Interval | Estimate]) -> bool:
    """Whether one interval is above all of another one."""
    bounds = [(one.low, one.high) for one in found]
    return max(low for low, _ in bounds) > min(high for _, high in bounds)


def _each(words: Mapping[str, str]) -> str:
    return "; ".join(f"*{name}*, {said}" for name, said in words.items())
