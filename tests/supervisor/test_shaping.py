"""The schedule of shaping: what is read, what is refused, when it is lifted."""

import pytest

from prospect_mj.actions.action import Action
from prospect_mj.errors import InvalidChoice, InvalidValue
from prospect_mj.supervisor.predicates import PRESENTED, carrying
from prospect_mj.supervisor.shaping import Schedule
from prospect_mj.supervisor.supervisor import MODES, Supervisor

NO_SWAPS = ("swap-left-to-right:200", "swap-right-to-left:50")


def test_a_schedule_is_read():
    schedule = Schedule.parse(NO_SWAPS)
    assert schedule.entries == (
        (Action.SWAP_LEFT_TO_RIGHT, 200),
        (Action.SWAP_RIGHT_TO_LEFT, 50),
    )
    assert schedule.phases == (0, 50, 200)


@pytest.mark.parametrize("mode", MODES)
def test_it_is_lifted_action_by_action_at_trial_n(mode):
    shaped, plain = Supervisor(mode, NO_SWAPS), Supervisor(mode)
    for side, action, n in (
        ("left", Action.SWAP_LEFT_TO_RIGHT, 200),
        ("right", Action.SWAP_RIGHT_TO_LEFT, 50),
    ):
        here = carrying(side)
        assert plain.choice_set(here)[action]
        for trial in (0, n - 1):
            assert not shaped.choice_set(here, trial)[action]
        for trial in (n, n + 1, 10**6):
            assert shaped.choice_set(here, trial)[action]


def test_nothing_else_changes():
    shaped = Supervisor("safe", NO_SWAPS).choice_set(carrying("left"), 0)
    assert tuple(shaped) == (0, 0, 0, 0, 1, 1)


def test_shaping_does_not_change_what_can_run():
    shaped = Supervisor("none", NO_SWAPS)
    assert shaped.may_run(Action.SWAP_LEFT_TO_RIGHT, carrying("left"))


def test_zero_trials_disable_nothing():
    assert Supervisor("none", ("grasp-left:0",)).choice_set(PRESENTED, 0).all()


@pytest.mark.parametrize("mode", MODES)
@pytest.mark.parametrize(
    ("entry", "kind", "named"),
    [
        ("push-left:5", InvalidChoice, "'push-left'; valid: grasp-left, "),
        ("GRASP_LEFT:5", InvalidChoice, "'GRASP_LEFT'"),
        (":5", InvalidChoice, "''"),
        ("grasp-left:-1", InvalidValue, "grasp-left in shaping is '-1'"),
        ("grasp-left:1.5", InvalidValue, "'1.5'; expected 0 or more"),
        ("grasp-left:", InvalidValue, "''; expected 0 or more"),
        ("grasp-left:²", InvalidValue, "0 or more"),
        ("grasp-left", InvalidValue, "<action>:<trials>"),
        ("grasp-left:1:2", InvalidValue, "<action>:<trials>"),
        (3, InvalidValue, "<action>:<trials>"),
    ],
)
def test_what_cannot_be_read_is_named(mode, entry, kind, named):
    with pytest.raises(kind) as refused:
        Supervisor(mode, ("insert-left:3", entry))
    assert named in str(refused.value)
    assert "\n" not in str(refused.value)


def test_an_action_named_twice_is_refused():
    with pytest.raises(InvalidValue, match="each action once"):
        Supervisor("none", ("grasp-left:3", "grasp-left:4"))


ALL = tuple(f"{action.label}:9" for action in Action)
EMPTY = [
    ("none", ALL, "right empty at rest, jar"),
    ("safe", ALL, "right empty at rest, jar"),
    ("productive", ("grasp-left:5", "grasp-right:9"), "jar seen"),
    ("productive", ("swap-left-to-right:1", "insert-left:1"), "left holds"),
    # Once the left grasp is back, a hand can hold that has nothing left to do.
    (
        "productive",
        (
            "grasp-left:5",
            "swap-left-to-right:20",
            "swap-right-to-left:20",
            "insert-left:15",
        ),
        "left holds in front, right empty at rest, jar unknown (trial 5)",
    ),
]


@pytest.mark.parametrize(("mode", "shaping", "where"), EMPTY)
def test_a_schedule_that_leaves_no_choice_somewhere_is_refused(mode, shaping, where):
    with pytest.raises(InvalidValue) as refused:
        Supervisor(mode, shaping)
    said = str(refused.value)
    assert f"something to choose in mode {mode} when" in said
    assert where in said
    assert " ".join(shaping) in said
    assert "\n" not in said


def test_what_only_an_unreachable_state_would_lack_is_no_reason_to_refuse():
    """No right-hand grasp and no swap: the right hand never holds anything."""
    shaping = (
        "grasp-right:50",
        "swap-left-to-right:50",
        "swap-right-to-left:50",
        "insert-right:50",
    )
    shaped = Supervisor("productive", shaping)
    assert tuple(shaped.choice_set(carrying("left"), 0)) == (0, 0, 0, 0, 1, 0)
    # The same for longer than the grasp is disabled would leave it without a choice.
    with pytest.raises(InvalidValue, match="right holds"):
        Supervisor("productive", ("grasp-right:5", *shaping[1:]))
