"""The tables of effects and the constraints, held against what is written by hand."""

import pytest
from states import mirrored, state

from prospect_mj.actions.action import Action
from prospect_mj.supervisor.constraints import violated
from prospect_mj.supervisor.effects import EFFECTS, can_change, can_start, outcomes
from prospect_mj.supervisor.plant import is_marked
from prospect_mj.supervisor.predicates import PRESENTED, Jar, carrying, every_state

BY_HAND = {
    (Action.GRASP_LEFT, "rrs"): {
        "success Fr-",
        "not_grasped rrs",
        "not_grasped ars",
        "not_reached rrs",
        "not_reached ars",
        "not_reached Fr-",
        "not_reached Ar-",
        "lost rr-",
        "lost ar-",
    },
    (Action.GRASP_LEFT, "rr-"): {"not_seen rr-"},
    (Action.GRASP_LEFT, "aai"): {"not_seen aai"},
    (Action.SWAP_LEFT_TO_RIGHT, "Fr-"): {
        "success rF-",
        "success aF-",
        "not_grasped Fr-",
        "not_grasped Fa-",
        "not_reached Fr-",
        "not_reached Fa-",
        "not_reached rF-",
        "not_reached aF-",
        "not_reached rA-",
        "not_reached aA-",
        "lost rr-",
        "lost ra-",
        "lost ar-",
        "lost aa-",
    },
    (Action.SWAP_LEFT_TO_RIGHT, "rF-"): {"not_allowed rF-"},
    (Action.INSERT_LEFT, "Fa-"): {
        "success rai",
        "success aai",
        "jammed Fa-",
        "not_reached Fa-",
        "not_reached Aa-",
        "lost ra-",
        "lost aa-",
    },
    (Action.INSERT_LEFT, "rrs"): {"not_allowed rrs"},
    # The left hand holds, and the right one goes for the same jar.
    (Action.GRASP_RIGHT, "Fr-"): {
        "not_seen Fr-",
        "success FF-",
        "success fF-",
        "not_grasped Fr-",
        "not_grasped fr-",
        "not_grasped Fa-",
        "not_grasped fa-",
        "not_reached Fr-",
        "not_reached fr-",
        "not_reached Fa-",
        "not_reached fa-",
        "not_reached FF-",
        "not_reached fF-",
        "not_reached FA-",
        "not_reached fA-",
        "lost Fr-",
        "lost fr-",
        "lost Fa-",
        "lost fa-",
    },
    # The left hand holds, and is opened to grasp.
    (Action.GRASP_LEFT, "Fr-"): {
        "not_seen Fr-",
        "success Fr-",
        "not_grasped Rr-",
        "not_grasped rr-",
        "not_grasped Ar-",
        "not_grasped ar-",
        "not_reached Rr-",
        "not_reached rr-",
        "not_reached Ar-",
        "not_reached ar-",
        "not_reached Fr-",
        "lost rr-",
        "lost ar-",
    },
}


def written(word):
    result, letters = word.split()
    return result, state(letters)


@pytest.mark.parametrize(
    ("action", "letters"), BY_HAND, ids=lambda x: getattr(x, "label", x)
)
def test_outcomes(action, letters):
    found = outcomes(action, state(letters))
    assert len(found) == len(set(found))
    assert set(found) == {written(word) for word in BY_HAND[action, letters]}


REFLECTED = {action: Action(action ^ 1) for action in Action}


@pytest.mark.parametrize("action", Action, ids=lambda action: action.label)
def test_left_mirrors_right(action):
    for here in every_state():
        there = {(r, mirrored(s)) for r, s in outcomes(action, here)}
        assert set(outcomes(REFLECTED[action], mirrored(here))) == there


def test_every_action_can_end_somehow_in_every_state():
    assert set(EFFECTS) == set(Action)
    assert len(set(every_state())) == 6 * 6 * 3
    for here in every_state():
        for action in Action:
            assert outcomes(action, here)


def test_a_swap_and_an_insertion_need_the_jar_in_their_hand():
    able = {a.label for a in Action if can_start(a, carrying("right"))}
    assert able == {"grasp-left", "grasp-right", "swap-right-to-left", "insert-right"}
    assert {a for a in Action if can_start(a, PRESENTED)} == {0, 1}


def test_what_is_of_no_use_changes_no_predicate():
    assert {a for a in Action if can_change(a, PRESENTED)} == {0, 1}
    assert not any(can_change(a, state("rr-")) for a in Action)
    assert not any(can_change(a, state("ari")) for a in Action)


BOTH = "both hands pull on one jar"
OPEN = "an open hand over a held jar"
ARMS = "two arms in one workspace"


@pytest.mark.parametrize(
    ("letters", "names"),
    [
        ("rrs", ()),
        ("ars", ()),
        ("Fr-", ()),
        ("Fa-", ()),
        ("aA-", ()),
        ("fr-", ()),
        ("rri", ()),
        ("FF-", (BOTH, ARMS)),
        ("FA-", (BOTH,)),
        ("AA-", (BOTH,)),
        ("Rr-", (OPEN,)),
        ("aR-", (OPEN,)),
        ("Af-", (OPEN,)),
        ("Ff-", (OPEN, ARMS)),
        ("ffs", (ARMS,)),
        ("RR-", (BOTH, OPEN)),
    ],
)
def test_constraints(letters, names):
    assert violated(state(letters)) == names
    assert violated(mirrored(state(letters))) == names


def test_where_a_trial_may_end():
    for here in every_state():
        given_up = here.jar is Jar.UNKNOWN and not here.holders
        assert is_marked(here) == (here.jar is Jar.INSERTED or given_up)
