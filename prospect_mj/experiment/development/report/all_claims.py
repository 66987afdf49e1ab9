"""The claims of all parts that were made."""

from collections.abc import Callable, Mapping
from types import MappingProxyType

from prospect_mj.experiment.development.claims.change import soonest, stages_again
from prospect_mj.experiment.development.claims.claim import CONJECTURED, Claim, Subject
from prospect_mj.experiment.development.claims.claims import between_learners, claims
from prospect_mj.experiment.development.claims.findings import Findings
from prospect_mj.experiment.development.claims.worlds import world_claims
from prospect_mj.experiment.development.report.haptics_claims import haptic_claims
from prospect_mj.experiment.development.report.needs import needs
from prospect_mj.experiment.development.report.rivals_claims import rival_claims
from prospect_mj.experiment.development.study.after import again
from prospect_mj.experiment.development.study.measured import Measured, Told
from prospect_mj.experiment.development.study.results import Results
from prospect_mj.experiment.development.study.settings import Part
from prospect_mj.experiment.development.study.world_rows import SEEING
from prospect_mj.recording.worlds import STANDARD


def all_claims(results: Results) -> dict[Part, list[Claim]]:
    """Those of every part that makes any."""
    found = {part: made(results) for part, made in _CLAIMED.items()}
    return {part: made for part, made in found.items() if made}


def by_row(learners: list[Told]) -> dict[Subject, Findings]:
    """What is claimed of, by learner and rule."""
    return {Subject(one.row.name, one.row.rule): one.findings for one in learners}


def spread(results: Results) -> dict[str, Findings]:
    """Populations of learners that differ, by their learner."""
    return {one.row.name: one.findings for one in results.population}


def _learners(results: Results) -> list[Claim]:
    return claims(by_row(results.learners))


def _causal(results: Results) -> list[Claim]:
    rows = {one.row.name: one for one in results.causal}
    return [needs(rows)] if rows else []


def _population(results: Results) -> list[Claim]:
    found = spread(results)
    equal = {
        row.learner: findings
        for row, findings in by_row(results.learners).items()
        if row.rule == CONJECTURED.rule
    }
    return [between_learners(found, equal)] if CONJECTURED.learner in found else []


def _worlds(results: Results) -> list[Claim]:
    """None of the standard world alone, which is that of all other parts."""
    found: dict[str, dict[str, Measured]] = {}
    for one in results.worlds:
        found.setdefault(one.row.name, {})[one.row.world] = one.measured
    if all(set(worlds) == {STANDARD} for worlds in found.values()):
        return []
    return world_claims(found)


def _change(results: Results) -> list[Claim]:
    return [
        claim
        for change in results.extent.changes
        for claim in _changed(results, change)
    ]


def _changed(results: Results, change: str) -> list[Claim]:
    """Of one change; none if that part was not made."""
    both = zip(results.change, results.formerly_easy, strict=True)
    pairs = [
        (shown.measured, easy)
        for shown, easy in both
        if (shown.row.then, shown.row.rule) == (change, "suppressed")
    ]
    if not pairs:
        return []
    trials = {
        one.row.name: {"formerly difficult": one, "formerly easy": easy}
        for one, easy in pairs
    }
    near_optimal = {one.row.name: one.measured[again.name] for one, _ in pairs}
    return [*stages_again(change, trials), soonest(change, near_optimal, SEEING)]


def _rivals(results: Results) -> list[Claim]:
    return [] if results.rivals is None else rival_claims(results.rivals)


_CLAIMED: Mapping[Part, Callable[[Results], list[Claim]]] = MappingProxyType(
    {
        "learners": _learners,
        "causal": _causal,
        "population": _population,
        "worlds": _worlds,
        "change": _change,
        "haptics": haptic_claims,
        "rivals": _rivals,
    }
)
"""In the order of tables."""
