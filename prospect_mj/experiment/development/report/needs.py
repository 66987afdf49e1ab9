"""What the order of the stages needs, by the rows with forced splits."""

from collections.abc import Mapping

from prospect_mj.experiment.development.claims.claim import Claim
from prospect_mj.experiment.development.claims.criteria import (
    Figures,
    develops,
)
from prospect_mj.experiment.development.study.causal import forced_name
from prospect_mj.experiment.paper.measures.target import Verdict

NEEDS = "needs both"
"""Name of the claim."""
_RATE = 0.005
"""Least rate of the discovery learner as it is."""
_WITH = "insertion first", "examples"
_WITHOUT = (
    ("both at once", "examples"),
    ("grasp first", "examples"),
    ("insertion first", "inherit"),
)
"""One of the two is missing."""


def needs(rows: Mapping[str, Figures]) -> Claim:
    """Whether it takes the order of the splits, and re-estimated values.

    Args:
        rows: of the causal part, by name.
    """
    names = {kind: forced_name(*kind, _RATE) for kind in (_WITH, *_WITHOUT)}
    said = {kind: develops(rows[name]) for kind, name in names.items()}
    words = "; ".join(f"{', '.join(kind)}: {said[kind]}" for kind in said)
    return Claim(
        "When contexts are split by force, development as in infants takes both: "
        "insertions split before grasps, and values are re-estimated at the split.",
        _together(said[_WITH], [said[kind] for kind in _WITHOUT]),
        f"by all criteria together, {words}",
        "discovery, splits forced",
        NEEDS,
    )


def _together(present: Verdict, missing: list[Verdict]) -> Verdict:
    if present is Verdict.FAILS or Verdict.HOLDS in missing:
        return Verdict.FAILS
    clear = present is Verdict.HOLDS and set(missing) == {Verdict.FAILS}
    return Verdict.HOLDS if clear else Verdict.OPEN
