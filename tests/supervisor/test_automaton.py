"""Automata: reach, co-reach and words, on one small enough to see through."""

import pytest

from prospect_mj.errors import InvalidChoice, InvalidValue
from prospect_mj.supervisor.automaton import Automaton

# A machine that works and may break down; a broken one can be mended, or scrapped.
MACHINE = Automaton(
    states=frozenset({"idle", "busy", "broken", "scrap", "unused"}),
    controllable=frozenset({"start", "mend", "scrap it"}),
    transitions={
        "idle": {"start": "busy"},
        "busy": {"finish": "idle", "break": "broken"},
        "broken": {"mend": "idle", "scrap it": "scrap"},
        "unused": {"finish": "idle"},
    },
    initial="idle",
    marked=frozenset({"idle"}),
)


def test_events_are_all_that_can_occur():
    assert MACHINE.events == {"start", "mend", "scrap it", "finish", "break"}


def test_reach_and_coreach():
    assert MACHINE.reachable() == {"idle", "busy", "broken", "scrap"}
    assert MACHINE.reachable("scrap") == {"scrap"}
    assert MACHINE.coreachable() == {"idle", "busy", "broken", "unused"}


def test_coreach_by_some_events_or_through_some_states_only():
    assert MACHINE.coreachable(["start", "finish"]) == {"idle", "busy", "unused"}
    within = {"idle", "broken", "unused"}
    assert MACHINE.coreachable(within=within) == within
    assert MACHINE.coreachable(within={"busy", "broken"}) == set()


def test_a_word_is_followed_up_to_the_event_that_cannot_be():
    assert MACHINE.run(["start", "break", "mend"]) == ("idle", 3, None)
    assert MACHINE.run(["start", "mend", "finish"]) == ("busy", 1, "mend")
    assert MACHINE.run(["scrap it"], start="broken") == ("scrap", 1, None)
    assert MACHINE.run(["start"], start="scrap") == ("scrap", 0, "start")
    assert MACHINE.run([]) == ("idle", 0, None)


def test_restriction_keeps_transitions_among_the_kept():
    part = MACHINE.restricted({"idle", "busy"})
    assert part.transitions == {"idle": {"start": "busy"}, "busy": {"finish": "idle"}}
    with pytest.raises(InvalidValue, match="initial"):
        MACHINE.restricted({"busy"})


def test_transitions_can_be_taken_out():
    careful = MACHINE.without(lambda state, event: event == "scrap it")
    assert "scrap" not in careful.reachable()
    assert MACHINE.transitions["broken"] == {"mend": "idle", "scrap it": "scrap"}


@pytest.mark.parametrize(
    ("wrong", "named"),
    [
        ({"initial": 9}, "initial state is 9"),
        ({"marked": frozenset({9})}, "marked state is 9"),
        ({"transitions": {9: {}}}, "state with transitions is 9"),
        ({"transitions": {0: {"a": 9}}}, "next state is 9"),
    ],
)
def test_states_that_do_not_exist_are_refused(wrong, named):
    parts = {
        "states": frozenset({0}),
        "controllable": frozenset(),
        "transitions": {},
        "initial": 0,
        "marked": frozenset(),
    }
    with pytest.raises(InvalidChoice, match=named):
        Automaton(**parts | wrong)


@pytest.mark.parametrize(
    "ask", [MACHINE.enabled, MACHINE.reachable, lambda s: MACHINE.run(["start"], s)]
)
def test_unknown_states_are_refused(ask):
    with pytest.raises(InvalidChoice, match="state is 'gone'"):
        ask("gone")
