"""What is claimed of haptic categories, and whether it holds."""

from collections.abc import Iterator, Mapping
from types import MappingProxyType
from typing import Any

import pyarrow as pa
import pyarrow.compute as pc

from prospect_mj.experiment.development.claims.claim import Claim
from prospect_mj.experiment.development.claims.criteria import all_of
from prospect_mj.experiment.development.haptics import ends
from prospect_mj.experiment.development.haptics.touch import CATEGORY, END, Touch
from prospect_mj.experiment.development.measures.measures import (
    early_gone,
    late_gone,
    late_most,
)
from prospect_mj.experiment.development.report.haptics_compared import (
    Telling,
    tellings,
)
from prospect_mj.experiment.development.study.results import Results
from prospect_mj.experiment.estimate import Estimate
from prospect_mj.experiment.paper.measures.bootstrap import Interval
from prospect_mj.experiment.paper.measures.measure import Measure
from prospect_mj.experiment.paper.measures.target import Target, Verdict

CHANCE = 0.5
"""What the two bits come to [1]: a hand holds either end as often."""

_EFFECTS: Mapping[Touch, tuple[str, tuple[Measure, ...]]] = MappingProxyType(
    {
        CATEGORY: (
            "Told the category of each grasp, a learner is through sooner than told "
            "the hand only with its corrections, of each kind that it makes.",
            (late_gone, early_gone),
        ),
        END: (
            "Told the very end that is held, a learner has late corrections that are "
            "rarer, and gone sooner, than told the hand only.",
            (late_most, late_gone),
        ),
    }
)
"""The words of the claim, and what must be less for it to hold."""


def haptic_claims(results: Results) -> list[Claim]:
    """All of them, of the parts that were made."""
    found = [] if results.haptics is None else separations(results.haptics.told)
    return [*found, *map(_effect, tellings(results.touches))]


def separations(told: pa.Table) -> list[Claim]:
    """Whether the category tells the end better than the two bits can, by jar.

    Args:
        told: under `ends.TOLD`.
    """
    jars = pc.unique(told["jar"]).to_pylist()
    return [_separation(jar, told.filter(pc.field("jar") == jar)) for jar in jars]


def _separation(jar: str, told: pa.Table) -> Claim:
    rows = told.to_pylist()
    by_category = [row for row in rows if row["by"] == ends.CATEGORY]
    return Claim(
        "The category of a grasp tells better than the two bits can which end of the "
        "jar is held, out of the cradle and in hand-overs.",
        all_of([_better(row) for row in by_category]),
        "; ".join(_evidence(rows)),
        f"jar: {jar}",
    )


def _better(row: Mapping[str, Any]) -> Verdict:
    """Whether the end is told better than by chance."""
    return Target(CHANCE, 1.0).verdict(Interval(row["told"], row["low"], row["high"]))


def _evidence(rows: list[dict[str, Any]]) -> Iterator[str]:
    by_bits = {row["kind"]: row["told"] for row in rows if row["by"] == ends.BITS}
    for row in rows:
        if row["by"] == ends.CATEGORY:
            kind, bits = row["kind"], 100 * by_bits[row["kind"]]
            yield f"{kind} {percent(row)} % told right, by the two bits {bits:.0f} %"


def percent(row: Mapping[str, Any]) -> str:
    """How often the end is told right [%], with its interval."""
    return Estimate(row["told"], row["low"], row["high"]).words(0, scale=100)


def _effect(telling: Telling) -> Claim:
    words, measures = _EFFECTS[telling.touch]
    compared = [telling.compared(measure) for measure in measures]
    there = [one.less for one in compared if one.there]
    evidence = (f"{one.kind} ones are {one.words}" for one in compared)
    return Claim(
        words,
        all_of(there) if there else Verdict.OPEN,
        "; ".join(evidence),
        f"{telling.learner}, jar: {telling.jar}",
    )
