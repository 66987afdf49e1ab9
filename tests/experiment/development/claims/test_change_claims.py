"""What is claimed of a world that changes follows from the trials after the change."""

from math import inf

import pytest
import study_by_hand

from prospect_mj.experiment.development.claims.change import (
    before,
    soonest,
    stages_again,
)
from prospect_mj.experiment.paper.measures.bootstrap import Interval
from prospect_mj.experiment.paper.measures.target import Verdict

HOLDS, FAILS, OPEN = Verdict.HOLDS, Verdict.FAILS, Verdict.OPEN
SEEING = "discovery", "linear", "replay"
EARLY, MIDDLE, LATE = (
    Interval(90, 80, 100),
    Interval(130, 90, 200),
    Interval(250, 220, inf),
)
"""The middle one overlaps with the early one only."""
AT_ONCE = Interval(0, 0, 0)


def trials(difficult, easy):
    kinds = {"formerly difficult": difficult, "formerly easy": easy}
    return {name: study_by_hand.findings(kind) for name, kind in kinds.items()}


@pytest.mark.parametrize(
    ("difficult", "easy", "verdict"),
    [
        ("infant", "infant", HOLDS),
        ("infant", "late", FAILS),
        ("at once", "infant", FAILS),
    ],
)
def test_stages_come_again_in_trials_of_both_kinds(difficult, easy, verdict):
    (claim,) = stages_again("post", {"discovery": trials(difficult, easy)})
    assert (claim.verdict, claim.of) == (verdict, "discovery")
    assert "right one to hold (*post*)" in claim.words
    for kind, did in (("formerly difficult", difficult), ("formerly easy", easy)):
        said = "holds;" if did == "infant" else "does not hold ("
        assert f"*{kind}* trials: {said}" in claim.evidence


def test_easy_trials_need_not_be_spared_where_they_are_reversed_too():
    found = study_by_hand.findings("infant")
    measured = {**found.measured, "easy_worst": Interval(0.0, 0.0, 0.0)}
    reversed_ = study_by_hand.Measured(None, 4, measured, found.order)
    (claim,) = stages_again("post", {"replay": {"formerly difficult": reversed_}})
    assert claim.verdict is HOLDS


def test_what_came_before_the_stages_is_told():
    (claim,) = stages_again("post", {"discovery": trials("at once", "infant")})
    assert "in the first fifty trials 20.0 % (20.0 % to 20.0 %) were" in claim.evidence


def test_the_others_are_asked_the_same():
    learners = {name: trials("infant", "infant") for name in ("discovery", "replay")}
    learners |= {"table": trials("infant", "late")}
    discovery, replay = stages_again("lamp-right", learners)
    assert discovery.evidence.endswith(". Asked alike: *table*, does not hold")
    assert replay.verdict is HOLDS
    assert "table" not in replay.evidence


@pytest.mark.parametrize(
    ("discovery", "replay", "verdict"),
    [
        (EARLY, LATE, HOLDS),
        (LATE, EARLY, FAILS),
        (EARLY, MIDDLE, OPEN),
        (MIDDLE, EARLY, OPEN),
        (Interval(inf, 240, inf), LATE, OPEN),
        (Interval(inf, inf, inf), LATE, OPEN),
        (Interval(inf, inf, inf), MIDDLE, FAILS),
    ],
)
def test_the_soonest_is_so_by_whole_intervals(discovery, replay, verdict):
    again = {"table": AT_ONCE, "discovery": discovery, "replay": replay, "linear": LATE}
    claim = soonest("post", again, SEEING)
    assert claim.verdict is verdict


def test_who_is_told_the_orientation_is_asked_and_marked():
    again = {"linear": LATE, "discovery": EARLY, "table": AT_ONCE}
    told = soonest("post", again, SEEING).evidence
    assert told.startswith(
        "trials: *table* (is told the orientation) 0 (0 to 0); *disc"
    )
    assert told.endswith("Before all others, by whole intervals: table")
    again["table"] = Interval(95, 85, 105)
    assert soonest("post", again, SEEING).evidence.endswith("intervals: none")


def test_one_that_was_not_made_is_not_waited_for():
    assert before({"discovery": LATE, "linear": EARLY}, "linear", SEEING) is HOLDS
