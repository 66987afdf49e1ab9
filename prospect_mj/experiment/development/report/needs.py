"""What the order of the stages needs, by the rows with splits made otherwise."""

from collections.abc import Mapping

from prospect_mj.experiment.development.claims.claim import Claim
from prospect_mj.experiment.development.claims.criteria import (
    Figures,
    develops,
)
from prospect_mj.experiment.development.study.causal import SHARED, forced_name
from prospect_mj.experiment.paper.measures.target import Verdict

NEEDS = "needs both"
"""Name of the claim."""
_RATE = 0.005
"""Least rate of the discovery learner as it is."""
_WITH = (("insertion first", "examples"), ("insertion first", "stored"))
_WITHOUT = (
    ("both at once", "examples"),
    ("both at once", "stored"),
    ("grasp first", "examples"),
    ("grasp first", "stored"),
    ("insertion first", "inherit"),
)
"""One of the two is missing."""


def needs(rows: Mapping[str, Figures]) -> Claim:
    """Whether it takes the order of the splits, and re-estimated values.

    Args:
        rows: of the causal part, by name.
    """
    said = {
        kind: develops(rows[forced_name(*kind, _RATE)]) for kind in (*_WITH, *_WITHOUT)
    }
    words = "; ".join(f"{', '.join(kind)}: {said[kind]}" for kind in said)
    return Claim(
        "When contexts are split by force, and values follow as in the learner as it "
        f"is (least rate {_RATE:g}), development as in infants takes both: insertions "
        "split before grasps, and values are re-estimated at the split.",
        _together([said[kind] for kind in _WITH], [said[kind] for kind in _WITHOUT]),
        f"by all criteria together, {words}; {_lent(develops(rows[SHARED]))}",
        "discovery, splits forced",
        NEEDS,
    )


def _together(present: list[Verdict], missing: list[Verdict]) -> Verdict:
    if Verdict.FAILS in present or Verdict.HOLDS in missing:
        return Verdict.FAILS
    clear = set(present) == {Verdict.HOLDS} and set(missing) == {Verdict.FAILS}
    return Verdict.HOLDS if clear else Verdict.OPEN


def _lent(said: Verdict) -> str:
    """What a split of the grasp tells that leaves its values as they are."""
    words = (
        "not by force, and with grasps that keep their values when a feature splits "
        f"them together with insertions (*{SHARED}*): {said}"
    )
    if said is Verdict.HOLDS:
        words += ", so that what must come later are new values of grasps"
    return words
