"""The monitor accepts what the model foresees and raises on all else."""

import pytest
from states import state

from prospect_mj.actions.action import Action, ActionResult
from prospect_mj.errors import UnforeseenEvent
from prospect_mj.supervisor.monitor import Monitor
from prospect_mj.supervisor.predicates import NOTHING_SEEN, PRESENTED

LABELS = {action.label: action for action in Action}


def follow(*steps, begin=PRESENTED):
    """Follow steps such as `grasp-left success Fr-`."""
    monitor = Monitor()
    monitor.begin(begin)
    for step in steps:
        label, result, letters = step.split()
        monitor.follow(LABELS[label], ActionResult(result), state(letters))
    return monitor


FORESEEN = [
    ("grasp-left success Fr-", "insert-left success rri"),
    (
        "grasp-left success Fr-",
        "insert-left jammed Fr-",
        "swap-left-to-right success rF-",
        "insert-right success rri",
    ),
    ("insert-left not_allowed rrs", "grasp-right success rF-"),
    ("grasp-right success rF-", "grasp-left not_allowed rF-"),
    ("grasp-left not_grasped ars", "grasp-left success Fr-"),
    ("grasp-left not_reached ars", "grasp-right success aF-"),
    (
        "grasp-left lost rr-",
        "grasp-left not_seen rr-",
        "swap-right-to-left not_allowed rr-",
    ),
    ("grasp-left success Fr-", "swap-left-to-right not_grasped Fr-"),
    ("grasp-left success Fr-", "swap-left-to-right not_reached rA-"),
    ("grasp-left success Fr-", "insert-left success rri", "grasp-left not_seen rri"),
]


@pytest.mark.parametrize("steps", FORESEEN)
def test_what_is_foreseen_is_followed(steps):
    monitor = follow(*steps)
    assert monitor.predicates == state(steps[-1].split()[2])
    started = [step for step in steps if "not_allowed" not in step]
    assert len(monitor.word) == 1 + 2 * len(started)


UNFORESEEN = {
    "the wrong hand holds": ("grasp-left success rF-",),
    "a grasp that succeeded holds nothing": ("grasp-left success rrs",),
    "success short of the place in front": ("grasp-left success Ar-",),
    "the jar is still seen when it is held": ("grasp-left success Frs",),
    "the other arm has moved": ("grasp-left success Fa-",),
    "an insertion without a jar": ("insert-left success rri",),
    "a grasp that jams": ("grasp-left jammed Fr-",),
    "not seen although it was": ("grasp-left not_seen rrs",),
    "a refusal that moved something": ("insert-left not_allowed ars",),
    "both hands hold": ("grasp-left success Fr-", "swap-left-to-right success FF-"),
    "a giver that stays in front": (
        "grasp-left success Fr-",
        "swap-left-to-right success fF-",
    ),
    "a dangerous action was run": (
        "grasp-left success Fr-",
        "grasp-left not_grasped rr-",
    ),
    "a lost jar comes back": ("grasp-left lost rr-", "grasp-right success rF-"),
    "an insertion forgotten": (
        "grasp-left success Fr-",
        "insert-left success rri",
        "grasp-left not_seen rr-",
    ),
    "jammed, and the jar gone": ("grasp-left success Fr-", "insert-left jammed rr-"),
}


@pytest.mark.parametrize("steps", UNFORESEEN.values(), ids=UNFORESEEN.keys())
def test_what_is_not_foreseen_is_raised_and_named(steps):
    follow(*steps[:-1])
    with pytest.raises(UnforeseenEvent) as raised:
        follow(*steps)
    said = str(raised.value)
    label, _, letters = steps[-1].split()
    assert str(state(letters)) in said or f"start {label}" in said
    assert "\n" not in said


def test_a_trial_begins_with_arms_at_rest_whatever_was_before():
    monitor = follow("grasp-left success Fr-")
    monitor.begin(NOTHING_SEEN)
    assert monitor.predicates == NOTHING_SEEN
    assert len(monitor.word) == 1
    for letters in ("ars", "Fr-", "rri", "fr-"):
        with pytest.raises(UnforeseenEvent, match="look"):
            monitor.begin(state(letters))
