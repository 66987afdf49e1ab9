"""What is claimed of rivals on the same task, and whether it holds."""

from collections.abc import Iterator, Mapping
from itertools import groupby, product
from typing import Any

from prospect_mj.agent.failed_actions import RULES
from prospect_mj.experiment.development.claims.claim import Claim
from prospect_mj.experiment.development.claims.criteria import all_of
from prospect_mj.experiment.development.figures.rivals import NAMES
from prospect_mj.experiment.development.rivals.planner.model_errors import LID, WIDTH
from prospect_mj.experiment.development.rivals.rivals import RivalResults
from prospect_mj.experiment.development.rivals.settings import (
    DEEP,
    LINEAR,
    LINEAR_MASKED,
    MASKED,
)
from prospect_mj.experiment.estimate import Estimate, share
from prospect_mj.experiment.paper.measures.bootstrap import Interval
from prospect_mj.experiment.paper.measures.quantity import Kind, with_interval
from prospect_mj.experiment.paper.measures.target import Target, Verdict

BROKEN = 0.10
"""Share of the trials above which a plan counts as broken [1]."""

_MEASURES = {"smoothed": "smoothed", "single_run": "single runs"}

Line = Mapping[str, Any]


def rival_claims(results: RivalResults) -> list[Claim]:
    """All of them."""
    return [*_learning(results), *_planning(results)]


def _learning(results: RivalResults) -> Iterator[Claim]:
    rows = {row["agent"]: row for row in results.learning.to_pylist()}
    for deep in DEEP:
        linear = LINEAR_MASKED if deep in MASKED else LINEAR
        if deep in rows and linear in rows:
            yield _fewer(rows[linear], rows[deep])


def _fewer(linear: Line, deep: Line) -> Claim:
    """Of fewer trials by both measures."""
    verdicts, told = [], []
    for measure, title in _MEASURES.items():
        found = [_trials(row, measure) for row in (linear, deep)]
        verdicts.append(_less(*found))
        numbers = (
            f"*{NAMES[row['agent']]}* {with_interval(one, Kind.TRIAL)}"
            for row, one in zip((linear, deep), found, strict=True)
        )
        told.append(f"{title}: {', '.join(numbers)}")
    return Claim(
        "The paper's linear learner needs fewer trials until near-optimal than a deep "
        "one with the same choices that was not tuned, failed actions being allowed.",
        all_of(verdicts),
        f"trials, {'; '.join(told)}",
        f"beside {NAMES[deep['agent']]}",
    )


def _trials(row: Line, measure: str) -> Interval:
    return Interval(row[measure], row[f"{measure}_low"], row[f"{measure}_high"])


def _less(its: Interval, other: Interval) -> Verdict:
    if its.high < other.low:
        return Verdict.HOLDS
    return Verdict.FAILS if other.high < its.low else Verdict.OPEN


def _planning(results: RivalResults) -> Iterator[Claim]:
    rows = results.errors.to_pylist()
    for kind, rule in product((WIDTH, LID), RULES):
        of_kind = [
            row for row in rows if row["kind"] == kind and row["failed_actions"] == rule
        ]
        if of_kind:
            yield _breaks(of_kind, f"{kind}, failed actions {rule}")


def _breaks(rows: list[Line], of: str) -> Claim:
    """By one of the errors in a size at least."""
    found = {row["error"]: _unsolved(row) for row in rows}
    said = {_broken(one) for error, one in found.items() if error}
    if Verdict.HOLDS in said:
        verdict = Verdict.HOLDS
    else:
        verdict = Verdict.OPEN if Verdict.OPEN in said else Verdict.FAILS
    return Claim(
        f"Backward chaining leaves more than {100 * BROKEN:.0f} % of the trials "
        f"unsolved where a size that it believes is at most {max(found):g} mm wrong.",
        verdict,
        f"unsolved {'; '.join(_by_share(found))}",
        of,
    )


def _unsolved(row: Line) -> Estimate:
    return share(round(row["failures"] * row["trials"]), row["trials"])


def _broken(found: Estimate) -> Verdict:
    interval = Interval(found.estimate, found.low, found.high)
    return Target(BROKEN, 1.0).verdict(interval)


def _by_share(found: Mapping[float, Estimate]) -> Iterator[str]:
    """Shares with the errors from which to which they are the same."""
    shares = groupby(sorted(found), key=lambda error: found[error].words(0, 100))
    for words, errors in shares:
        first, *others = errors
        last = f" to {others[-1]:+g}" if others else ""
        yield f"{words} % at {first:+g}{last} mm"
