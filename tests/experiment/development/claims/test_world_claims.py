"""What is claimed of worlds of pictures holds in all of them, or does not."""

from dataclasses import replace

import pytest
import study_by_hand

from prospect_mj.experiment.development.claims.worlds import (
    DEVELOPS_EVERYWHERE,
    ORDER_EVERYWHERE,
    world_claims,
)
from prospect_mj.experiment.paper.measures.bootstrap import Interval
from prospect_mj.experiment.paper.measures.target import Verdict

HOLDS, FAILS, OPEN = Verdict.HOLDS, Verdict.FAILS, Verdict.OPEN


def figures(kind):
    """A population by hand, or one of it that an interval or resamples leave open."""
    found = study_by_hand.findings("infant" if "unsure" in kind else kind)
    wide = {**found.measured, "easy_worst": Interval(0.8, 0.6, 0.9)}
    return {
        "unsure of the order": replace(found, order=0.8),
        "unsure of the easy": replace(found, measured=wide),
    }.get(kind, found)


def found(**learners):
    """Claims of learners that did so in the worlds standard and noisy."""
    return world_claims(
        {
            learner: dict(zip(("standard", "noisy"), map(figures, kinds), strict=True))
            for learner, kinds in learners.items()
        }
    )


@pytest.mark.parametrize(
    ("noisy", "in_order", "as_infants", "decides"),
    [
        ("infant", HOLDS, HOLDS, ""),
        ("at once", FAILS, FAILS, "corrections dominate, 0 (0 to 0) trials"),
        ("late", FAILS, FAILS, "early corrections lead, 0 (0 to 0) trials"),
        ("unsure of the order", OPEN, OPEN, "late gone first, late 60, early 140"),
        ("unsure of the easy", HOLDS, OPEN, "easy trials spared, 80.0 % (60.0 % to 90"),
    ],
)
def test_one_world_decides(noisy, in_order, as_infants, decides):
    order, alike = found(discovery=("infant", noisy))
    assert (order.name, order.verdict) == (ORDER_EVERYWHERE, in_order)
    assert (alike.name, alike.verdict) == (DEVELOPS_EVERYWHERE, as_infants)
    assert order.evidence.startswith("*standard*: late 60, early 140; 100.0 % of the")
    assert alike.evidence.startswith(f"*standard*: holds. *noisy*: {as_infants}")
    assert decides in alike.evidence


def test_what_is_claimed_of_two_is_asked_of_the_others():
    claims = found(
        discovery=("infant",) * 2, linear=("infant", "late"), replay=("late",) * 2
    )
    assert [(one.of, one.verdict) for one in claims] == [
        ("discovery", HOLDS),
        ("replay", FAILS),
    ] * 2
    for discovery, replay in (claims[:2], claims[2:]):
        assert discovery.evidence.endswith(". Asked alike: *linear*, does not hold")
        assert "linear" not in replay.evidence


def test_it_is_not_claimed_of_learners_that_were_not_there():
    assert {one.of for one in found(replay=("infant",) * 2)} == {"replay"}
    assert found(linear=("infant",) * 2) == []
