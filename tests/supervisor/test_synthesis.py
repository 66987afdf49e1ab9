"""Synthesis against textbook cases, and against brute force on random automata."""

from dataclasses import replace
from itertools import chain, combinations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from prospect_mj.errors import InvalidChoice, InvalidValue
from prospect_mj.supervisor.automaton import Automaton
from prospect_mj.supervisor.synthesis import Cause, synthesise

CONTROLLABLE = ("a", "b")
UNCONTROLLABLE = ("u", "v")


def automaton(transitions, marked, initial=0):
    ends = {end for row in transitions.values() for end in row.values()}
    return Automaton(
        frozenset(transitions) | ends | {initial},
        frozenset(CONTROLLABLE),
        transitions,
        initial,
        frozenset(marked),
    )


def is_empty(found):
    """Whether no supervisor can do it."""
    return found.plant.initial not in found.kept


def test_what_leads_to_a_forbidden_state_by_itself_is_not_begun():
    """0 -a-> 1 -u-> 2 -v-> 3, and 3 is forbidden; b leads home."""
    plant = automaton({0: {"a": 1, "b": 4}, 1: {"u": 2}, 2: {"v": 3}}, {0, 4})
    found = synthesise(plant, [3])
    assert found.kept == {0, 4}
    assert found.disabled == {(0, "a"): (("u", "v"), 3, Cause.FORBIDDEN)}
    assert found.automaton.transitions[0] == {"b": 4}


def test_a_controllable_way_into_a_forbidden_state_is_cut_at_its_end():
    plant = automaton({0: {"a": 1}, 1: {"a": 2, "u": 0}}, {0})
    found = synthesise(plant, [2])
    assert found.kept == {0, 1}
    assert found.disabled == {(1, "a"): ((), 2, Cause.FORBIDDEN)}


def test_what_leads_into_a_dead_end_is_not_begun():
    plant = automaton({0: {"a": 1, "b": 2}, 1: {"u": 1}, 2: {"u": 0}}, {0})
    found = synthesise(plant, [])
    assert found.disabled == {(0, "a"): ((), 1, Cause.BLOCKING)}


def test_blocking_and_uncontrollable_removals_take_turns():
    """With 3 forbidden, 2 can't reach a mark; then 1 must go, which slips into 2."""
    plant = automaton(
        {0: {"a": 1, "b": 4}, 1: {"u": 2, "b": 4}, 2: {"a": 3}, 3: {"a": 4}}, {4}
    )
    found = synthesise(plant, [3])
    assert found.kept == {0, 4}
    assert found.reason(1) == (("u",), 2, Cause.BLOCKING)


def test_an_unsafe_beginning_leaves_nothing():
    plant = automaton({0: {"u": 1}}, {0, 1})
    found = synthesise(plant, [1])
    assert is_empty(found)
    with pytest.raises(InvalidValue):
        _ = found.automaton


def test_a_failure_that_ends_in_a_marked_state_is_no_way_out():
    """From 1 only the failure u leads to a mark: non-blocking, but hopeless."""
    plant = automaton({0: {"a": 1, "b": 2}, 1: {"u": 2}}, {2})
    assert synthesise(plant, []).kept == {0, 1, 2}
    hopeful = synthesise(plant, [], progress=["a", "b", "v"])
    assert hopeful.kept == {0, 2}
    assert hopeful.disabled == {(0, "a"): ((), 1, Cause.BLOCKING)}


def test_an_unknown_forbidden_state_is_refused():
    with pytest.raises(InvalidChoice, match="forbidden state is 7"):
        synthesise(automaton({0: {}}, {0}), [7])


@st.composite
def problems(draw):
    """A plant of up to five states, what is forbidden, and what counts as progress."""
    n = draw(st.integers(1, 5))
    state = st.integers(0, n - 1)
    events = st.sampled_from(CONTROLLABLE + UNCONTROLLABLE)
    rows = draw(st.dictionaries(state, st.dictionaries(events, state, max_size=3)))
    subsets = st.frozensets(state)
    plant = Automaton(
        frozenset(range(n)),
        frozenset(CONTROLLABLE),
        rows,
        draw(state),
        draw(subsets),
    )
    progress = draw(st.none() | st.frozensets(events))
    return plant, draw(subsets), progress


def closure(start, edges):
    """States that `edges` (source, target) lead to; the plainest search there is."""
    found, before = set(start), -1
    while len(found) > before:
        before = len(found)
        found |= {target for source, target in edges if source in found}
    return found


def is_good(plant, edges, start, forbidden, progress):
    """Whether these transitions, from `start`, are safe and always can be completed."""
    reach = closure({start}, {(s, t) for s, _, t in edges})
    back = {(t, s) for s, e, t in edges if progress is None or e in progress}
    return not reach & forbidden and reach <= closure(plant.marked, back)


def best_by_brute_force(plant, start, forbidden, progress):
    """All that any good choice of disabled transitions lets happen, or None."""
    edges = {(s, e, t) for s, row in plant.transitions.items() for e, t in row.items()}
    choices = [edge for edge in edges if edge[1] in plant.controllable]
    allowed = None
    for disabled in chain.from_iterable(
        combinations(choices, k) for k in range(len(choices) + 1)
    ):
        left = edges - set(disabled)
        if is_good(plant, left, start, forbidden, progress):
            reach = closure({start}, {(s, t) for s, _, t in left})
            allowed = (allowed or set()) | {edge for edge in left if edge[0] in reach}
    return allowed


@settings(max_examples=300, deadline=None)
@given(problems())
def test_it_allows_exactly_what_some_good_supervisor_allows(problem):
    """Supremal: the union over all controllable, safe and non-blocking choices."""
    plant, forbidden, progress = problem
    found = synthesise(plant, forbidden, progress)
    best = best_by_brute_force(plant, plant.initial, forbidden, progress)
    assert is_empty(found) == (best is None)
    if best is not None:
        supervised = found.automaton
        reach = supervised.reachable()
        rows = supervised.transitions.items()
        let = {(s, e, t) for s, row in rows if s in reach for e, t in row.items()}
        assert let == best


@settings(max_examples=150, deadline=None)
@given(problems())
def test_a_state_is_kept_exactly_if_a_trial_could_begin_there(problem):
    plant, forbidden, progress = problem
    kept = synthesise(plant, forbidden, progress).kept
    for state in plant.states:
        best = best_by_brute_force(plant, state, forbidden, progress)
        assert (state in kept) == (best is not None)


@settings(max_examples=200, deadline=None)
@given(problems())
def test_every_disabled_transition_has_a_true_reason(problem):
    plant, forbidden, progress = problem
    found = synthesise(plant, forbidden, progress)
    for (state, event), reason in found.disabled.items():
        assert event in plant.controllable
        assert not set(reason.path) & plant.controllable
        first = plant.transitions[state][event]
        assert plant.run(reason.path, first) == (reason.state, len(reason.path), None)
        assert (reason.cause is Cause.FORBIDDEN) == (reason.state in forbidden)


@settings(max_examples=100, deadline=None)
@given(problems())
def test_supervising_twice_changes_nothing(problem):
    plant, forbidden, progress = problem
    once = synthesise(plant, forbidden, progress)
    if not is_empty(once):
        again = synthesise(once.automaton, forbidden & once.kept, progress)
        assert again.kept == once.kept
        assert not again.disabled
        assert replace(once.automaton, marked=frozenset()).reachable() <= once.kept
